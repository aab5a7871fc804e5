//! Light from all around: a photographed environment, and how to draw directions from it.

use std::error::Error;
use std::f32::consts::{PI, TAU};

use glam::Vec3;
use image::{ImageFormat, Rgb};

/// Radiance from every direction: an equirectangular picture, +y up, turned about the vertical.
#[derive(Debug)]
pub struct Environment {
    width: usize,
    height: usize,
    radiance: Vec<Vec3>,
    turn: f32,
    /// Share of the light in all rows up to and with this one.
    rows: Vec<f32>,
    /// Share of a row's light in its texels up to and with this one.
    columns: Vec<f32>,
}

/// A round lamp, far away.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Its centre; of any length, +y up.
    pub towards: Vec3,
    /// Its angular radius in radians.
    pub radius: f32,
    /// Per channel.
    pub radiance: Vec3,
}

impl Environment {
    /// Decodes a Radiance picture; `turn` (a fraction of a full turn) is added to the azimuth,
    /// `exposure` multiplies all radiance, and the lamp shines before it.
    pub fn new(file: &[u8], turn: f32, exposure: Vec3, lamp: Lamp) -> Result<Self, Box<dyn Error>> {
        let picture = image::load_from_memory_with_format(file, ImageFormat::Hdr)?.into_rgb32f();
        let (width, height) = (picture.width() as usize, picture.height() as usize);
        let towards = lamp.towards.normalize();
        let texel = |(x, y, pixel): (u32, u32, &Rgb<f32>)| {
            let azimuth = TAU * ((x as f32 + 0.5) / width as f32 - turn);
            let (sin, cos) = (PI * (y as f32 + 0.5) / height as f32).sin_cos();
            let direction = Vec3::new(sin * azimuth.cos(), cos, sin * azimuth.sin());
            let photograph = Vec3::from_array(pixel.0) * exposure;
            let lit = direction.dot(towards) > lamp.radius.cos();
            if lit { photograph + lamp.radiance } else { photograph }
        };
        let radiance = picture.enumerate_pixels().map(texel).collect();
        Ok(Self::tabulated(width, height, radiance, turn))
    }

    fn tabulated(width: usize, height: usize, radiance: Vec<Vec3>, turn: f32) -> Self {
        let mut environment =
            Self { width, height, radiance, turn, rows: Vec::new(), columns: Vec::new() };
        environment.tabulate();
        environment
    }

    /// The cumulated shares: in proportion to mean radiance and solid angle of each texel.
    fn tabulate(&mut self) {
        let mut total = 0.0;
        for row in 0..self.height {
            let sin = (PI * (row as f32 + 0.5) / self.height as f32).sin();
            let mut sum = 0.0;
            for column in 0..self.width {
                sum += self.mean_around(column, row) * sin;
                self.columns.push(sum);
            }
            for share in &mut self.columns[row * self.width..] {
                *share /= sum;
            }
            total += sum;
            self.rows.push(total);
        }
        for share in &mut self.rows {
            *share /= total;
        }
    }

    /// Mean over the channels and over the bilinear interpolation within a texel, which reaches
    /// half a texel into the neighbours.
    fn mean_around(&self, column: usize, row: usize) -> f32 {
        let weights = [0.125, 0.75, 0.125];
        let mut sum = 0.0;
        for (dy, wy) in weights.iter().enumerate() {
            for (dx, wx) in weights.iter().enumerate() {
                let y = (row + dy).saturating_sub(1).min(self.height - 1);
                let x = (column + dx + self.width - 1) % self.width;
                sum += wx * wy * self.radiance[y * self.width + x].element_sum() / 3.0;
            }
        }
        sum
    }

    /// Radiance from a direction, interpolated.
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        let [u, v] = self.coordinates(direction);
        let (x, y) = (u * self.width as f32 - 0.5, v * self.height as f32 - 0.5);
        let (fx, fy) = (x - x.floor(), y - y.floor());
        let texel = |dx: i64, dy: i64| {
            let column = (x.floor() as i64 + dx).rem_euclid(self.width as i64) as usize;
            let row = (y.floor() as i64 + dy).clamp(0, self.height as i64 - 1) as usize;
            self.radiance[row * self.width + column]
        };
        texel(0, 0).lerp(texel(1, 0), fx).lerp(texel(0, 1).lerp(texel(1, 1), fx), fy)
    }

    /// Draws a direction in proportion to the radiance, with its density per steradian.
    pub fn sample(&self, u: [f32; 2]) -> (Vec3, f32) {
        let (row, y) = invert(&self.rows, u[0]);
        let (column, x) = invert(&self.columns[row * self.width..(row + 1) * self.width], u[1]);
        let azimuth = TAU * ((column as f32 + x) / self.width as f32 - self.turn);
        let polar = PI * (row as f32 + y) / self.height as f32;
        let (sin, cos) = polar.sin_cos();
        let direction = Vec3::new(sin * azimuth.cos(), cos, sin * azimuth.sin());
        (direction, self.density(column, row, sin))
    }

    /// The density per steradian with which [`sample`](Self::sample) draws a direction.
    pub fn pdf(&self, direction: Vec3) -> f32 {
        let [u, v] = self.coordinates(direction);
        let column = ((u * self.width as f32) as usize).min(self.width - 1);
        let row = ((v * self.height as f32) as usize).min(self.height - 1);
        self.density(column, row, direction.x.hypot(direction.z))
    }

    fn density(&self, column: usize, row: usize, sin: f32) -> f32 {
        let first = row * self.width;
        let share = share(&self.rows, row) * share(&self.columns[first..], column);
        let texels = (self.width * self.height) as f32;
        // A texel covers 2π/width · π/height · sinθ; at the very pole it has no extent.
        share * texels / (TAU * PI * sin.max(1e-6))
    }

    /// Azimuth and polar angle, each as 0 … 1.
    fn coordinates(&self, direction: Vec3) -> [f32; 2] {
        let azimuth = direction.z.atan2(direction.x) / TAU + self.turn;
        [azimuth - azimuth.floor(), direction.y.clamp(-1.0, 1.0).acos() / PI]
    }
}

/// The step of a cumulated distribution in which a number lies, and where in it (0 … 1).
fn invert(cumulated: &[f32], u: f32) -> (usize, f32) {
    let step = cumulated.partition_point(|end| *end <= u).min(cumulated.len() - 1);
    let before = if step == 0 { 0.0 } else { cumulated[step - 1] };
    (step, ((u - before) / share(cumulated, step)).clamp(0.0, 1.0))
}

fn share(cumulated: &[f32], step: usize) -> f32 {
    if step == 0 { cumulated[0] } else { cumulated[step] - cumulated[step - 1] }
}
