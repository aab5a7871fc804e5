//! What functions of a module take and give.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::expr::{Expr, ExprVec3};
use super::graph::input;
use super::simplify::component;
use super::value::Width;

mod sealed {
    /// What a type of this crate promises.
    pub trait Sealed {}
    impl Sealed for super::Expr {}
    impl Sealed for super::ExprVec3 {}
    impl Sealed for [super::Expr; 2] {}
}

/// An argument of a function: `f32`, two of them as `vec2<f32>`, `vec3<f32>`.
pub trait Argument: sealed::Sealed + Copy {
    #[doc(hidden)]
    const KIND: &'static str;
    #[doc(hidden)]
    fn symbol(name: &str) -> Self;
}

impl Argument for Expr {
    const KIND: &'static str = "f32";
    fn symbol(name: &str) -> Self {
        Self(input(name.into(), Width::One))
    }
}

impl Argument for [Expr; 2] {
    const KIND: &'static str = "vec2<f32>";
    fn symbol(name: &str) -> Self {
        let pair = input(name.into(), Width::Two);
        [0, 1].map(|place| Expr(component(pair, place)))
    }
}

impl Argument for ExprVec3 {
    const KIND: &'static str = "vec3<f32>";
    fn symbol(name: &str) -> Self {
        Self(input(name.into(), Width::Three))
    }
}

/// The arguments of a function: a tuple of up to four.
pub trait Arguments<const N: usize>: Sized {
    #[doc(hidden)]
    fn symbols(names: [&str; N]) -> Self;
    #[doc(hidden)]
    fn kinds() -> [&'static str; N];
}

macro_rules! arguments {
    ($count:literal: $($kind:ident $name:ident)+) => {
        impl<$($kind: Argument),+> Arguments<$count> for ($($kind,)+) {
            fn symbols([$($name),+]: [&str; $count]) -> Self {
                ($($kind::symbol($name),)+)
            }
            fn kinds() -> [&'static str; $count] {
                [$($kind::KIND),+]
            }
        }
    };
}
arguments!(1: A a);
arguments!(2: A a B b);
arguments!(3: A a B b C c);
arguments!(4: A a B b C c D d);

/// The result of a function: `f32`, `vec3<f32>`, or an array of one of them.
pub trait Answer {
    /// Whether its parts are vectors.
    #[doc(hidden)]
    const WIDE: bool;
    #[doc(hidden)]
    fn kind() -> String;
    #[doc(hidden)]
    fn parts(self) -> Vec<ExprVec3>;
}

impl Answer for Expr {
    const WIDE: bool = false;
    fn kind() -> String {
        Self::KIND.into()
    }
    fn parts(self) -> Vec<ExprVec3> {
        Vec::from([ExprVec3(self.0)])
    }
}

impl Answer for ExprVec3 {
    const WIDE: bool = true;
    fn kind() -> String {
        Self::KIND.into()
    }
    fn parts(self) -> Vec<ExprVec3> {
        Vec::from([self])
    }
}

impl<A: Answer + Argument, const N: usize> Answer for [A; N] {
    const WIDE: bool = A::WIDE;
    fn kind() -> String {
        format!("array<{}, {N}>", A::KIND)
    }
    fn parts(self) -> Vec<ExprVec3> {
        self.into_iter().flat_map(Answer::parts).collect()
    }
}
