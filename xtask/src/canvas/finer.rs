//! Smooth edges: pictures are drawn larger and shrunk.

/// How many times as wide and as high pictures are drawn.
pub(super) const FINER: i32 = 2;

/// `pixels`, three bytes each in rows of `width`, with each square of [`FINER`] by [`FINER`] made one.
pub(super) fn shrunk(pixels: &[u8], width: usize) -> Vec<u8> {
    const SIDE: usize = FINER as usize;
    let rows: Vec<_> = pixels.chunks_exact(3 * width).collect();
    let mut shrunk = Vec::with_capacity(pixels.len() / (SIDE * SIDE));
    for rows in rows.chunks_exact(SIDE) {
        for x in (0..width).step_by(SIDE) {
            for part in 0..3 {
                let square = rows.iter().flat_map(|row| {
                    let across = x..x + SIDE;
                    across.map(|x| u32::from(row[3 * x + part]))
                });
                let count = (SIDE * SIDE) as u32;
                shrunk.push(((square.sum::<u32>() + count / 2) / count) as u8);
            }
        }
    }
    shrunk
}

#[cfg(test)]
mod tests {
    use super::shrunk;

    #[test]
    fn a_square_becomes_its_mean() {
        let row = [10, 0, 0, 20, 0, 0, 7, 7, 7, 7, 7, 7];
        let below = [30, 0, 8, 40, 0, 0, 7, 7, 7, 7, 7, 7];
        assert_eq!(shrunk(&[row, below].concat(), 4), [25, 0, 2, 7, 7, 7]);
    }
}
