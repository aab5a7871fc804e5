//! How a model is declared.

/// Declares a model by the table of its parameters, which stands in the middle of its documentation.
///
/// ```text
/// model! {
///     /// What it is and the formula.
///     parameters {
///         albedo: C, UNIT, "ρ", "fraction of the light that is reflected";
///     }
///     flags {
///         normalized: true, "what it chooses";
///     }
///     constants {
///         let twice = …;
///         /// A.
///         a: T = …;
///     }
///     /// The rest of the documentation.
///     pub struct Name<C = glam::Vec3, T = f32>;
///
///     /// A constructor.
///     pub fn new(normalized: true);
/// }
/// ```
///
/// A row of the table has the name of a parameter, its type (`C` for a colour, `T` for a number,
/// `Roughness<T>`), its range, perhaps `= …`, which descriptions take where it is not given, its symbol
/// and its meaning. Flags choose between forms of the model. Constants are what formulas need of the
/// parameters: they are computed once, in their order, behind the checks of the ranges, and see
/// the parameters, the flags and each other.
///
/// What follows is the type, its `PARAMETERS`, a getter for each of them, [`Lift`](crate::Lift), and
/// the constructors: they take all parameters and say what the flags are. A model that no such
/// constructor fits leaves them out and has its own.
macro_rules! model {
    (
        $(#[$formula:meta])*
        parameters {
            $(
                $parameter:ident: $type:ident $(<$of:ident>)?, $range:ident $(= $preset:literal)?,
                $symbol:literal, $meaning:literal;
            )+
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
            $crate::error::shown!($range), $(", ", stringify!($preset), " by default",)? " |"
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
                    @row $parameter: $type, $range $(= $preset)?, $symbol, $meaning
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

    (
        @row $parameter:ident: $type:ident, $range:ident $(= $preset:literal)?,
        $symbol:literal, $meaning:literal
    ) => {
        $crate::Parameter::new(
            stringify!($parameter), $symbol, $meaning,
            $crate::parameter::model!(@kind $type)($crate::error::range::$range),
        )
        $(.or($crate::parameter::Preset::Number($preset)))?
    };
    (@kind C) => { $crate::parameter::Kind::Color };
    (@kind T) => { $crate::parameter::Kind::Number };
    (@kind Roughness) => { $crate::parameter::Kind::Roughness };

    // Where a trait has a method of that name, which is the model's, there is no getter.
    // `albedo` is what a model answers for a direction.
    (@getter albedo $type:ident $meaning:literal) => {
        #[doc = concat!("The parameter `albedo`, ρ: ", $meaning, ".")]
        #[must_use]
        pub fn rho(&self) -> $type
        where
            $type: Copy,
        {
            self.albedo
        }
    };
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
    (@kept $color:ident C) => { $crate::real::positive_zero($color) };
    (@kept $parameter:ident $type:ident) => { $parameter };
}
pub(crate) use model;
