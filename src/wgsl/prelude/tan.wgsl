// Tangent of an angle in radians, |x| <= 10^4.
fn brdf_tan(x: f32) -> f32 {
    let y = brdf_sin_cos(x);
    return y.x / y.y;
}
