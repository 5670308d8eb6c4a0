//! The built plug-in in a host, and the physics against published tables.
