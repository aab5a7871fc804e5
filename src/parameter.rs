//! The table of a model's parameters: what its type, constructors and descriptions follow from.

use crate::error::Range;

/// A parameter of a model, as the table of the model has it.
///
/// ```
/// use brdf::OrenNayar;
/// use brdf::parameter::Kind;
///
/// let sigma = &<OrenNayar>::PARAMETERS[1];
/// assert_eq!((sigma.name, sigma.symbol), ("sigma", "σ"));
/// assert!(matches!(sigma.kind, Kind::Number(range) if range.lower == 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Parameter {
    /// The name of the argument of constructors and of the key of descriptions.
    pub name: &'static str,
    /// The symbol in the formula, which may be empty.
    pub symbol: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// What values it has.
    pub kind: Kind,
    /// The value in a description without the key. Without a default the key must be there.
    pub default: Option<Preset>,
}

/// The values that a parameter may have.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Kind {
    /// A number.
    Number(Range),
    /// A number for all channels, or one for each.
    Color(Range),
    /// A number for all directions, or one along the tangent and one along the bitangent.
    Roughness(Range),
    /// A refractive index: the real part, or the real and the imaginary part.
    Index(Range, Range),
    /// True or false.
    Flag,
    /// One of a few words.
    Word(&'static [&'static str]),
    /// Any text.
    Text,
    /// A model, Fresnel term or distribution.
    Part(Part),
}

/// What a model consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Part {
    /// A model of reflection.
    Brdf,
    /// A Fresnel term.
    Fresnel,
    /// A distribution of facet normals.
    Distribution,
}

/// The value of a parameter that is not given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Preset {
    /// Of a number, or of all numbers of a colour, roughness or index.
    Number(f64),
    /// Of a flag.
    Flag(bool),
    /// Of a word.
    Word(&'static str),
}

impl Parameter {
    pub(crate) const fn new(
        name: &'static str,
        symbol: &'static str,
        meaning: &'static str,
        kind: Kind,
    ) -> Self {
        Self { name, symbol, meaning, kind, default: None }
    }

    /// This parameter with a value that it has where it is not given.
    pub(crate) const fn or(self, default: Preset) -> Self {
        Self { default: Some(default), ..self }
    }
}

impl Kind {
    /// How many numbers the value has at most: 0 if it has none.
    #[must_use]
    pub const fn most(self) -> usize {
        match self {
            Self::Number(_) => 1,
            Self::Roughness(_) | Self::Index(..) => 2,
            Self::Color(_) => 3,
            Self::Flag | Self::Word(_) | Self::Text | Self::Part(_) => 0,
        }
    }

    /// The range of one of the numbers.
    #[must_use]
    pub const fn range(self, index: usize) -> Option<Range> {
        match self {
            Self::Index(_, k) if index == 1 => Some(k),
            Self::Number(range)
            | Self::Color(range)
            | Self::Roughness(range)
            | Self::Index(range, _)
                if index < self.most() =>
            {
                Some(range)
            }
            _ => None,
        }
    }
}

/// Declares a model by the table of its parameters.
///
/// The table has a row for each parameter: what kind of value it has (a `color`, a `number`, a
/// `roughness`), its name, its range, its symbol and its meaning. `flags` choose between forms of the
/// model. `constants` are what formulas need and what is computed once, in the order in which they
/// stand, behind the checks of the ranges; they see the parameters, the flags and each other.
///
/// It writes the type, whose documentation has the rows, `PARAMETERS`, a getter for each parameter
/// with the range's check in front of each constructor, and [`Lift`](crate::Lift). A constructor
/// takes all parameters and says what the flags are. A model that none fits leaves them out and has
/// its own.
macro_rules! model {
    (
        $(#[$formula:meta])*
        parameters {
            $($parameter:ident: $type:ident $(<$of:ident>)?, $range:ident, $symbol:literal, $meaning:literal;)+
        }
        $(flags { $($flag:ident: $default:literal, $flag_meaning:literal;)+ })?
        $(constants {
            $(let $local:pat = $computed:expr;)*
            $($(#[$doc:meta])+ $constant:ident: $kept:ident $(<$kept_of:ident>)? = $value:expr;)+
        })?
        $(#[$rest:meta])*
        pub struct $name:ident<$($generic:ident = $default_generic:ty),+>;
        $($(#[$constructor_doc:meta])+ pub fn $new:ident $(($($set:ident: $to:literal),+))?;)*
    ) => {
        $(#[$formula])*
        ///
        /// # Parameters
        ///
        /// | symbol | parameter | meaning | range |
        /// |---|---|---|---|
        $(#[doc = concat!(
            "| ", $symbol, " | `", stringify!($parameter), "` | ", $meaning, " | ",
            $crate::error::shown!($range), " |"
        )])+
        $($(#[doc = concat!(
            "| | `", stringify!($flag), "` | ", $flag_meaning, " | ", stringify!($default),
            " where it is not given |"
        )])+)?
        $(#[$rest])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<$($generic = $default_generic),+> {
            $($parameter: $type $(<$of>)?,)+
            $($($(#[$doc])+ $constant: $kept $(<$kept_of>)?,)+)?
        }

        impl<$($generic),+> $name<$($generic),+> {
            /// The table of the parameters.
            pub const PARAMETERS: &'static [$crate::Parameter] = &[
                $($crate::parameter::model!(
                    @row $parameter: $type, $range, $symbol, $meaning
                ),)+
                $($($crate::Parameter::new(
                    stringify!($flag), "", $flag_meaning, $crate::parameter::Kind::Flag,
                ).or($crate::parameter::Preset::Flag($default)),)+)?
            ];

            $($crate::parameter::model!(@getter $parameter $type $meaning);)+
        }

        $crate::parameter::model!(
            @lift [$($generic)+] $name { $($parameter: $type,)+ $($($constant: $kept,)+)? }
        );
        $crate::parameter::model!(
            @constructors [$($generic)+] $name { $($parameter $type $(<$of>)?, $range;)+ }
            { $($($local = $computed;)*)? } { $($($constant = $value;)+)? }
            $({ $(#[$constructor_doc])+ $new $($($set $to,)+)? })*
        );
    };

    (@row $parameter:ident: $type:ident, $range:ident, $symbol:literal, $meaning:literal) => {
        $crate::Parameter::new(
            stringify!($parameter), $symbol, $meaning,
            $crate::parameter::model!(@kind $type)($crate::error::range::$range),
        )
    };
    (@kind C) => { $crate::parameter::Kind::Color };
    (@kind T) => { $crate::parameter::Kind::Number };
    (@kind Roughness) => { $crate::parameter::Kind::Roughness };

    // Where a trait has a method of that name, which is the model's, there is no getter.
    (@getter albedo $type:ident $meaning:literal) => {};
    (@getter reflectance $type:ident $meaning:literal) => {};
    (@getter $parameter:ident Roughness $meaning:literal) => {
        #[doc = concat!("The parameter `", stringify!($parameter), "`: ", $meaning, ".")]
        #[must_use]
        pub fn $parameter(&self) -> [T; 2]
        where
            T: Copy,
        {
            self.$parameter.along()
        }
    };
    (@getter $parameter:ident $type:ident $meaning:literal) => {
        #[doc = concat!("The parameter `", stringify!($parameter), "`: ", $meaning, ".")]
        #[must_use]
        pub fn $parameter(&self) -> $type
        where
            $type: Copy,
        {
            self.$parameter
        }
    };

    (@lift [C] $name:ident $fields:tt) => {
        $crate::real::lift! { [T: Real, C: Color<T>] $name<C> => $name<C::Over<U>>: $name $fields }
    };
    (@lift [C T] $name:ident $fields:tt) => {
        $crate::real::lift! {
            [T: Real, C: Color<T>] $name<C, T> => $name<C::Over<U>, U>: $name $fields
        }
    };
    (@lift [T] $name:ident $fields:tt) => {
        $crate::real::lift! { [T: Real] $name<T> => $name<U>: $name $fields }
    };

    (@constructors [C] $name:ident $parameters:tt $locals:tt $constants:tt $($one:tt)*) => {
        impl<C> $name<C> {
            $($crate::parameter::model!(
                @constructor [T: Real] [C: Color<T>] $parameters $locals $constants $one
            );)*
        }
    };
    (@constructors [C T] $name:ident $parameters:tt $locals:tt $constants:tt $($one:tt)*) => {
        impl<C, T> $name<C, T> {
            $($crate::parameter::model!(
                @constructor [] [T: Real, C: Color<T>] $parameters $locals $constants $one
            );)*
        }
    };
    (@constructors [T] $name:ident $parameters:tt $locals:tt $constants:tt $($one:tt)*) => {
        impl<T> $name<T> {
            $($crate::parameter::model!(
                @constructor [] [T: Real] $parameters $locals $constants $one
            );)*
        }
    };
    (@constructor [$($generics:tt)*] [$($bounds:tt)*]
        { $($parameter:ident $type:ident $(<$of:ident>)?, $range:ident;)+ }
        { $($local:pat = $computed:expr;)* } { $($constant:ident = $value:expr;)* }
        { $(#[$doc:meta])+ $new:ident $($set:ident $to:literal,)* }
    ) => {
        $(#[$doc])+
        ///
        /// # Errors
        $(#[doc = concat!(
            "If `", stringify!($parameter), "` is not in ", $crate::error::shown!($range), "."
        )])+
        pub fn $new<$($generics)*>(
            $($parameter: $type $(<$of>)?),+
        ) -> Result<Self, $crate::ParameterError>
        where
            $($bounds)*
        {
            $($crate::error::range::$range.check(stringify!($parameter), $parameter)?;)+
            $(let $parameter = $crate::parameter::model!(@kept $parameter $type);)+
            $(let $set = $to;)*
            $(let $local = $computed;)*
            $(let $constant = $value;)*
            Ok(Self { $($parameter,)+ $($constant),* })
        }
    };
    (@kept $color:ident C) => { $crate::real::unsigned($color) };
    (@kept $parameter:ident $type:ident) => { $parameter };
}
pub(crate) use model;
