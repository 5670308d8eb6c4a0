//! Builds the stand-in for the library of MTS-ESP, and turns it.

use libloading::Library;
use std::ffi::{CStr, c_char, c_int};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Builds a library of its own for the test `name`; `None`, said out loud, without a C compiler.
pub(crate) fn build(name: &str, flags: &[&str]) -> Option<PathBuf> {
    // Cargo has a folder for integration tests only.
    let own = option_env!("CARGO_TARGET_TMPDIR").map(PathBuf::from);
    let folder = own.unwrap_or_else(std::env::temp_dir).join("idiophone-mts");
    std::fs::create_dir_all(&folder).unwrap();
    let library = folder.join(libloading::library_filename(name));
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mts/fake.c");
    for compiler in ["cc", "gcc", "clang"] {
        let mut command = Command::new(compiler);
        command.args(["-shared", "-fPIC"]).args(flags);
        match command.arg("-o").arg(&library).arg(&source).status() {
            Ok(status) => {
                assert!(status.success(), "{command:?}: {status}");
                return Some(library);
            }
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            Err(error) => panic!("{command:?}: {error}"),
        }
    }
    eprintln!("skipped {name}: there is no C compiler to build a library with");
    None
}

/// The same library from the master's side.
pub(crate) struct Fake(Library);

impl Fake {
    pub(crate) fn of(library: &Path) -> Self {
        // SAFETY: the library does nothing when it is loaded.
        #[expect(unsafe_code, reason = "loading a dynamic library")]
        Self(unsafe { Library::new(library) }.unwrap())
    }

    pub(crate) fn master(&self, is_there: bool) {
        // SAFETY: fake.c has the function with this signature.
        #[expect(unsafe_code, reason = "a function of a C library")]
        unsafe {
            self.function::<unsafe extern "C" fn(bool)>("fake_master")(is_there);
        }
    }

    pub(crate) fn tune(&self, key: u8, hz: f64) {
        // SAFETY: fake.c has the function with this signature.
        #[expect(unsafe_code, reason = "a function of a C library")]
        unsafe {
            self.function::<unsafe extern "C" fn(c_int, f64)>("fake_tune")(key.into(), hz);
        }
    }

    /// The text is read until it is replaced.
    pub(crate) fn name(&self, text: Option<&CStr>) {
        let text = text.map_or(std::ptr::null(), CStr::as_ptr);
        // SAFETY: fake.c has the function with this signature.
        #[expect(unsafe_code, reason = "a function of a C library")]
        unsafe {
            self.function::<unsafe extern "C" fn(*const c_char)>("fake_name")(text);
        }
    }

    pub(crate) fn clients(&self) -> c_int {
        // SAFETY: fake.c has the function with this signature.
        #[expect(unsafe_code, reason = "a function of a C library")]
        unsafe {
            self.function::<unsafe extern "C" fn() -> c_int>("fake_clients")()
        }
    }

    /// `F` must be the type that the function has in fake.c.
    fn function<F: Copy>(&self, name: &str) -> F {
        // SAFETY: the callers see to the type.
        #[expect(unsafe_code, reason = "a function of a C library")]
        let symbol = unsafe { self.0.get::<F>(name.as_bytes()) };
        *symbol.unwrap()
    }
}
