//! Types that share a trait, as one type.

/// Declares an enum with a member for each of some types, conversions from them, [`Lift`] and a
/// macro that writes the same expression for every member. A member marked `generic` is
/// converted from more than its own type, elsewhere.
///
/// [`Lift`]: crate::Lift
macro_rules! members {
    (
        ($d:tt) $each:ident
        $(#[$meta:meta])*
        pub enum $any:ident[$($declared:tt)*]$generics:tt $from:ty => $over:ty {
            $( $(#[$member_meta:meta])* $member:ident($type:ty) $(: $from_elsewhere:ident)?, )+
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum $any<$($declared)*> {
            $( $(#[$member_meta])* $member($type), )+
        }

        macro_rules! $each {
            ($d any:expr, $d one:ident => $d result:expr) => {
                match $d any {
                    $( $any::$member($d one) => $d result, )+
                }
            };
        }

        $( $crate::real::members!(@from $generics $from, $member($type) $($from_elsewhere)?); )+
        $crate::real::members!(@lift $generics $from => $over, $any: $($member)+);
    };
    (@from [$($generics:tt)*] $from:ty, $member:ident($type:ty)) => {
        impl<$($generics)*> From<$type> for $from {
            #[inline]
            fn from(one: $type) -> Self {
                Self::$member(one)
            }
        }
    };
    (@from $generics:tt $from:ty, $member:ident($type:ty) generic) => {};
    (@lift [$($generics:tt)*] $from:ty => $over:ty, $any:ident: $($member:ident)+) => {
        impl<$($generics)*> $crate::real::Lift<T> for $from {
            type Over<U: $crate::real::Real> = $over;

            fn lift<U: $crate::real::Real>(
                &self,
                lift: impl Fn(T) -> U + Copy,
            ) -> Self::Over<U> {
                match self {
                    $( Self::$member(one) => {
                        $any::$member($crate::real::Lift::<T>::lift(one, lift))
                    } )+
                }
            }
        }
    };
}
pub(crate) use members;
