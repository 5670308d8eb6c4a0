//! The MTS-ESP library: the functions that clients use, as it exports them.

use super::MtsError;
use libloading::Library;
use std::ffi::{OsString, c_char};
use std::path::{Path, PathBuf};
use std::ptr::NonNull;
use std::sync::atomic::AtomicU64;

/// Bit patterns of the frequencies of keys 0…127 in Hz, which the master changes whenever it likes.
pub(super) type Table = [AtomicU64; 128];

/// The open library. Its functions may be called on any thread.
#[derive(Debug)]
pub(super) struct Functions {
    pub(super) register_client: unsafe extern "C" fn(),
    pub(super) deregister_client: unsafe extern "C" fn(),
    pub(super) has_master: unsafe extern "C" fn() -> bool,
    /// Key and channel, −1 for an unknown channel.
    pub(super) should_filter_note: unsafe extern "C" fn(c_char, c_char) -> bool,
    pub(super) scale_name: unsafe extern "C" fn() -> *const c_char,
    tuning_table: unsafe extern "C" fn() -> *const f64,
    /// Keeps the functions where they are.
    _library: Library,
}

impl Functions {
    /// Opens the library at `path`, which runs whatever it does when it is loaded.
    pub(super) fn open(path: &Path) -> Result<Self, MtsError> {
        // SAFETY: the library is trusted as every host and plug-in that uses MTS-ESP trusts it.
        #[expect(unsafe_code, reason = "loading a dynamic library")]
        let library = unsafe { Library::new(path) }.map_err(|error| MtsError::Load {
            path: path.to_path_buf(),
            error,
        })?;
        Ok(Self {
            register_client: function(&library, path, "MTS_RegisterClient")?,
            deregister_client: function(&library, path, "MTS_DeregisterClient")?,
            has_master: function(&library, path, "MTS_HasMaster")?,
            should_filter_note: function(&library, path, "MTS_ShouldFilterNote")?,
            scale_name: function(&library, path, "MTS_GetScaleName")?,
            tuning_table: function(&library, path, "MTS_GetTuningTable")?,
            _library: library,
        })
    }

    /// The table of frequencies, which stays where it is while the library is open.
    pub(super) fn table(&self) -> Option<NonNull<Table>> {
        // SAFETY: the function has this signature in every version of the library.
        #[expect(unsafe_code, reason = "a function of a C library")]
        let table = unsafe { (self.tuning_table)() };
        NonNull::new(table.cast::<Table>().cast_mut()).filter(|table| table.is_aligned())
    }
}

/// The function of a library by its name. `F` must be the type that it has there.
fn function<F: Copy>(library: &Library, path: &Path, name: &'static str) -> Result<F, MtsError> {
    // SAFETY: the callers give the types by which the clients of MTS-ESP know its functions.
    #[expect(unsafe_code, reason = "a function of a C library")]
    let symbol = unsafe { library.get::<F>(name.as_bytes()) };
    symbol
        .map(|symbol| *symbol)
        .map_err(|_| MtsError::Function {
            path: path.to_path_buf(),
            function: name,
        })
}

/// Where MTS-ESP's installer puts the library.
pub(super) fn installed(os: &str, variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    match os {
        "windows" => {
            let common = PathBuf::from(variable("CommonProgramFiles")?);
            Some(common.join("MTS-ESP").join("LIBMTS.dll"))
        }
        "macos" => Some("/Library/Application Support/MTS-ESP/libMTS.dylib".into()),
        _ => Some("/usr/local/lib/libMTS.so".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::installed;
    use std::path::Path;

    #[test]
    fn the_library_lies_where_its_installer_puts_it() {
        let none = |_: &str| None;
        let linux = installed("linux", none).unwrap();
        assert_eq!(linux, Path::new("/usr/local/lib/libMTS.so"));
        let macos = installed("macos", none).unwrap();
        assert!(macos.ends_with("MTS-ESP/libMTS.dylib"));
        assert_eq!(installed("windows", none), None);
        let common = |name: &str| (name == "CommonProgramFiles").then(|| "/Common Files".into());
        let windows = installed("windows", common).unwrap();
        assert_eq!(windows, Path::new("/Common Files/MTS-ESP/LIBMTS.dll"));
    }
}
