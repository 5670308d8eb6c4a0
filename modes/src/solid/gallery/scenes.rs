//! Things made of boxes (O'Brien et al. 2002, Figures 4 and 6).

use super::super::Soup;
use super::cuboid;

/// `count` boxes of growing size beside each other, each an object of its own.
#[must_use]
pub fn stack(count: usize, edge_m: f64) -> Soup {
    let mut boxes = Soup::default();
    let mut x = 0.0;
    for number in 0..count {
        let edge = edge_m * (1.0 + 0.1 * number as f64);
        let mut one = moved(cuboid([edge, 0.8 * edge, 0.6 * edge]), [x, 0.0, 0.0]);
        one.objects[0].name = format!("box {}", number + 1);
        boxes.append(&one);
        x += 1.5 * edge;
    }
    boxes
}

/// Two sides with `boards` boards between them, `thickness_m` thick; they go through each other and are
/// one body.
#[must_use]
pub fn shelf(boards: usize, [width_m, depth_m, height_m]: [f64; 3], thickness_m: f64) -> Soup {
    let side = || cuboid([thickness_m, depth_m, height_m]);
    let mut shelf = side();
    shelf.append(&moved(side(), [width_m - thickness_m, 0.0, 0.0]));
    for board in 0..boards {
        let share = board as f64 / (boards.max(2) - 1) as f64;
        let z = share * (height_m - thickness_m);
        let across = cuboid([width_m - thickness_m, depth_m, thickness_m]);
        shelf.append(&moved(across, [0.5 * thickness_m, 0.0, z]));
    }
    shelf
}

fn moved(mut shape: Soup, by: [f64; 3]) -> Soup {
    for point in &mut shape.points {
        *point = [0, 1, 2].map(|a| point[a] + by[a]);
    }
    shape
}
