// Sine and cosine of an angle in radians, |x| <= 10^4.
fn brdf_sin_cos(x: f32) -> vec2<f32> {
    let n = round(clamp(x, -1e9, 1e9) * 0.63661975);
    let high = brdf_rounded((x - n * 1.5703125) - n * 0.0004837513);
    let low = n * 7.5495336e-8;
    let r = brdf_rounded(high - low);
    let lost = n * 2.563344e-12 + (low - (high - r));
    let excess = select(0.0, lost, abs(lost) < 1e-6);
    return brdf_in_quadrant(clamp(r, -0.7865, 0.7865), excess, i32(n));
}
