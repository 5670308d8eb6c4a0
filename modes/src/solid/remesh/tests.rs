use super::*;
use crate::solid::vector::distance;
use crate::solid::{Repair, Soup, gallery, repair};

/// The surface, and its triangles made anew with edges about `edge_m` long.
fn anew(soup: &Soup, edge_m: f64, check: impl Fn(&ClosedSurface, &Outer)) {
    let surface = repair(soup, &Repair::default()).unwrap();
    let (body, features) = (Body::new(&surface, None), Features::of(&surface));
    let outer = remesh(&surface, &body, &features, |_| true, edge_m).unwrap();
    check(&surface, &outer);
}

fn area_m2(outer: &Outer) -> f64 {
    let places = |face: &[u32; 3]| face.map(|corner| outer.points[corner as usize]);
    let areas = outer
        .faces
        .iter()
        .map(|face| 0.5 * norm(doubled_area(places(face))));
    areas.sum()
}

/// Needles, slivers and triangles far too small become alike.
#[test]
fn triangles_are_about_as_large_as_asked() {
    for (name, soup, edge_m) in [
        ("can", gallery::cylinder(0.02, 0.4, 200), 0.008),
        ("cube", gallery::cuboid([0.1; 3]), 0.011),
        ("ball", gallery::sphere(0.1, 5), 0.02),
        ("star", gallery::star(7, 0.1, 0.03), 0.01),
    ] {
        anew(&soup, edge_m, |_, outer| {
            let mut lengths: Vec<f64> = Vec::new();
            let mut heights: Vec<f64> = Vec::new();
            for face in &outer.faces {
                let [p, q, r] = face.map(|corner| outer.points[corner as usize]);
                let sides = [distance(p, q), distance(q, r), distance(r, p)];
                lengths.extend(sides);
                let longest = sides.into_iter().fold(0.0, f64::max);
                heights.push(norm(doubled_area([p, q, r])) / (longest * longest));
            }
            let mean_m = lengths.iter().sum::<f64>() / lengths.len() as f64;
            assert!(
                (0.85..1.15).contains(&(mean_m / edge_m)),
                "{name}: {mean_m}"
            );
            let far = |m: &&f64| !(0.5..1.6).contains(&(**m / edge_m));
            let odd = lengths.iter().filter(far).count() as f64 / lengths.len() as f64;
            assert!(odd < 0.02, "{name}: {odd}");
            let worst = heights.iter().copied().fold(1.0, f64::min);
            assert!(worst > 0.2, "{name}: {worst}");
        });
    }
}

#[test]
fn sharp_edges_and_corners_stay() {
    let cube = gallery::cuboid([0.1, 0.2, 0.3]);
    anew(&cube, 0.02, |surface, outer| {
        assert!((area_m2(outer) / surface.area_m2() - 1.0).abs() < 1e-12);
        let corners = outer.holds.iter().filter(|hold| **hold == Hold::Corner);
        assert_eq!(corners.count(), 8);
        let on_edges = outer
            .holds
            .iter()
            .filter(|hold| matches!(hold, Hold::Edge(_)));
        // Twelve edges of 2.4 m in all.
        assert!((80..160).contains(&on_edges.count()));
    });
}

/// An inscribed triangle of edge e is e²/8R off the ball's surface at its sides.
#[test]
fn round_parts_stay_round() {
    let (radius_m, edge_m) = (0.1, 0.02);
    anew(&gallery::sphere(radius_m, 5), edge_m, |_, outer| {
        let off = outer
            .points
            .iter()
            .map(|p| (norm(*p) / radius_m - 1.0).abs());
        assert!(off.fold(0.0, f64::max) < 1e-3);
        let exact = 4.0 * std::f64::consts::PI * radius_m * radius_m;
        let lost = 1.0 - area_m2(outer) / exact;
        assert!(
            (0.0..(edge_m / radius_m).powi(2) / 4.0).contains(&lost),
            "{lost}"
        );
    });
}

/// A part alone has an open rim on its sharp edges.
#[test]
fn a_part_can_be_made_anew_alone() {
    let (radius_m, height_m) = (0.02, 0.1);
    let can = gallery::cylinder(radius_m, height_m, 100);
    let surface = repair(&can, &Repair::default()).unwrap();
    let (body, features) = (Body::new(&surface, None), Features::of(&surface));
    let side = (0..surface.triangles.len()).find(|&t| {
        let [p, q, r] = surface.corners_m(t);
        [p, q, r].iter().any(|a| a[2] > 0.0) && [p, q, r].iter().any(|a| a[2] < 0.0)
    });
    let side = features.patch[side.unwrap()];
    let outer = remesh(&surface, &body, &features, |part| part == side, 0.005).unwrap();
    let exact = std::f64::consts::TAU * radius_m * height_m;
    assert!((area_m2(&outer) / exact - 1.0).abs() < 0.02);
    let rims = outer
        .points
        .iter()
        .filter(|p| p[2].abs() > 0.4999 * height_m);
    assert!(rims.count() > 40);
}
