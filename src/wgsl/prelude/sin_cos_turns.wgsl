// Sine and cosine of 2 pi x.
fn brdf_sin_cos_turns(x: f32) -> vec2<f32> {
    let n = round(4.0 * clamp(x, -1e8, 1e8));
    let r = clamp(x - 0.25 * n, -0.125, 0.125);
    return brdf_in_quadrant(6.2831855 * r, 0.0, i32(n));
}
