//! The one place that knows about instruction sets.

use core::sync::atomic::{AtomicU8, Ordering};

/// What batches are compiled for, from the least to the most.
///
/// Every batch runs on the best set of the machine. Results have the same bits on all of them, so
/// the choice is a matter of speed alone, and [`select`](Self::select) is for measuring and testing.
///
/// ```
/// use brdf::batch::InstructionSet;
///
/// let best = InstructionSet::available().last();
/// assert_eq!(best, Some(InstructionSet::selected()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum InstructionSet {
    /// What the target of the build has: SSE2 on x86-64, NEON on AArch64.
    Baseline,
    /// AVX2 on x86-64.
    Avx2,
    /// AVX-512 of Ice Lake, Zen 4 and later.
    Avx512,
}

const ALL: [InstructionSet; 3] =
    [InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512];

/// The place in [`ALL`] of the selected one, counted from 1; 0 stands for the best.
static SELECTED: AtomicU8 = AtomicU8::new(0);

impl InstructionSet {
    /// The sets that this machine has, the best one last.
    pub fn available() -> impl Iterator<Item = Self> {
        ALL.into_iter().filter(|set| set.is_available())
    }

    /// The set that batches run on.
    #[must_use]
    pub fn selected() -> Self {
        let place = usize::from(SELECTED.load(Ordering::Relaxed));
        match place.checked_sub(1).and_then(|index| ALL.get(index)) {
            Some(&set) => set,
            None => Self::available().last().unwrap_or(Self::Baseline),
        }
    }

    /// Runs all batches of this process on this set from now on. Where the machine lacks it, they
    /// stay on what they are on, and the answer is false.
    pub fn select(self) -> bool {
        let available = self.is_available();
        if available {
            SELECTED.store(self as u8 + 1, Ordering::Relaxed);
        }
        available
    }

    #[cfg(all(feature = "simd", any(target_arch = "x86", target_arch = "x86_64")))]
    fn is_available(self) -> bool {
        let level = fearless_simd::Level::new();
        match self {
            Self::Baseline => true,
            Self::Avx2 => level.as_avx2().is_some(),
            Self::Avx512 => level.as_avx512().is_some(),
        }
    }

    #[cfg(not(all(feature = "simd", any(target_arch = "x86", target_arch = "x86_64"))))]
    fn is_available(self) -> bool {
        self == Self::Baseline
    }

    /// Runs `work` compiled for this set. What it calls takes part only if it is always inlined:
    /// functions with `#[inline(always)]`, closures with the same attribute.
    #[cfg(all(feature = "simd", any(target_arch = "x86", target_arch = "x86_64")))]
    #[inline(always)]
    pub fn run<R>(self, work: impl FnOnce() -> R) -> R {
        use fearless_simd::Simd;

        let level = fearless_simd::Level::new();
        match (self, level.as_avx2(), level.as_avx512()) {
            (Self::Avx512, _, Some(avx512)) => avx512.vectorize(work),
            (Self::Avx2, Some(avx2), _) => avx2.vectorize(work),
            _ => work(),
        }
    }

    /// Runs `work`.
    #[cfg(not(all(feature = "simd", any(target_arch = "x86", target_arch = "x86_64"))))]
    #[inline(always)]
    pub fn run<R>(self, work: impl FnOnce() -> R) -> R {
        work()
    }
}
