//! What the channels stand for that a description is built in.

/// Red, green and blue, or wavelengths.
#[derive(Clone, Copy)]
pub(super) enum Channels<'a> {
    Rgb,
    /// In nanometres.
    Wavelengths(&'a [f64]),
}

/// The wavelengths that red, green and blue stand for, in nanometres.
pub(super) const RGB: [f64; 3] = [650.0, 550.0, 450.0];

impl Channels<'_> {
    /// The wavelength of a channel, where red, green and blue have wavelengths of their own.
    pub(super) fn wavelength(self, channel: usize, own: [f64; 3]) -> f64 {
        let found = match self {
            Self::Rgb => own.get(channel),
            Self::Wavelengths(all) => all.get(channel),
        };
        found.copied().unwrap_or(f64::NAN)
    }

    /// The parts that the values for red, green and blue have in the value of a channel.
    ///
    /// A spectrum is a straight line between the wavelengths of the three, and constant beyond them.
    pub(super) fn shares(self, channel: usize, own: [f64; 3]) -> [(usize, f64); 2] {
        let Self::Wavelengths(_) = self else {
            return [(channel, 1.0), (channel, 0.0)];
        };
        let wavelength = self.wavelength(channel, own);
        let mut order = [0, 1, 2];
        order.sort_by(|one, other| own[*one].total_cmp(&own[*other]));
        let above = order.partition_point(|one| own[*one] <= wavelength);
        match (above.checked_sub(1).and_then(|below| order.get(below)), order.get(above)) {
            (Some(below), Some(above)) => {
                let part = (wavelength - own[*below]) / (own[*above] - own[*below]);
                [(*below, 1.0 - part), (*above, part)]
            }
            (Some(end), None) | (None, Some(end)) => [(*end, 1.0), (*end, 0.0)],
            (None, None) => [(0, 1.0), (0, 0.0)],
        }
    }

    /// The channel whose index counts where all channels have one direction: the middle one.
    pub(super) fn middle(self) -> usize {
        match self {
            Self::Rgb => 1,
            Self::Wavelengths(all) => all.len() / 2,
        }
    }
}
