//! A bank to bytes.

use super::format::{
    BodyEntry, CHECKSUM_AT, FORMAT, Header, MAGIC, MODE_LEN, MOTION_LEN, POINT_LEN, PRELUDE_LEN,
    SURFACE_LENS, SurfaceEntry, VERSION, checksum, described_arrays, family_number, member_number,
};
use super::mirror::Stored;
use super::sheet::{self, tables_of};
use super::{Bank, Body, Enough, Matter, Mode, Spread, Surface};
use crate::{Damping, Material, Provenance, Rayleigh};

impl Bank {
    /// The bank as the content of a file. Equal banks give equal bytes.
    ///
    /// A bank that [`Bank::check`] refuses gives bytes that [`Bank::read`] refuses.
    ///
    /// # Panics
    ///
    /// If the header exceeds 4 GiB.
    #[must_use]
    pub fn write(&self) -> Vec<u8> {
        let header = serde_json::to_vec(&self.header()).expect("a header is plain data");
        let header_len = u32::try_from(header.len()).expect("a header is far shorter than 4 GiB");
        let bodies: u64 = self.bodies.iter().map(section_len).sum();
        let bodies = usize::try_from(bodies).expect("what is in memory is shorter than memory");
        let mut file = Vec::with_capacity(PRELUDE_LEN + 4 + header.len() + bodies);
        file.extend(MAGIC);
        file.extend(VERSION.to_le_bytes());
        file.extend([0; PRELUDE_LEN - 12]);
        file.extend(header_len.to_le_bytes());
        file.extend(header);
        for body in &self.bodies {
            write_body(body, &mut file);
        }
        let len = file.len() as u64;
        file[12..CHECKSUM_AT].copy_from_slice(&len.to_le_bytes());
        let checksum = checksum(&file).to_le_bytes();
        file[CHECKSUM_AT..PRELUDE_LEN].copy_from_slice(&checksum);
        file
    }

    fn header(&self) -> Header {
        let mut offset = 0;
        let mut bodies = Vec::with_capacity(self.bodies.len());
        for body in &self.bodies {
            bodies.push(BodyEntry {
                key: body.key,
                pitch_hz: plain(body.pitch_hz),
                length_m: plain(body.length_m),
                mass_kg: plain(body.mass_kg),
                matter: body.matter.map(plain_matter),
                modes: body.modes.len() as u64,
                points: body.line.len() as u64,
                rows: body.line.rows as u64,
                closed: body.line.closed,
                surface: body.surface.as_deref().map(surface_entry),
                tables: tables_of(body).map(|tables| sheet::entry(tables)),
                offset,
            });
            offset += section_len(body);
        }
        let matter = plain_matter(self.matter());
        Header {
            format: FORMAT.to_owned(),
            name: self.name.clone(),
            title: self.title.clone(),
            material: matter.material,
            damping: matter.damping,
            ears_m: self.ears_m.map(|ear| ear.map(plain)),
            provenance: Provenance {
                tolerance_cents: plain(self.provenance.tolerance_cents),
                max_residual: plain(self.provenance.max_residual),
                max_orthonormality_error: plain(self.provenance.max_orthonormality_error),
                ..self.provenance.clone()
            },
            spread: self.spread.as_ref().map(|spread| Spread {
                a4_hz: plain(spread.a4_hz),
                enough: spread.enough.map(|enough| Enough {
                    hz: plain(enough.hz),
                    ..enough
                }),
                ..spread.clone()
            }),
            bodies,
            arrays: described_arrays(VERSION),
        }
    }
}

/// −0 becomes 0, because the two are equal but their bytes are not.
fn plain(x: f64) -> f64 {
    x + 0.0
}

fn plain_matter(matter: Matter) -> Matter {
    let Matter { material, damping } = matter;
    Matter {
        material: Material {
            lambda_pa: plain(material.lambda_pa),
            mu_pa: plain(material.mu_pa),
            density_kg_m3: plain(material.density_kg_m3),
        },
        damping: Damping {
            rayleigh: Rayleigh {
                alpha1_s: plain(damping.rayleigh.alpha1_s),
                alpha2_per_s: plain(damping.rayleigh.alpha2_per_s),
            },
            loss_factor: plain(damping.loss_factor),
        },
    }
}

fn section_len(body: &Body) -> u64 {
    let points = body.line.len() as u64;
    let shapes: u64 = match tables_of(body) {
        Some(tables) => sheet::len(tables, body.modes.len()),
        None => body
            .modes
            .iter()
            .map(|mode| Stored::of(mode, body.line.len()).len())
            .sum(),
    };
    let surface = body.surface.as_deref().map_or(0, surface_len);
    POINT_LEN * points + MODE_LEN * body.modes.len() as u64 + shapes + surface
}

fn surface_entry(surface: &Surface) -> SurfaceEntry {
    SurfaceEntry {
        length_m: plain(surface.length_m),
        points: surface.points_m.len() as u64,
        triangles: surface.triangles.len() as u64,
        motions: surface.motions.len() as u64,
    }
}

fn surface_len(surface: &Surface) -> u64 {
    let entry = surface_entry(surface);
    let [point, triangle, motion] = SURFACE_LENS;
    let moving: usize = surface.motions.iter().map(|m| m.points.len()).sum();
    point * entry.points
        + triangle * entry.triangles
        + motion * entry.motions
        + MOTION_LEN * moving as u64
}

fn write_body(body: &Body, file: &mut Vec<u8>) {
    let f64s = |file: &mut Vec<u8>, x: f64| file.extend(plain(x).to_le_bytes());
    for vectors in [&body.line.points_m, &body.line.normals] {
        vectors.iter().flatten().for_each(|&x| f64s(file, x));
    }
    body.modes.iter().for_each(|mode| f64s(file, mode.hz));
    body.modes.iter().for_each(|mode| f64s(file, mode.coupling));
    body.modes.iter().for_each(|mode| f64s(file, mode.residual));
    body.modes.iter().for_each(|mode| write_air(mode, file));
    for label in body.modes.iter().map(|mode| mode.label) {
        file.extend([family_number(label.family), member_number(label.member)]);
        file.extend(label.order.to_le_bytes());
        file.extend(label.index.to_le_bytes());
    }
    let tables = tables_of(body);
    match tables {
        Some(_) => file.extend(body.modes.iter().map(|_| sheet::PRODUCT)),
        None => write_shapes(body, file),
    }
    if let Some(surface) = &body.surface {
        write_surface(surface, file);
    }
    if let Some(tables) = tables {
        sheet::write(body, tables, file);
    }
}

fn write_shapes(body: &Body, file: &mut Vec<u8>) {
    let stored: Vec<Stored> = body
        .modes
        .iter()
        .map(|mode| Stored::of(mode, body.line.len()))
        .collect();
    file.extend(stored.iter().map(Stored::bits));
    for (mode, stored) in body.modes.iter().zip(&stored) {
        for c in stored.components() {
            for phi in mode.shape.iter().take(stored.points()) {
                file.extend((phi[c] + 0.0).to_le_bytes());
            }
        }
    }
}

fn write_surface(surface: &Surface, file: &mut Vec<u8>) {
    for x in surface.points_m.iter().flatten() {
        file.extend((x + 0.0).to_le_bytes());
    }
    for corner in surface.triangles.iter().flatten() {
        file.extend(corner.to_le_bytes());
    }
    for motion in &surface.motions {
        file.extend((motion.step + 0.0).to_le_bytes());
    }
    for motion in &surface.motions {
        file.extend(motion.points.iter().flatten().flat_map(|x| x.to_le_bytes()));
    }
}

fn write_air(mode: &Mode, file: &mut Vec<u8>) {
    let ears = mode.ears.iter().chain(&mode.pipe_ears).flatten();
    let rates = [
        mode.radiation_per_s,
        mode.support_per_s,
        mode.felt_per_s,
        mode.pipe_per_s,
    ];
    for x in ears.chain(&rates) {
        file.extend((x + 0.0).to_le_bytes());
    }
}
