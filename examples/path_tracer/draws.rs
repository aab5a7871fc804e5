//! Uniform numbers that fill the cube of all decisions of a path more evenly than random ones.

/// The numbers of one path: a point of Sobol's sequence, scrambled by a seed (B. Burley, *Practical
/// hash-based Owen scrambling*, JCGT 9(4), 2020). Paths of one seed keep apart from each other,
/// those of different seeds know nothing of each other.
#[derive(Clone, Debug)]
pub struct Draws {
    path: u32,
    seed: u32,
    set: u32,
}

impl Draws {
    pub const fn new(path: u32, seed: u32) -> Self {
        Self { path, seed, set: 0 }
    }

    /// The next four, in [0, 1).
    pub fn four(&mut self) -> [f32; 4] {
        const SETS: u32 = sobol_burley::NUM_DIMENSION_SETS_4D;
        let (set, round) = (self.set % SETS, self.set / SETS);
        self.set += 1;
        // Long paths begin the sequence again with another seed.
        let seed = self.seed.wrapping_add(round.wrapping_mul(0x9e37_79b9));
        sobol_burley::sample_4d(self.path, set, seed)
    }
}
