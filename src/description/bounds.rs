//! What keeps a description from an unknown source small.

/// How many sums and mixtures may stand inside each other.
pub const MAX_DEPTH: usize = 32;

/// How many terms all sums and mixtures of a description may have together.
pub const MAX_TERMS: usize = 1024;

/// How many samples of optical constants a description may have altogether.
pub const MAX_SAMPLES: usize = 8192;
