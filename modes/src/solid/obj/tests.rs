//! Files good and bad.

use super::*;

fn parse(text: &str) -> Result<ObjFile, ObjError> {
    parse_obj(text.as_bytes(), "a.obj", None)
}

#[test]
fn negative_indices_polygons_and_names_are_read() {
    let text = "mtllib missing.mtl\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n\
                o Glocke \u{e4}\nusemtl x\nf -4/1/1 -3//2 -2 \\\n-1\no B\nf 1 2 3\nl 1 2\n";
    let file = parse(text).unwrap();
    assert_eq!(file.soup.triangles.len(), 3);
    let names: Vec<&str> = file.soup.objects.iter().map(|o| &o.name[..]).collect();
    assert_eq!(names, ["Glocke \u{e4}", "B"]);
    assert_eq!(
        file.notes,
        [Note::NotFaces { lines: 1 }, Note::Cut { polygons: 1 }]
    );
    assert!(file.soup.object("C").is_err());
    assert_eq!(file.soup.object("B").unwrap().triangles.len(), 1);
}

#[test]
fn what_is_wrong_is_said_with_its_line() {
    for (text, said) in [
        ("v 0 0 nan\n", "a.obj:1: \"nan\""),
        ("v 0 0\n", "a.obj:1: a point has three"),
        ("v 0 0 0\nf 1 2 9\n", "a.obj:2: a face uses point 9"),
        ("v 0 0 0\nf 1 0 1\n", "a.obj:2: a face uses point 0"),
        ("v 0 0 0\nf -2 1 1\n", "a.obj:2: a face uses point -2"),
        ("v 0 0 0\nf 1 x 1\n", "a.obj:2: \"x\""),
        ("# nothing\n", "a.obj: no faces"),
    ] {
        let error = parse(text).unwrap_err().to_string();
        assert!(error.starts_with(said), "{error}");
    }
}

#[test]
fn what_is_written_reads_back() {
    let soup = crate::solid::gallery::torus(0.1, 0.03, 12);
    assert_eq!(
        parse(&write_obj(&soup)).unwrap().soup.triangles.len(),
        soup.triangles.len()
    );
}

#[test]
fn a_missing_library_of_materials_is_noted() {
    let text = b"mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let file = parse_obj(text, "a.obj", Some(Path::new("/nowhere"))).unwrap();
    let name = "none.mtl".to_owned();
    assert_eq!(file.notes, [Note::NoMaterials { name }]);
}
