// 1/sqrt(x) of a normal number x > 0; of 0 a large finite number.
fn brdf_rsqrt(x: f32) -> f32 {
    let guess = bitcast<f32>(0x5f1ffb5bu - (bitcast<u32>(x) >> 1u));
    let y = guess * (1.6820704 - 0.70414866 * (x * guess * guess));
    let rest = 1.0 - x * y * y;
    return y + y * rest * (0.5 + 0.375 * rest);
}
