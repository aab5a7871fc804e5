// Sine and cosine of r + quadrant pi/2; what r exceeds the angle by is taken from the sine and, times
// r, added to the cosine.
fn brdf_in_quadrant(r: f32, excess: f32, quadrant: i32) -> vec2<f32> {
    let z = r * r;
    let sin = r - (excess + r * z * (0.16666655 - 0.008332187 * z + z * z * 0.00019517838));
    let tail = z * z * (0.041666646 - 0.001388731 * z + z * z * 2.4432322e-5);
    let cos = 1.0 - (0.5 * z - (tail + r * excess));
    let turned = select(vec2<f32>(sin, cos), vec2<f32>(cos, sin), (quadrant & 1) == 1);
    let signs = vec2<u32>(vec2<i32>(quadrant, quadrant + 1) & vec2<i32>(2)) << vec2<u32>(30u);
    return bitcast<vec2<f32>>(bitcast<vec2<u32>>(turned) ^ signs);
}
