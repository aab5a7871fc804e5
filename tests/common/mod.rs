//! What several test programs share.
#![allow(dead_code, unreachable_pub, reason = "each test program uses its own part")]

pub mod directions;
pub mod distributions;
pub mod faulty;
pub mod measure;
pub mod models;
pub mod mutation;
pub mod slopes;
pub mod sound;
pub mod traced;
pub mod values;
