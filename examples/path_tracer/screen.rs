//! What a screen shows of a colour in linear sRGB.

use glam::Vec3;

/// The values of a screen, 0 … 1, for a colour that may be brighter than the screen.
pub fn value(color: Vec3) -> Vec3 {
    encode(tone(color))
}

/// Up to a largest channel of 0.76 a colour is shown as it is. Above, the largest channel bends
/// towards 1 without reaching it, and the colour fades to white (as in the tone mapper *Khronos PBR
/// Neutral*, without its darkening of the dark).
fn tone(color: Vec3) -> Vec3 {
    const START: f32 = 0.76;
    const REST: f32 = 1.0 - START;
    let color = color.max(Vec3::ZERO);
    let peak = color.max_element();
    if peak < START {
        return color;
    }
    let shown = 1.0 - REST * REST / (peak - START + REST);
    let fade = 1.0 - 1.0 / (1.0 + 0.15 * (peak - shown));
    (color * (shown / peak)).lerp(Vec3::splat(shown), fade)
}

/// The sRGB transfer function.
pub fn encode(linear: Vec3) -> Vec3 {
    let channel = |linear: f32| {
        if linear <= 0.0031308 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
    };
    Vec3::new(channel(linear.x), channel(linear.y), channel(linear.z))
}

/// A screen's values in eight bits.
pub fn bytes(value: Vec3) -> [u8; 3] {
    value.to_array().map(|value| (value.clamp(0.0, 1.0) * 255.0).round() as u8)
}
