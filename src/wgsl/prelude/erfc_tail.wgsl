// erfc(x) for x >= 0.74: e^(-x^2)/(1 + 2x) times a polynomial in (x - 3)/(x + 3).
fn brdf_erfc_tail(x: f32) -> f32 {
    let u = (x - 3.0) / (x + 3.0);
    let z = u * u;
    let slow = 1.2530081 - 0.1356211 * u + z * (-0.04756216 + 0.12964447 * u
        + z * (-0.11927682 + 0.068317555 * u + z * (-0.023744613 + 0.0024755597 * u
        + z * (0.0018013206 - 0.00064685306 * u))));
    // x^2 as the square of the upper bits, which is exact, and the rest.
    let upper = brdf_upper(x);
    let rest = (x - upper) * (x + upper);
    return brdf_exp(-upper * upper) * (brdf_exp(-rest) * slow / (1.0 + 2.0 * x));
}
