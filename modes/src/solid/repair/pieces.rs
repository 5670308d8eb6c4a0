//! Separate pieces: which are bodies, which are hollows in them, which way each faces.

use super::super::closed::signed_volume;
use super::super::tree::Tree;
use super::super::vector::{add, scale};
use super::edges::Edges;
use super::{MeshError, Note, Pieces, Work};

/// Pieces beyond which none is looked at for being inside another: thousands of specks are no
/// hollows.
const MOST_NESTED: usize = 200;

/// A connected part of the surface.
struct Piece {
    triangles: Vec<u32>,
    /// Volume as the file faces it, in its units.
    volume: f64,
    /// Number of the piece just around it.
    within: Option<usize>,
    /// Pieces around it.
    depth: usize,
}

/// Turns every piece outwards, hollows inwards, and keeps those chosen.
pub(super) fn choose(work: &mut Work, chosen: Pieces) -> Result<(), MeshError> {
    let mut pieces = connected(work);
    if pieces.len() <= MOST_NESTED {
        nest(work, &mut pieces);
    }
    // A piece in another that faces the other way is a hollow.
    let hollow: Vec<bool> = pieces
        .iter()
        .map(|piece| {
            piece.within.is_some_and(|outer| {
                piece.depth % 2 == 1 && piece.volume * pieces[outer].volume < 0.0
            })
        })
        .collect();
    let mut inside_out = 0;
    for (piece, &hollow) in pieces.iter().zip(&hollow) {
        if (piece.volume < 0.0) != hollow {
            inside_out += 1;
            for &t in &piece.triangles {
                work.triangles[t as usize].swap(1, 2);
            }
        }
    }
    if inside_out > 0 {
        work.notes.push(Note::InsideOut { pieces: inside_out });
    }
    let mut bodies: Vec<usize> = (0..pieces.len()).filter(|&i| !hollow[i]).collect();
    bodies.sort_by(|&i, &j| pieces[j].volume.abs().total_cmp(&pieces[i].volume.abs()));
    let kept: Vec<usize> = match chosen {
        Pieces::All => bodies.clone(),
        Pieces::Largest => bodies.iter().copied().take(1).collect(),
        Pieces::Nth(n) => bodies.iter().copied().skip(n).take(1).collect(),
    };
    if kept.is_empty() {
        return Err(MeshError::NoSuchObject {
            name: format!("{chosen:?}"),
            names: (0..bodies.len()).map(|n| n.to_string()).collect(),
        });
    }
    if kept.len() < bodies.len() {
        work.notes.push(Note::PiecesLeft {
            kept: kept.len(),
            left: bodies.len() - kept.len(),
        });
    }
    let stays = |i: usize| match (hollow[i], pieces[i].within) {
        (true, Some(outer)) => kept.contains(&outer),
        _ => kept.contains(&i),
    };
    let cavities = (0..pieces.len()).filter(|&i| hollow[i] && stays(i)).count();
    if cavities > 0 {
        work.notes.push(Note::Cavities { count: cavities });
    }
    work.triangles = (0..pieces.len())
        .filter(|&i| stays(i))
        .flat_map(|i| &pieces[i].triangles)
        .map(|&t| work.triangles[t as usize])
        .collect();
    Ok(())
}

/// Parts that are joined at edges with two faces.
fn connected(work: &Work) -> Vec<Piece> {
    let count = work.triangles.len();
    let neighbours = Edges::of(&work.triangles).neighbours(count);
    let mut seen = vec![false; count];
    let mut pieces = Vec::new();
    for start in 0..count {
        if std::mem::replace(&mut seen[start], true) {
            continue;
        }
        let (mut triangles, mut done) = (vec![start as u32], 0);
        while done < triangles.len() {
            for (other, _) in neighbours[triangles[done] as usize].iter().flatten() {
                if !std::mem::replace(&mut seen[*other as usize], true) {
                    triangles.push(*other);
                }
            }
            done += 1;
        }
        let own: Vec<[u32; 3]> = triangles
            .iter()
            .map(|&t| work.triangles[t as usize])
            .collect();
        pieces.push(Piece {
            volume: signed_volume(&work.points, &own),
            triangles,
            within: None,
            depth: 0,
        });
    }
    pieces
}

/// Finds the pieces around each piece.
fn nest(work: &Work, pieces: &mut [Piece]) {
    if pieces.len() < 2 {
        return;
    }
    let trees: Vec<Tree> = pieces
        .iter()
        .map(|piece| {
            let own = piece.triangles.iter().map(|&t| work.triangles[t as usize]);
            Tree::new(&work.points, &own.collect::<Vec<_>>())
        })
        .collect();
    for i in 0..pieces.len() {
        let corners = work.corners(&work.triangles[pieces[i].triangles[0] as usize]);
        let middle = scale(corners.into_iter().fold([0.0; 3], add), 1.0 / 3.0);
        // On a surface the number is a half: pieces that touch are beside each other.
        let around = (0..trees.len()).filter(|&j| {
            let larger = pieces[j].volume.abs() > pieces[i].volume.abs();
            j != i && larger && trees[j].winding(middle).abs() > 0.75
        });
        let around: Vec<usize> = around.collect();
        let volume = |j: &usize| pieces[*j].volume.abs();
        let tightest = around.iter().copied();
        let tightest = tightest.min_by(|i, j| volume(i).total_cmp(&volume(j)));
        pieces[i].depth = around.len();
        pieces[i].within = tightest;
    }
}
