//! What the hands do to the instrument, in its own terms.

/// How far hands move what rings on a key, all of it on top of the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyHands {
    /// Pitch, in semitones, −120…120.
    pub bend_semitones: f64,
    /// Factor on the amplitude, 0…16.
    pub level: f64,
    /// −1 (left) …1 (right).
    pub pan: f64,
    /// Weight of the felt on the body if released keys are damped, 0 (held off) …4; 1 is the felt as
    /// built.
    pub felt: f64,
    /// Decay rate that a hand adds to every mode, in 1/s, 0…115.13.
    pub hand_per_s: f64,
    /// What to add to the bow's pressure, as a share of its range, −1…1.
    pub bow_pressure: f64,
    /// Octaves by which the bow goes faster, −2…2.
    pub bow_speed_octaves: f64,
    /// The host's own modulation of the damping, in its units of that parameter, −1…1.
    pub damping_modulation: f64,
}

/// How a key is struck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchHands {
    /// Velocity after the curve, 0…1.
    pub velocity: f64,
    /// How far the strike lands from where the parameters have it, as a share of the line, −½…½.
    pub position: f64,
    /// Decades by which the mallet's modulus is greater, −2…2.
    pub hardness_decades: f64,
    /// Octaves by which the mallet is heavier, −2…2.
    pub mass_octaves: f64,
    /// The host's own modulation of the strike position, in its units of that parameter, −1…1.
    pub position_modulation: f64,
    /// The host's own modulation of the hardness, in its units of that parameter, −1…1.
    pub hardness_modulation: f64,
}

/// How far hands move what all keys share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WholeHands {
    /// What to add to the motor's speed, in Hz, −12…12.
    pub motor_speed_hz: f64,
    /// What to add to the motor's depth, −1…1.
    pub motor_depth: f64,
    /// Octaves by which the listener is farther away, −2…2.
    pub distance_octaves: f64,
}
