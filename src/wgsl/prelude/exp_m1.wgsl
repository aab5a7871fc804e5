// e^x - 1, accurate near 0.
fn brdf_exp_m1(x: f32) -> f32 {
    let bounded = clamp(x, -30.0, 89.0);
    let n = round(bounded * 1.442695);
    let high = brdf_rounded(bounded - n * 0.69314575);
    let low = n * 1.4286068e-6;
    let r = brdf_rounded(high - low);
    let r2 = r * r;
    let polynomial = 0.49999994 + 0.16666515 * r
        + r2 * (0.041668084 + 0.008369369 * r + r2 * 0.0013841367);
    let rest = r2 * polynomial + ((high - r) - low);
    if n == 0.0 {
        return r + rest;
    }
    // Half of 2^n (1 + r + rest) - 1, so that n = 128 does not overflow.
    let scale = bitcast<f32>((i32(n) + 126) << 23u);
    let sum = (scale - 0.5) + scale * r;
    let lost = scale * r - (sum - (scale - 0.5));
    let y = sum + (lost + scale * rest);
    return y + y;
}
