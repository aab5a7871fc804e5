//! A form of description is written once, as a list of variants and keys; what it is as a type and
//! how it is read follow from that.

/// Declares an enum whose variants are the forms of a description.
macro_rules! forms {
    (
        $(#[$meta:meta])*
        pub enum $name:ident as $what:literal {
            $(
                $(#[$variant_meta:meta])*
                $tag:literal => $variant:ident
                $(( $inner:ty ))?
                $({
                    $( $(#[$field_meta:meta])* $field:ident: $type:ty $(= $default:expr)? ),+ $(,)?
                })?
            ),+ $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq, serde::Serialize)]
        #[non_exhaustive]
        pub enum $name {
            $(
                $(#[$variant_meta])*
                #[serde(rename = $tag)]
                $variant
                $(( $inner ))?
                $({ $( $(#[$field_meta])* $field: $type ),+ })?
            ),+
        }

        impl<'de> $crate::description::parse::Parse<'de> for $name {
            fn parse<D: serde::Deserializer<'de>>(
                place: &$crate::description::place::Place<'_>,
                from: D,
            ) -> Result<Self, D::Error> {
                use core::fmt;
                use serde::de::{EnumAccess, VariantAccess, Visitor};
                use $crate::description::parse::Progress;
                use $crate::description::place::Place;

                const WORDS: &[&str] = &[$($tag),+];
                struct Forms<'a>(&'a Place<'a>, &'a Progress);
                impl<'de> Visitor<'de> for Forms<'_> {
                    type Value = $name;
                    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                        self.1.tell();
                        f.write_str($what)
                    }
                    fn visit_enum<A: EnumAccess<'de>>(self, form: A) -> Result<$name, A::Error> {
                        let (tag, content) = form.variant_seed($crate::description::parse::Word {
                            place: self.0,
                            words: WORDS,
                        })?;
                        self.1.named(tag);
                        let place = self.0.key(tag);
                        let result = match tag {
                            $( $tag => $crate::description::form::content!(
                                content, place, [$name::$variant]
                                $(( $inner ))?
                                $({ $( $field: $type $(= $default)? ),+ })?
                            ), )+
                            _ => Err(serde::de::Error::unknown_variant(tag, WORDS)),
                        };
                        result.inspect_err(|_| place.note_failure())
                    }
                }
                let progress = Progress::default();
                let read = from.deserialize_enum(stringify!($name), WORDS, Forms(place, &progress));
                progress.explain(place, $what, read)
            }
        }
    };
}

/// Declares a struct that is a part of a description.
macro_rules! part {
    (
        $(#[$meta:meta])*
        pub struct $name:ident {
            $( $(#[$field_meta:meta])* pub $field:ident: $type:ty ),+ $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq, serde::Serialize)]
        pub struct $name {
            $( $(#[$field_meta])* pub $field: $type ),+
        }

        impl<'de> $crate::description::parse::Parse<'de> for $name {
            fn parse<D: serde::Deserializer<'de>>(
                place: &$crate::description::place::Place<'_>,
                from: D,
            ) -> Result<Self, D::Error> {
                $crate::description::form::keys!([$name] as $name { $( $field: $type ),+ });
                let progress = $crate::description::parse::Progress::default();
                let read = from.deserialize_struct(stringify!($name), KEYS, Keys(place, &progress));
                progress.explain(place, EXPECTED, read)
            }
        }
    };
}

/// Declares an enum of bare words.
macro_rules! words {
    ($(#[$meta:meta])* pub enum $name:ident {
        $( $(#[$word_meta:meta])* $word:literal => $variant:ident ),+ $(,)?
    }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
        #[non_exhaustive]
        pub enum $name {
            $( $(#[$word_meta])* #[serde(rename = $word)] $variant ),+
        }

        impl<'de> $crate::description::parse::Parse<'de> for $name {
            fn parse<D: serde::Deserializer<'de>>(
                place: &$crate::description::place::Place<'_>,
                from: D,
            ) -> Result<Self, D::Error> {
                const WORDS: &[&str] = &[$($word),+];
                const EXPECTED: &str = concat!("one of", $( " `", $word, "`" ),+);
                struct Words<'a>(
                    &'a $crate::description::place::Place<'a>,
                    &'a $crate::description::parse::Progress,
                );
                impl<'de> serde::de::Visitor<'de> for Words<'_> {
                    type Value = $name;
                    fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                        self.1.tell();
                        f.write_str(EXPECTED)
                    }
                    fn visit_enum<A: serde::de::EnumAccess<'de>>(
                        self,
                        word: A,
                    ) -> Result<$name, A::Error> {
                        let (word, content) =
                            word.variant_seed($crate::description::parse::Word {
                                place: self.0,
                                words: WORDS,
                            })?;
                        serde::de::VariantAccess::unit_variant(content)?;
                        match word {
                            $( $word => Ok($name::$variant), )+
                            _ => Err(serde::de::Error::unknown_variant(word, WORDS)),
                        }
                    }
                }
                let progress = $crate::description::parse::Progress::default();
                let read = from.deserialize_enum(stringify!($name), WORDS, Words(place, &progress));
                progress.explain(place, EXPECTED, read)
            }
        }
    };
}

/// What stands behind the name of a form: another value, or an object with keys.
macro_rules! content {
    ($content:ident, $place:ident, [$($constructor:tt)+] ($inner:ty)) => {
        $content
            .newtype_variant_seed($crate::description::parse::At::<$inner>::new(&$place))
            .map($($constructor)+)
    };
    ($content:ident, $place:ident, [$name:ident :: $variant:ident] { $($keys:tt)+ }) => {{
        $crate::description::form::keys!([$name::$variant] as $name { $($keys)+ });
        let progress = $crate::description::parse::Progress::default();
        let read = $content.struct_variant(KEYS, Keys(&$place, &progress));
        progress.explain(&$place, EXPECTED, read)
    }};
}

/// A visitor `Keys` of an object with the given `KEYS`.
macro_rules! keys {
    (
        [$($constructor:tt)+] as $value:ident
        { $( $field:ident: $type:ty $(= $default:expr)? ),+ }
    ) => {
        const KEYS: &[&str] = &[$(stringify!($field)),+];
        const EXPECTED: &str =
            concat!("an object with the keys", $( " `", stringify!($field), "`" ),+);
        struct Keys<'a>(
            &'a $crate::description::place::Place<'a>,
            &'a $crate::description::parse::Progress,
        );
        impl<'de> serde::de::Visitor<'de> for Keys<'_> {
            type Value = $value;
            fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                self.1.tell();
                f.write_str(EXPECTED)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(
                self,
                mut map: A,
            ) -> Result<$value, A::Error> {
                $( let mut $field: Option<$type> = None; )+
                while let Some(key) = map.next_key_seed($crate::description::parse::Word {
                    place: self.0,
                    words: KEYS,
                })? {
                    $( if key == stringify!($field) {
                        let place = self.0.key(stringify!($field));
                        $crate::description::parse::once(&mut $field, &place, &mut map)?;
                    } )+
                }
                $( let $field = $crate::description::form::given!(
                    $field, self.0.key(stringify!($field)) $(, $default)?
                ); )+
                Ok($($constructor)+ { $( $field ),+ })
            }
        }
    };
}

/// The value of a key that may be absent if it has a default.
macro_rules! given {
    ($value:ident, $place:expr) => {
        $value.ok_or_else(|| $crate::description::parse::missing(&$place))?
    };
    ($value:ident, $place:expr, $default:expr) => {
        $value.unwrap_or($default)
    };
}

/// Reads and builds a form of description from the outside.
macro_rules! entrance {
    ($name:ident) => {
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                $crate::description::parse::whole(from, |value: &Self, place| {
                    value.checked::<f64>(place).map(drop)
                })
            }
        }
    };
}

pub(super) use {content, entrance, forms, given, keys, part, words};
