// x moved to lower .. upper; lower for what is not a number.
fn brdf_clamped(x: f32, lower: f32, upper: f32) -> f32 {
    return select(lower, min(x, upper), x > lower);
}
