//! An X screen with one window, a pointer that clicks, and a camera.

use std::collections::HashSet;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use x11rb::connection::Connection as _;
use x11rb::protocol::xfixes::ConnectionExt as _;
use x11rb::protocol::xproto::{
    AtomEnum, BUTTON_PRESS_EVENT, BUTTON_RELEASE_EVENT, ConnectionExt as _, CreateWindowAux,
    ImageFormat, KEY_PRESS_EVENT, KEY_RELEASE_EVENT, MOTION_NOTIFY_EVENT, PropMode, WindowClass,
};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;

/// The screen.
pub(crate) struct Screen {
    connection: RustConnection,
    root: u32,
    window: u32,
    /// Width and height in pixels.
    size: [u16; 2],
}

/// What the camera saw.
#[derive(Debug, PartialEq)]
pub(crate) struct Shot {
    size: [u16; 2],
    rgb: Vec<u8>,
}

impl Screen {
    /// The one that `DISPLAY` names.
    pub(crate) fn open() -> Self {
        let (connection, number) = x11rb::connect(None).unwrap();
        let root = &connection.setup().roots[number];
        let size = [root.width_in_pixels, root.height_in_pixels];
        let root = root.root;
        let window = connection.generate_id().unwrap();
        let [width, height] = size;
        let look = CreateWindowAux::new().background_pixel(0);
        let class = WindowClass::INPUT_OUTPUT;
        connection
            .create_window(0, window, root, 0, 0, width, height, 0, class, 0, &look)
            .unwrap();
        connection.map_window(window).unwrap();
        connection.sync().unwrap();
        Self {
            connection,
            root,
            window,
            size,
        }
    }

    /// The window that editors are put into.
    pub(crate) fn window(&self) -> u32 {
        self.window
    }

    /// Tells programs of how many dots there are to an inch; 96 make a pixel to a point.
    pub(crate) fn set_dpi(&self, dpi: u32) {
        let resources = format!("Xft.dpi:\t{dpi}\n");
        let (property, string) = (AtomEnum::RESOURCE_MANAGER, AtomEnum::STRING);
        self.connection
            .change_property8(
                PropMode::REPLACE,
                self.root,
                property,
                string,
                resources.as_bytes(),
            )
            .unwrap();
        self.connection.sync().unwrap();
    }

    /// Moves the pointer and clicks.
    pub(crate) fn click(&self, [x, y]: [i16; 2]) {
        for (kind, detail) in [
            (MOTION_NOTIFY_EVENT, 0),
            (BUTTON_PRESS_EVENT, 1),
            (BUTTON_RELEASE_EVENT, 1),
        ] {
            self.fake(kind, detail, [x, y]);
        }
    }

    /// Moves the pointer.
    pub(crate) fn point(&self, [x, y]: [i16; 2]) {
        self.fake(MOTION_NOTIFY_EVENT, 0, [x, y]);
    }

    /// Presses keys together, by the codes that Linux gives them plus 8, and lets them go.
    pub(crate) fn press(&self, keys: &[u8]) {
        for key in keys {
            self.fake(KEY_PRESS_EVENT, *key, [0, 0]);
        }
        for key in keys.iter().rev() {
            self.fake(KEY_RELEASE_EVENT, *key, [0, 0]);
        }
    }

    fn fake(&self, kind: u8, detail: u8, [x, y]: [i16; 2]) {
        self.connection
            .xtest_fake_input(kind, detail, 0, self.root, x, y, 0)
            .unwrap();
        self.connection.sync().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(50));
    }

    /// A number that changes with the pointer's shape.
    pub(crate) fn pointer(&self) -> u32 {
        let fixes = &self.connection;
        fixes.xfixes_query_version(4, 0).unwrap().reply().unwrap();
        let asked = fixes.xfixes_get_cursor_image().unwrap();
        asked.reply().unwrap().cursor_serial
    }

    /// Takes a picture of the window and of what is in it.
    pub(crate) fn shoot(&self) -> Shot {
        let [width, height] = self.size;
        let format = ImageFormat::Z_PIXMAP;
        let image = self
            .connection
            .get_image(format, self.root, 0, 0, width, height, u32::MAX)
            .unwrap()
            .reply()
            .unwrap();
        let rgb = image.data.chunks_exact(4);
        Shot {
            size: self.size,
            rgb: rgb.flat_map(|bgr| [bgr[2], bgr[1], bgr[0]]).collect(),
        }
    }
}

impl Shot {
    /// How many colours there are.
    pub(crate) fn colours(&self) -> usize {
        self.rgb.chunks_exact(3).collect::<HashSet<_>>().len()
    }

    /// Whether something is drawn at a place.
    pub(crate) fn is_drawn(&self, [x, y]: [u16; 2]) -> bool {
        let at = usize::from(y) * usize::from(self.size[0]) + usize::from(x);
        self.rgb[3 * at..][..3] != [0; 3]
    }

    /// Whether there is the same at a place as in another picture.
    pub(crate) fn is_as_at(&self, other: &Self, [x, y]: [u16; 2]) -> bool {
        let at = 3 * (usize::from(y) * usize::from(self.size[0]) + usize::from(x));
        self.rgb[at..][..3] == other.rgb[at..][..3]
    }

    /// Writes a PNG.
    pub(crate) fn save(&self, path: &Path) {
        let file = BufWriter::new(File::create(path).unwrap());
        let [width, height] = self.size.map(u32::from);
        let mut encoder = png::Encoder::new(file, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&self.rgb).unwrap();
    }
}
