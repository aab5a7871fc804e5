// y 2^n for n in -152 .. 130, in two factors.
fn brdf_scaled(y: f32, n: i32) -> f32 {
    let half = n >> 1u;
    let first = bitcast<f32>((half + 127) << 23u);
    let second = bitcast<f32>((n - half + 127) << 23u);
    return y * first * second;
}
