//! The elementary functions of the crate in `f32`, in the language of shaders.
//!
//! Those of the language are too inaccurate: its sine may be off by 2⁻¹¹, its power by more. They are
//! the algorithms of the crate for `f32`, but for what a compiler for graphics may undo: it may take
//! (x + y) − y for x, and joins products and sums. So whole numbers are made by `round` and not by
//! adding a large number, what has 24 bits is split by its bits, and where a difference near 0 counts, a
//! formula of its own serves. There is no `f64` in shaders: functions that use it in the crate have
//! forms of their own here.
//!
//! Each file has one function, beginning with its name; it may use others.

/// Declares the functions: a name for Rust, and their files.
macro_rules! functions {
    ($($function:ident $file:literal)*) => {
        /// A function of the prelude.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub(super) enum Function { $($function,)* }

        impl Function {
            /// All of them: those that others use come first.
            pub(super) const ALL: &'static [Self] = &[$(Self::$function,)*];

            pub(super) const fn name(self) -> &'static str {
                match self { $(Self::$function => concat!("brdf_", $file),)* }
            }

            pub(super) const fn text(self) -> &'static str {
                match self { $(Self::$function => include_str!(concat!("prelude/", $file, ".wgsl")),)* }
            }
        }
    };
}

functions! {
    Rounded "rounded"
    Rounded3 "rounded_3"
    Scaled "scaled"
    Upper "upper"
    Copysign "copysign"
    Clamped "clamped"
    Rsqrt "rsqrt"
    Exp "exp"
    ExpM1 "exp_m1"
    LnOfPart "ln_of_part"
    Ln "ln"
    Ln1p "ln_1p"
    Powf "powf"
    PowerOfPart "power_of_part"
    Decay "decay"
    InQuadrant "in_quadrant"
    SinCos "sin_cos"
    SinCosTurns "sin_cos_turns"
    Tan "tan"
    ArcTail "arc_tail"
    Asin "asin"
    Acos "acos"
    AngleSquared "angle_squared"
    Atan2 "atan2"
    ErfcTail "erfc_tail"
    Erf "erf"
    Erfc "erfc"
    Erfcx "erfcx"
    Ierfc "ierfc"
    ErfInv "erf_inv"
}

impl Function {
    /// The functions that this one calls.
    pub(super) fn needs(self) -> impl Iterator<Item = Self> {
        let calls = move |other: &Self| {
            let text = self.text();
            let mut found = text.match_indices(other.name());
            *other != self && found.any(|(at, name)| text[at + name.len()..].starts_with('('))
        };
        Self::ALL.iter().copied().filter(calls)
    }
}
