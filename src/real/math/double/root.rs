//! √x and 1/√x.

/// Square root, correctly rounded.
#[inline(always)]
pub(in crate::real) fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(x);
}

/// 1/√x for normal x > 0: as in single precision, and one more step of Newton's method.
#[inline(always)]
pub(in crate::real) fn rsqrt(x: f64) -> f64 {
    let y = f64::from_bits(0x5fe3_ff6b_6000_0000_u64.wrapping_sub(x.to_bits() >> 1));
    let y = y * (1.6820704390328447 - 0.7041486572539045 * (x * y * y));
    let rest = 1.0 - x * y * y;
    let y = y + y * rest * (0.5 + 0.375 * rest);
    let rest = 1.0 - x * y * y;
    y + 0.5 * (y * rest)
}
