//! Another program on the screen, without anything to see.

use std::time::{Duration, Instant};
use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ConnectionExt as _, CreateWindowAux, EventMask, PropMode,
    SELECTION_NOTIFY_EVENT, SelectionNotifyEvent, SelectionRequestEvent, Window, WindowClass,
};
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;

/// No answer takes as long.
const PATIENCE: Duration = Duration::from_secs(20);

/// The program.
pub(crate) struct Client {
    pub(crate) connection: RustConnection,
    pub(crate) window: Window,
}

impl Client {
    /// On the screen that `DISPLAY` names.
    pub(crate) fn new() -> Self {
        let (connection, number) = x11rb::connect(None).unwrap();
        let root = connection.setup().roots[number].root;
        let window = connection.generate_id().unwrap();
        let (class, look) = (WindowClass::INPUT_ONLY, CreateWindowAux::new());
        connection
            .create_window(0, window, root, 0, 0, 1, 1, 0, class, 0, &look)
            .unwrap();
        connection.sync().unwrap();
        Self { connection, window }
    }

    /// The number of a name.
    pub(crate) fn atom(&self, name: &str) -> Atom {
        let asked = self.connection.intern_atom(false, name.as_bytes());
        asked.unwrap().reply().unwrap().atom
    }

    /// Says that a selection is here.
    pub(crate) fn own(&self, selection: &str) {
        let atom = self.atom(selection);
        self.connection
            .set_selection_owner(self.window, atom, x11rb::CURRENT_TIME)
            .unwrap();
        self.connection.sync().unwrap();
    }

    /// Waits for an event that tells something.
    pub(crate) fn until<T>(&self, told: impl Fn(&Event) -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            match self.connection.poll_for_event().unwrap() {
                Some(event) => {
                    if let Some(told) = told(&event) {
                        return told;
                    }
                }
                None => std::thread::sleep(Duration::from_millis(5)),
            }
            assert!(start.elapsed() < PATIENCE, "nobody answers");
        }
    }

    /// Gives what is asked for of a selection to whoever asks.
    pub(crate) fn hand_over(&self, request: &SelectionRequestEvent, content: &[u8]) {
        let connection = &self.connection;
        connection
            .change_property8(
                PropMode::REPLACE,
                request.requestor,
                request.property,
                request.target,
                content,
            )
            .unwrap();
        let answer = SelectionNotifyEvent {
            response_type: SELECTION_NOTIFY_EVENT,
            sequence: 0,
            time: request.time,
            requestor: request.requestor,
            selection: request.selection,
            target: request.target,
            property: request.property,
        };
        connection
            .send_event(false, request.requestor, EventMask::NO_EVENT, answer)
            .unwrap();
        // The screen forgets what a program that ends has said last.
        connection.sync().unwrap();
    }

    /// Serves a text as that of a selection that is here, until it has been asked for.
    pub(crate) fn lend(&self, text: &str) {
        let kind = self.atom("UTF8_STRING");
        self.until(|event| match event {
            Event::SelectionRequest(request) => {
                self.hand_over(request, text.as_bytes());
                (request.target == kind).then_some(())
            }
            _ => None,
        });
    }

    /// The text that is on the clipboard.
    pub(crate) fn clipboard(&self) -> String {
        let [from, kind, to] = ["CLIPBOARD", "UTF8_STRING", "IDIOPHONE_TEST"].map(|n| self.atom(n));
        self.connection
            .convert_selection(self.window, from, kind, to, x11rb::CURRENT_TIME)
            .unwrap();
        self.connection.flush().unwrap();
        self.until(|event| matches!(event, Event::SelectionNotify(_)).then_some(()));
        let any = AtomEnum::ANY;
        let asked = self
            .connection
            .get_property(true, self.window, to, any, 0, 1024);
        String::from_utf8(asked.unwrap().reply().unwrap().value).unwrap()
    }
}
