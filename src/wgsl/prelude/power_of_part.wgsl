// (x/(x + rest))^exponent, in base 2 from beginning to end.
fn brdf_power_of_part(x: f32, rest: f32, exponent: f32) -> f32 {
    let whole = x + rest;
    // The bits of a positive number are its logarithm, to 0.0861 and in units of 2^-23.
    let k = (bitcast<u32>(whole) - bitcast<u32>(x) + 0x00400000u) >> 23u;
    let scaled = bitcast<f32>(bitcast<u32>(x) + (k << 23u));
    // Where k is 0 only what is missing remains.
    let difference = select((scaled - x) - rest, -rest, k == 0u);
    let s = difference / (scaled + whole);
    let z = s * s;
    let log2 = s * (2.88539 + 0.9618172 * z + z * z * (0.5753532 + 0.45688754 * z)) - f32(k);
    let e = max(exponent * log2, -152.0);
    let n = round(e);
    let r = e - n;
    let r2 = r * r;
    let power = 1.0 + r * (0.6931472 + 0.24022648 * r
        + r2 * (0.055503596 + 0.009618499 * r + r2 * (0.0013390972 + 0.00015329332 * r)));
    return select(brdf_scaled(power, i32(n)), 0.0, e < -151.0);
}
