// x itself: a bound, far out, that keeps compilers from taking (x - y) + y for x.
fn brdf_rounded_3(x: vec3<f32>) -> vec3<f32> {
    return clamp(x, vec3<f32>(-3e38), vec3<f32>(3e38));
}
