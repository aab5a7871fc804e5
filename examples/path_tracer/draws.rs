//! Uniform numbers that fill the cube of all decisions of a path more evenly than random ones.

/// The numbers of one path: a point of Sobol's sequence, scrambled by a seed (B. Burley, *Practical
/// hash-based Owen scrambling*, JCGT 9(4), 2020). Paths of one seed keep apart from each other,
/// those of different seeds know nothing of each other.
#[derive(Clone, Debug)]
pub struct Draws {
    path: u32,
    seed: u32,
    dimension: u32,
}

impl Draws {
    pub const fn new(path: u32, seed: u32) -> Self {
        Self { path, seed, dimension: 0 }
    }

    /// The next number, in [0, 1).
    pub fn number(&mut self) -> f32 {
        let dimension = self.dimension % sobol_burley::NUM_DIMENSIONS;
        let round = self.dimension / sobol_burley::NUM_DIMENSIONS;
        self.dimension += 1;
        // Long paths begin the sequence again with another seed.
        let seed = self.seed.wrapping_add(round.wrapping_mul(0x9e37_79b9));
        sobol_burley::sample(self.path, dimension, seed)
    }

    /// The next numbers.
    pub fn numbers<const N: usize>(&mut self) -> [f32; N] {
        std::array::from_fn(|_| self.number())
    }
}
