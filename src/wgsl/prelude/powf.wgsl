// x to the power y for x >= 0, by 2^(y log2(x)) with both factors in two parts; 0^0 = 1.
fn brdf_powf(x: f32, y: f32) -> f32 {
    let subnormal = x < 1.1754944e-38;
    let bits = bitcast<u32>(select(x, x * 16777216.0, subnormal)) + 0x004afb0du;
    let mantissa = bitcast<f32>((bits & 0x007fffffu) + 0x3f3504f3u);
    let exponent = f32(i32(bits >> 23u) - select(127, 151, subnormal));
    // log2 of the mantissa is 2/ln 2 artanh of s = f/(2 + f).
    let f = mantissa - 1.0;
    let below = 2.0 + f;
    let s = f / below;
    let s_upper = brdf_upper(s);
    let below_upper = brdf_upper(below);
    let below_lower = f - (below_upper - 2.0);
    let s_lower = ((f - s_upper * below_upper) - s_upper * below_lower) / below;
    let z = s * s;
    let series = s * z * (0.9617967 + 0.5770836 * z + z * z * (0.4116727 + 0.3407301 * z));
    // 2/ln 2 = 2.884765625 + 0.00062445678.
    let high = 2.884765625 * s_upper;
    let log2_upper = brdf_upper(high);
    let low = 0.00062445678 * s + 2.884765625 * s_lower + series;
    let log2_lower = (high - log2_upper) + low;
    // y (exponent + log2), of which the whole part becomes bits.
    let y_upper = brdf_upper(y);
    let y_lower = y - y_upper;
    let n = round(clamp(y * (exponent + (log2_upper + log2_lower)), -152.0, 130.0));
    let large = (y_upper * exponent - n) + y_upper * log2_upper;
    let small = y_lower * (exponent + log2_upper) + y * log2_lower;
    let r = clamp(large + small, -1.0, 1.0);
    let r2 = r * r;
    let power = 1.0 + r * (0.6931472 + 0.24022648 * r
        + r2 * (0.055503596 + 0.009618499 * r + r2 * (0.0013390972 + 0.00015329332 * r)));
    let inside = select(brdf_scaled(power, i32(n)), 0.0, n < -151.0);
    let end = select(0.0, 3.40282346e38, (x > 0.0) == (y > 0.0));
    let at_end = x <= 0.0 || x > 3.40282346e38;
    return select(select(inside, end, at_end), 1.0, y == 0.0);
}
