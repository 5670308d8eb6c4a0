//! Another program from which files are dragged, by the XDND protocol, version 5
//! (<https://freedesktop.org/wiki/Specifications/XDND/>).

use crate::client::Client;
use std::path::Path;
use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    AtomEnum, ClientMessageEvent, ConnectionExt as _, EventMask, Window,
};
use x11rb::wrapper::ConnectionExt as _;

/// The version that is spoken, in the first message's highest byte.
const VERSION: u32 = 5 << 24;

/// A drag over a window.
pub(crate) struct Drag {
    client: Client,
    target: Window,
    uris: String,
}

impl Drag {
    /// Takes a file to the window in `parent` that takes files.
    pub(crate) fn begin(parent: Window, file: &Path) -> Self {
        let client = Client::new();
        let target = aware(&client, parent).expect("a window takes files");
        client.own("XdndSelection");
        let drag = Self {
            client,
            target,
            uris: format!("file://{}\r\n", file.display()),
        };
        let kind = drag.client.atom("text/uri-list");
        drag.say("XdndEnter", [VERSION, kind, 0, 0]);
        drag
    }

    /// Goes to a place of the screen; whether the window would take the file there.
    pub(crate) fn hover(&self, [x, y]: [i16; 2]) -> bool {
        let [x, y] = [x, y].map(|pixels| u32::try_from(pixels).unwrap());
        let place = x << 16 | y;
        let copy = self.client.atom("XdndActionCopy");
        self.say("XdndPosition", [0, place, 0, copy]);
        self.answer("XdndStatus")[1] & 1 == 1
    }

    /// Lets the file go; whether the window has taken it.
    pub(crate) fn drop_here(self) -> bool {
        self.say("XdndDrop", [0; 4]);
        self.answer("XdndFinished")[1] & 1 == 1
    }

    /// Takes the file away again.
    pub(crate) fn leave(self) {
        self.say("XdndLeave", [0; 4]);
        // As in `Client::hand_over`.
        self.client.connection.sync().unwrap();
    }

    fn say(&self, what: &str, [first, second, third, fourth]: [u32; 4]) {
        let kind = self.client.atom(what);
        let data = [self.client.window, first, second, third, fourth];
        let message = ClientMessageEvent::new(32, self.target, kind, data);
        let connection = &self.client.connection;
        connection
            .send_event(false, self.target, EventMask::NO_EVENT, message)
            .unwrap();
        connection.flush().unwrap();
    }

    /// Hands the file's name over when it is asked for, until the window answers so.
    fn answer(&self, what: &str) -> [u32; 5] {
        let kind = self.client.atom(what);
        self.client.until(|event| match event {
            Event::SelectionRequest(request) => {
                self.client.hand_over(request, self.uris.as_bytes());
                None
            }
            Event::ClientMessage(message) if message.type_ == kind => {
                Some(message.data.as_data32())
            }
            _ => None,
        })
    }
}

/// The window within another that says it takes files.
fn aware(client: &Client, parent: Window) -> Option<Window> {
    let connection = &client.connection;
    let tree = connection.query_tree(parent).unwrap().reply().unwrap();
    let property = client.atom("XdndAware");
    tree.children.into_iter().find(|child| {
        let asked = connection.get_property(false, *child, property, AtomEnum::ATOM, 0, 1);
        let found = asked.unwrap().reply().unwrap();
        found.value_len == 1
    })
}
