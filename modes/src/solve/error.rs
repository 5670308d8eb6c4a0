//! What can go wrong between a mesh and its modes.

/// Why no modes came out.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// A mesh element has no volume or is inside out.
    #[error(
        "element {index} is flat or inside out; thinner walls, wider bends or shorter elements are sound"
    )]
    BadElement {
        /// Number of the element.
        index: usize,
    },
    /// K − σM is not positive definite although σ is negative.
    #[error("the stiffness matrix is not positive semi-definite; check the material")]
    Indefinite,
    /// The eigen solver stopped short.
    #[error(
        "{converged} of {wanted} modes converged in a subspace of {subspace}; \
         every mode below {known_below_hz:.1} Hz is known: end the band there, or coarsen the mesh"
    )]
    NotConverged {
        /// Modes that met the tolerance.
        converged: usize,
        /// Modes that the inertia count says there are.
        wanted: usize,
        /// Vectors used.
        subspace: usize,
        /// Frequency below which the converged modes are all there are, by the inertia count.
        known_below_hz: f64,
    },
    /// A mode came out that does not solve its equation well enough.
    #[error(
        "the mode at {hz:.1} Hz leaves a relative residual of {residual:.1e}, and {allowed:.0e} is allowed; \
         {good} modes are good, all below it: rounding leaves more of thicker walls and shorter bodies"
    )]
    Inaccurate {
        /// The mode's frequency, in Hz.
        hz: f64,
        /// ‖Kφ − λMφ‖ / ‖Kφ‖.
        residual: f64,
        /// The largest residual allowed.
        allowed: f64,
        /// Modes below it: none is missing, and all are good enough.
        good: usize,
    },
    /// The body is held where it should be free, or falls apart.
    #[error(
        "{found} rigid motions where a body of this kind has {expected}: it is held, falls apart, or is so \
         thin and long that its lowest modes drown in rounding"
    )]
    RigidMotions {
        /// Near-zero eigenvalues found.
        found: usize,
        /// Near-zero eigenvalues that belong.
        expected: usize,
    },
    /// The caller asked to stop.
    #[error("cancelled")]
    Cancelled,
}
