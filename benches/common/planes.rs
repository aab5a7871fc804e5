//! Inputs and outputs of batches as separate components.

use brdf::batch::{ColorBuffer, DirectionBuffer, Directions, SampleBuffer, Uniforms};
use glam::DVec3;

macro_rules! planes {
    ($name:ident, $float:ident, $vector:ident) => {
        pub struct $name {
            wi: [Vec<$float>; 3],
            wo: [Vec<$float>; 3],
            u: [Vec<$float>; 2],
            out: [Vec<$float>; 7],
        }

        impl $name {
            pub fn new(pairs: &[(DVec3, DVec3)], uniforms: &[[f64; 2]]) -> Self {
                let axis = |at: fn(&(DVec3, DVec3)) -> DVec3, axis: usize| {
                    pairs.iter().map(|pair| at(pair)[axis] as $float).collect()
                };
                Self {
                    wi: [0, 1, 2].map(|k| axis(|pair| pair.0, k)),
                    wo: [0, 1, 2].map(|k| axis(|pair| pair.1, k)),
                    u: [0, 1].map(|k| {
                        uniforms.iter().cycle().take(pairs.len()).map(|u| u[k] as $float).collect()
                    }),
                    out: std::array::from_fn(|_| vec![0.0; pairs.len()]),
                }
            }

            pub fn wi(&self, index: usize) -> glam::$vector {
                glam::$vector::new(self.wi[0][index], self.wi[1][index], self.wi[2][index])
            }

            pub fn wo(&self, index: usize) -> glam::$vector {
                glam::$vector::new(self.wo[0][index], self.wo[1][index], self.wo[2][index])
            }

            pub fn len(&self) -> usize {
                self.wi[0].len()
            }

            pub fn eval(
                &mut self,
            ) -> (
                Directions<'_, $float>,
                Directions<'_, $float>,
                ColorBuffer<'_, $float, glam::$vector>,
            ) {
                let [r, g, b, ..] = &mut self.out;
                let (wi, wo) = (self.wi.each_ref(), self.wo.each_ref());
                (wi.into(), wo.into(), ColorBuffer::from([r, g, b]))
            }

            pub fn pdf(
                &mut self,
            ) -> (Directions<'_, $float>, Directions<'_, $float>, &mut [$float]) {
                (self.wi.each_ref().into(), self.wo.each_ref().into(), &mut self.out[0])
            }

            pub fn sample(
                &mut self,
            ) -> (
                Directions<'_, $float>,
                Uniforms<'_, $float>,
                SampleBuffer<'_, $float, glam::$vector>,
            ) {
                let [x, y, z, r, g, b, pdf] = &mut self.out;
                let samples = SampleBuffer {
                    wi: DirectionBuffer::Planes([x, y, z]),
                    weight: ColorBuffer::from([r, g, b]),
                    pdf,
                };
                (self.wo.each_ref().into(), self.u.each_ref().into(), samples)
            }

            /// Cosines, and room for as many reflectances.
            pub fn cosines(&mut self) -> (&[$float], &mut [$float]) {
                (&self.wi[2], &mut self.out[0])
            }

            /// Cosines, and room for as many colours.
            pub fn cosines_and_colors(
                &mut self,
            ) -> (&[$float], ColorBuffer<'_, $float, glam::$vector>) {
                let [r, g, b, ..] = &mut self.out;
                (&self.wi[2], ColorBuffer::from([r, g, b]))
            }

            /// A loop that calls a formula for every pair and stores what it says.
            pub fn each(
                &mut self,
                formula: impl Fn(glam::$vector, glam::$vector) -> glam::$vector,
            ) {
                for index in 0..self.len() {
                    let value = formula(self.wi(index), self.wo(index));
                    self.out[0][index] = value.x;
                    self.out[1][index] = value.y;
                    self.out[2][index] = value.z;
                }
            }

            /// The same for numbers.
            pub fn each_number(
                &mut self,
                formula: impl Fn(glam::$vector, glam::$vector) -> $float,
            ) {
                for index in 0..self.len() {
                    self.out[0][index] = formula(self.wi(index), self.wo(index));
                }
            }
        }
    };
}
planes!(Planes, f32, Vec3);
planes!(DoublePlanes, f64, DVec3);
