//! A client of MTS-ESP: what the session's master says of each key.

use super::MtsError;
use super::library::{Functions, Table, installed};
use std::env;
use std::ffi::c_char;
use std::path::Path;
use std::ptr::NonNull;
use std::sync::atomic::{AtomicU8, Ordering};

/// Longest name of a scale that is read, in bytes.
const MAX_NAME_LEN: usize = 255;

/// A connection to MTS-ESP, by which one plug-in of a session, the master, tunes all others, its
/// clients. Made and dropped off the audio thread.
///
/// What it says may change at any time, so it is to be asked at every strike, and may be asked while
/// a body rings. Masters may tune MIDI channels differently; a body belongs to a key on whatever
/// channel, and follows the tuning of all channels in common.
#[derive(Debug)]
pub struct MtsClient {
    functions: Functions,
    table: NonNull<Table>,
}

#[expect(unsafe_code, reason = "a table that any thread may read")]
// SAFETY: any thread may call the library's functions, and the table is only read, as atomics.
unsafe impl Send for MtsClient {}

#[expect(unsafe_code, reason = "a table that any thread may read")]
// SAFETY: as above.
unsafe impl Sync for MtsClient {}

impl MtsClient {
    /// Connects through the library of this computer; `None` if MTS-ESP is not installed.
    ///
    /// # Errors
    ///
    /// If the library is there but cannot be used.
    pub fn connect() -> Result<Option<Self>, MtsError> {
        installed(env::consts::OS, |name| env::var_os(name))
            .filter(|path| path.is_file())
            .map(|path| Self::open(&path))
            .transpose()
    }

    /// Connects through the library at `path`.
    ///
    /// # Errors
    ///
    /// If there is no library that can be used.
    pub fn open(path: &Path) -> Result<Self, MtsError> {
        let functions = Functions::open(path)?;
        let table = functions.table().ok_or_else(|| MtsError::Table {
            path: path.to_path_buf(),
        })?;
        // SAFETY: the function has this signature in every version of the library.
        #[expect(unsafe_code, reason = "a function of a C library")]
        unsafe {
            (functions.register_client)();
        }
        Ok(Self { functions, table })
    }

    /// Whether there is a master in the session. For any thread.
    #[must_use]
    pub fn has_master(&self) -> bool {
        // SAFETY: the function has this signature in every version of the library.
        #[expect(unsafe_code, reason = "a function of a C library")]
        unsafe {
            (self.functions.has_master)()
        }
    }

    /// The pitch in Hz that the master gives key 0…127. `None` if there is no master, or what its
    /// table holds is no frequency: the key then keeps its own pitch. For any thread: neither
    /// allocates nor waits.
    #[must_use]
    pub fn tuning(&self, key: u8) -> Option<f64> {
        if !self.has_master() {
            return None;
        }
        // SAFETY: the table is aligned and stays where it is while the library is open. Relaxed
        // loads of 8 bytes are sound even of memory that cannot be written.
        #[expect(unsafe_code, reason = "a table inside a C library")]
        let table = unsafe { self.table.as_ref() };
        let bits = table.get(usize::from(key))?.load(Ordering::Relaxed);
        let hz = f64::from_bits(bits);
        (hz.is_normal() && hz > 0.0).then_some(hz)
    }

    /// Whether the master wants key 0…127 on MIDI channel 0…15 (`None` if unknown) to be silent.
    /// For any thread.
    #[must_use]
    pub fn silences(&self, key: u8, channel: Option<u8>) -> bool {
        let unknown = c_char::from_ne_bytes([u8::MAX]);
        let channel = channel.map_or(unknown, |channel| c_char::from_ne_bytes([channel & 15]));
        let key = c_char::from_ne_bytes([key & 127]);
        // SAFETY: the function has this signature in every version of the library.
        #[expect(unsafe_code, reason = "a function of a C library")]
        let filtered = || unsafe { (self.functions.should_filter_note)(key, channel) };
        self.has_master() && filtered()
    }

    /// The name of the master's scale, to show; `None` if there is no master. Allocates, so not for
    /// the audio thread.
    #[must_use]
    pub fn scale_name(&self) -> Option<String> {
        if !self.has_master() {
            return None;
        }
        // SAFETY: the function has this signature in every version of the library.
        #[expect(unsafe_code, reason = "a function of a C library")]
        let start = unsafe { (self.functions.scale_name)() };
        let start = NonNull::new(start.cast_mut())?.cast::<AtomicU8>();
        // SAFETY: the text ends with 0, and no byte behind that is read. The master may change it
        // meanwhile.
        #[expect(unsafe_code, reason = "a text inside a C library")]
        let byte = |at| unsafe { start.add(at).as_ref() }.load(Ordering::Relaxed);
        let bytes: Vec<u8> = (0..MAX_NAME_LEN)
            .map(byte)
            .take_while(|byte| *byte != 0)
            .collect();
        Some(String::from_utf8_lossy(&bytes).into_owned())
    }
}

impl Drop for MtsClient {
    fn drop(&mut self) {
        // SAFETY: the client has registered.
        #[expect(unsafe_code, reason = "a function of a C library")]
        unsafe {
            (self.functions.deregister_client)();
        }
    }
}
