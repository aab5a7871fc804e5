//! √x and 1/√x.

/// Square root, correctly rounded.
#[inline(always)]
pub(in crate::real) fn sqrt(x: f32) -> f32 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrtf(x);
}

/// 1/√x for normal x > 0: half the exponent by the bits, then a step of Newton's method whose
/// coefficients, with the constant of the first guess, make the largest error least (6.5·10⁻⁴), and
/// a step of third order.
#[inline(always)]
pub(in crate::real) fn rsqrt(x: f32) -> f32 {
    let y = f32::from_bits(0x5f1f_fb5b_u32.wrapping_sub(x.to_bits() >> 1));
    let y = y * (1.6820704 - 0.70414866 * (x * y * y));
    let rest = 1.0 - x * y * y;
    y + y * rest * (0.5 + 0.375 * rest)
}
