// e^x: x = n ln 2 + r, a polynomial in r, and 2^n by its bits.
fn brdf_exp(x: f32) -> f32 {
    let bounded = clamp(x, -105.0, 90.0);
    let n = round(bounded * 1.442695);
    let r = brdf_rounded(bounded - n * 0.69314575) - n * 1.4286068e-6;
    let r2 = r * r;
    let rest = 0.49999994 + 0.16666515 * r
        + r2 * (0.041668084 + 0.008369369 * r + r2 * 0.0013841367);
    return select(brdf_scaled(1.0 + (r + r2 * rest), i32(n)), 0.0, x < -104.0);
}
