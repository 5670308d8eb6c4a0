//! One pitch of a scale: a ratio, or cents.

/// Farthest pitch from 1/1, in cents: where only a slip of the pen leads.
const FARTHEST_CENTS: f64 = 120_000.0;

const NEITHER: &str = "a pitch must be a ratio such as 3/2, a whole number such as 2, or cents with \
                       a point such as 701.955";
const TOO_FAR: &str = "a pitch must lie within 100 octaves of 1/1";

/// Cents above 1/1 of the pitch that begins `text`, or what is wrong with it.
///
/// With a point it is in cents, without one it is a ratio. What follows it is a remark, unless it
/// looks like more of the number.
pub(super) fn pitch_cents(text: &str) -> Result<f64, &'static str> {
    let text = text.trim_start();
    let (negative, unsigned) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let (number, rest) = split(unsigned, |c| c.is_ascii_digit() || c == '.');
    let cents = if number.contains('.') {
        let cents: f64 = number.parse().map_err(|_| NEITHER)?;
        remark(rest)?;
        if negative { -cents } else { cents }
    } else {
        let ratio = ratio(number, rest)?;
        if negative {
            return Err("a ratio must not be negative; a falling interval is 2/3, or -701.955");
        }
        1200.0 * ratio.log2()
    };
    if cents.abs() > FARTHEST_CENTS {
        return Err(TOO_FAR);
    }
    Ok(cents)
}

/// The ratio whose upper number is `upper`, and whose lower one, if there is one, begins `rest`.
fn ratio(upper: &str, rest: &str) -> Result<f64, &'static str> {
    let upper: f64 = upper.parse().map_err(|_| NEITHER)?;
    let lower = match rest.trim_start().strip_prefix('/') {
        Some(lower) => {
            let (lower, rest) = split(lower.trim_start(), |c| c.is_ascii_digit());
            let lower = lower
                .parse()
                .map_err(|_| "a ratio must have a lower number, as in 3/2")?;
            remark(rest)?;
            lower
        }
        None => {
            remark(rest)?;
            1.0
        }
    };
    if upper == 0.0 {
        return Err("a ratio's upper number must not be 0");
    }
    if lower == 0.0 {
        return Err("a ratio's lower number must not be 0");
    }
    let ratio = upper / lower;
    if ratio.is_normal() {
        Ok(ratio)
    } else {
        Err(TOO_FAR)
    }
}

/// Refuses what follows a number if it is likely to belong to it.
fn remark(rest: &str) -> Result<(), &'static str> {
    let mut chars = rest.chars();
    let (first, second) = (chars.next(), chars.next());
    let figure = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit() || "+-".contains(c));
    match first {
        Some('/') => Err("a ratio must be of two whole numbers, with one slash"),
        Some('.') => Err("a ratio must be of whole numbers, and cents must have one point"),
        Some(',') if figure(second) => Err("decimals must have a point, as in 701.955"),
        Some('e' | 'E') if figure(second) => Err("a pitch must be written without an exponent"),
        Some(c) if "\\:^*<>|%=_~+-".contains(c) => Err(NEITHER),
        _ => Ok(()),
    }
}

fn split(text: &str, belongs: impl Fn(char) -> bool) -> (&str, &str) {
    text.split_at(text.find(|c| !belongs(c)).unwrap_or(text.len()))
}

#[cfg(test)]
mod tests {
    use super::pitch_cents;

    #[test]
    fn pitches_are_read_as_the_format_says() {
        let third = 1200.0 * (5.0_f64 / 4.0).log2();
        let cases = [
            ("81/64", 1200.0 * (81.0_f64 / 64.0).log2()),
            ("408.0", 408.0),
            ("408.", 408.0),
            (".5", 0.5),
            ("5", 1200.0 * 5.0_f64.log2()),
            ("-5.0", -5.0),
            ("+5.0", 5.0),
            ("10/20", -1200.0),
            ("100.0 cents", 100.0),
            (" 100.0 C#", 100.0),
            (" 5/4   E\\", third),
            ("\t5/4\t", third),
            ("5 / 4", third),
            ("5/4!a third", third),
            ("5/4, a third", third),
            ("100.0cents", 100.0),
            ("100.0 3/2", 100.0),
            ("2 1/1 is implied", 1200.0),
            ("2147483647/2147483646", 8.061_686_764_8e-7),
            ("3486784401/4294967296", -360.899_982_692_251_6),
        ];
        for (text, cents) in cases {
            let read = pitch_cents(text).unwrap();
            assert!((read - cents).abs() < 1e-12, "{text}: {read}");
        }
    }

    #[test]
    fn what_is_no_pitch_is_refused_with_the_reason() {
        let long = "9".repeat(400);
        let cases = [
            ("5/0", "lower number must not be 0"),
            ("0/5", "upper number must not be 0"),
            ("0", "upper number must not be 0"),
            ("5/", "a lower number"),
            ("5/x", "a lower number"),
            ("5/-4", "a lower number"),
            ("/4", "a ratio such as"),
            ("-3/2", "must not be negative"),
            ("-2", "must not be negative"),
            ("3/2/9", "one slash"),
            ("3/2.5", "whole numbers"),
            ("1.5/2", "one slash"),
            ("100.0.0", "a ratio such as"),
            (".", "a ratio such as"),
            ("-", "a ratio such as"),
            ("", "a ratio such as"),
            ("C#", "a ratio such as"),
            ("inf", "a ratio such as"),
            ("NaN", "a ratio such as"),
            ("7\\12", "a ratio such as"),
            ("3:2", "a ratio such as"),
            ("701,955", "a point"),
            ("7e2", "an exponent"),
            ("7.0E+2", "an exponent"),
            ("120001.0", "100 octaves"),
            ("-120001.0", "100 octaves"),
            (&long, "100 octaves"),
            (&format!("{long}/{long}"), "100 octaves"),
            (&format!("1/{long}"), "100 octaves"),
            (&format!("{long}."), "100 octaves"),
        ];
        for (text, reason) in cases {
            let fault = pitch_cents(text).unwrap_err();
            assert!(fault.contains(reason), "{text}: {fault}");
        }
    }
}
