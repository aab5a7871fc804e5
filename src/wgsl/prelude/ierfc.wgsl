// The integral of erfc from x >= 0 to infinity, to 3.2e-7 of its sum with x.
fn brdf_ierfc(x: f32) -> f32 {
    let y = min(x, 3.6);
    let z = y * y;
    let root = 0.7511256 - 0.66566753 * y + z * (0.08058049 + 0.07161661 * y
        + z * (-0.0045323656 - 0.008595576 * y + z * (-0.00336008 + 0.0041457643 * y
        + z * (-0.001311356 + 0.00018358196 * y + z * -9.860668e-6))));
    return root * root;
}
