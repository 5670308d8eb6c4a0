//! Gauss's rules on −1…1: abscissae and weights.

/// Two-point rule: abscissae ±1/√3, weights 1.
pub(crate) const GAUSS_2: [(f64, f64); 2] = [
    (-0.577_350_269_189_625_8, 1.0),
    (0.577_350_269_189_625_8, 1.0),
];

/// Three-point rule: abscissae 0, ±√(3/5), weights 8/9, 5/9.
pub(crate) const GAUSS_3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];
