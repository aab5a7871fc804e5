// The upper 12 bits of a number: products of two such numbers are exact.
fn brdf_upper(x: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(x) & 0xfffff000u);
}
