//! Faces turned to agree with their neighbours.

use super::edges::Edges;
use super::{MeshError, Note, Work};

/// Turns triangles so that the two at each edge agree on which side is out; of each piece the fewer
/// are turned.
pub(super) fn agree(work: &mut Work) -> Result<(), MeshError> {
    let count = work.triangles.len();
    let neighbours = Edges::of(&work.triangles).neighbours(count);
    let mut turned: Vec<Option<bool>> = vec![None; count];
    let mut total = 0;
    for start in 0..count {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        let (mut piece, mut done) = (vec![start], 0);
        while done < piece.len() {
            let at = piece[done];
            done += 1;
            for (other, agrees) in neighbours[at].iter().flatten() {
                let way = turned[at].map(|way| way == *agrees);
                let other = *other as usize;
                match turned[other] {
                    None => {
                        turned[other] = way;
                        piece.push(other);
                    }
                    known if known == way => {}
                    Some(_) => return Err(MeshError::OneSided),
                }
            }
        }
        let flipped = piece.iter().filter(|&&t| turned[t] == Some(true)).count();
        let others = 2 * flipped > piece.len();
        for &t in &piece {
            if (turned[t] == Some(true)) != others {
                work.triangles[t].swap(1, 2);
                total += 1;
            }
        }
    }
    if total > 0 {
        work.notes.push(Note::Turned { faces: total });
    }
    Ok(())
}
