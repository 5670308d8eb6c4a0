//! Triangles to a file.

use super::super::Soup;
use std::fmt::Write;

/// The text of an OBJ file.
#[must_use]
pub fn write_obj(soup: &Soup) -> String {
    let mut text = String::new();
    for [x, y, z] in &soup.points {
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for object in &soup.objects {
        if !object.name.is_empty() {
            let _ = writeln!(text, "o {}", object.name);
        }
        for triangle in &soup.triangles[object.triangles.clone()] {
            let [a, b, c] = triangle.map(|i| i + 1);
            let _ = writeln!(text, "f {a} {b} {c}");
        }
    }
    text
}
