// The inverse of the error function; finite at the ends.
fn brdf_erf_inv(x: f32) -> f32 {
    let a = min(abs(x), 0.99999994);
    let w = -brdf_ln((1.0 - a) * (1.0 + a));
    let z = w * w;
    let inner = 0.8862269 + 0.23201485 * w + z * (0.0115426285 - 0.0023209122 * w
        + z * (-0.00014218294 + 5.354599e-5 * w + z * (7.858214e-7 - 1.3171839e-6 * w
        + z * (1.4810193e-7 - 5.4439213e-9 * w))));
    let s = sqrt(w) - 3.0;
    let q = s * s;
    let outer = 2.8329768 + 1.0016748 * s + q * (0.009444296 - 0.0076348265 * s
        + q * (0.005695254 - 0.0036089558 * s + q * (0.0014637966 - 3.4145338e-5 * s
        + q * (-0.00029267382 + 9.9486824e-5 * s))));
    return brdf_copysign(a * select(outer, inner, w < 5.0), x);
}
