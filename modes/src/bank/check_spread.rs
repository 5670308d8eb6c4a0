//! Whether a bank's bodies can be given to keys as it says.

use super::check::{check_body, positive};
use super::{Bank, BankError, Body, Spread, Zone};

/// Points of all keys' strike grids, and modes of all keys, at most: what memory they take is bounded.
const MOST_POINTS: usize = 1 << 20;
const MOST_MODES: usize = 1 << 20;

impl Bank {
    /// Whether every zone has its body, and what each key is given is possible.
    pub(super) fn check_spread(&self, spread: &Spread) -> Result<(), BankError> {
        positive("spread a4_hz", spread.a4_hz)?;
        if let Some(enough) = spread.enough {
            positive("spread enough hz", enough.hz)?;
        }
        if spread.zones.len() != self.bodies.len() {
            let allowed = "one for each body";
            let count = spread.zones.len();
            return Err(BankError::inconsistent("spread zones", count, allowed));
        }
        let (mut least_key, mut points, mut modes) = (0, 0, 0);
        for (body, zone) in self.bodies.iter().zip(&spread.zones) {
            check_zone(body, zone, least_key)
                .map_err(|error| error.within(format!("zone of key {}", body.key)))?;
            least_key = u16::from(zone.high) + 1;
            let keys = usize::from(zone.high - zone.low) + 1;
            points += keys * body.line.len();
            modes += keys * body.modes.len();
        }
        let most = [
            ("points", points, MOST_POINTS),
            ("modes", modes, MOST_MODES),
        ];
        if let Some((field, count, _)) = most.iter().find(|(_, count, most)| count > most) {
            let allowed = "at most 1048576 for all keys together";
            return Err(BankError::inconsistent(*field, count, allowed));
        }
        for (body, zone) in self.bodies.iter().zip(&spread.zones) {
            for key in zone.low..=zone.high {
                check_body(&spread.body(self.matter_of(body), body, *zone, key))
                    .map_err(|error| error.within(format!("key {key}")))?;
            }
        }
        Ok(())
    }
}

fn check_zone(body: &Body, zone: &Zone, least_key: u16) -> Result<(), BankError> {
    if !(least_key..128).contains(&u16::from(zone.low)) || zone.low > body.key {
        let allowed = "above the zone before and no higher than the body's key";
        return Err(BankError::inconsistent("low", zone.low, allowed));
    }
    if zone.high > 127 || zone.high < body.key {
        let allowed = "0 to 127 and no lower than the body's key";
        return Err(BankError::inconsistent("high", zone.high, allowed));
    }
    if zone.tuned as usize >= body.modes.len() {
        let allowed = "below the number of the body's modes";
        return Err(BankError::inconsistent("tuned", zone.tuned, allowed));
    }
    if body.modes.iter().any(|mode| mode.pipe_per_s != 0.0) {
        let allowed = "none: a resonator is not scaled with its body";
        return Err(BankError::inconsistent("pipe_per_s", "not 0", allowed));
    }
    Ok(())
}
