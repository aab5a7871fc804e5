// The angle of the point (x, y), 0 at the origin.
fn brdf_atan2(y: f32, x: f32) -> f32 {
    let ax = min(abs(x), 3.40282346e38);
    let ay = min(abs(y), 3.40282346e38);
    let steep = ay > ax;
    let larger = max(ax, ay);
    let t = min(ax, ay) / select(larger, 1.0, larger == 0.0);
    // The angle to the nearer axis is t + tail.
    let z = t * t;
    let q = z * z;
    let tail = t * z * (-0.333333 + 0.1999853 * z + q * (-0.14264013 + 0.10950848 * z
        + q * (-0.08399164 + 0.05787806 * z + q * (-0.03109268 + 0.010865793 * z
        + q * -0.0017820332))));
    let left = x < 0.0;
    let away = select(-1.0, 1.0, steep == left);
    let axis = select(select(0.0, 3.1415927, left), 1.5707964, steep);
    let axis_low = select(select(0.0, -8.742278e-8, left), -4.371139e-8, steep);
    let sum = brdf_rounded(axis + away * t);
    let lost = away * t - (sum - axis);
    return brdf_copysign(sum + (lost + (away * tail + axis_low)), y);
}
