// n ln 2 + ln(1 + f) for sqrt(1/2) <= 1 + f <= sqrt(2), by 2 artanh(f/(2 + f)).
fn brdf_ln_of_part(f: f32, n: f32) -> f32 {
    let s = f / (2.0 + f);
    let z = s * s;
    let tail = z * (0.66666776 + 0.39977568 * z + z * z * 0.29871076);
    let half = 0.5 * f * f;
    return n * 0.69314575 + (f - (half - (s * (half + tail) + n * 1.4286068e-6)));
}
