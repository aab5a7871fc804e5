// 2^-x times a factor, for x >= 0; lifted, so that the power has all its digits where the product has.
fn brdf_decay(x: f32, factor: f32) -> f32 {
    let e = min(x, 174.0);
    let n = round(e);
    let r = n - e;
    let r2 = r * r;
    let power = 1.0 + r * (0.6931472 + 0.24022648 * r
        + r2 * (0.0555036 + 0.009618506 * r + r2 * (0.0013390806 + 0.00015326471 * r)));
    let lifted = brdf_scaled(power, 48 - i32(n)) * factor;
    return lifted * select(0.0, 3.5527137e-15, lifted >= 3.3087225e-24 && x < 174.0);
}
