//! Numbers as text.

use alloc::format;
use alloc::string::{String, ToString};

/// The largest finite number, with one more digit than its shortest text, which lies beyond it.
pub(super) const LARGEST: &str = "const BRDF_LARGEST = 3.40282346e38;\n";

/// The shortest text of the nearest `f32`. What is too large is the largest finite number. What is no
/// number is refused before; there is a text for it, as there is for all.
#[allow(clippy::cast_possible_truncation, reason = "shaders compute in single precision")]
pub(super) fn number(value: f64) -> String {
    if value.is_nan() {
        return "0.0".to_string();
    }
    let single = value as f32;
    if single.abs() >= f32::MAX {
        return if single > 0.0 { "BRDF_LARGEST" } else { "-BRDF_LARGEST" }.to_string();
    }
    format!("{single:?}")
}

#[cfg(test)]
mod tests {
    use super::{LARGEST, number};

    #[test]
    fn numbers_are_those_of_single_precision() {
        let texts = [0.1, 1.0, -1e-37, 1e39, f64::NEG_INFINITY, f64::NAN, 1.0 / 3.0].map(number);
        let want = ["0.1", "1.0", "-1e-37", "BRDF_LARGEST", "-BRDF_LARGEST", "0.0", "0.33333334"];
        assert_eq!(texts, want);
        let largest = LARGEST.trim_end_matches(";\n").rsplit(' ').next();
        let largest: f64 = largest.and_then(|text| text.parse().ok()).expect("a number");
        assert!(largest <= f32::MAX.into());
        #[allow(clippy::cast_possible_truncation, reason = "rounding is tested")]
        let rounded = largest as f32;
        assert_eq!(rounded, f32::MAX);
    }
}
