//! The suite for rapier2d-f64.

use rapier2d_f64 as rapier;
use unisize::rapier2d_f64::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d_f64::{PairFilter, Settings};
use unisize_scenes::dim2_f64::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim2_f64::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x8541d3077ccc43e6,
    0x8740e64866bee38d,
    0xfd883198de31b7b1,
    0x526202b18c242af1,
    0x40502de750fdd661,
    0x54303ea0acd9d00b,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 21] = [
    0x467fd58d64bc5d10,
    0x6342bc289035b930,
    0x09b9bf8227ef6d99,
    0x68db312abec43f42,
    0x7daae30a22feafe2,
    0x5c5a22a530616495,
    0xb011fb46aed5555f,
    0xc622499fa1d963a8,
    0x9d2573815a8ec274,
    0x36a1a73ee8ecd690,
    0x24f7c233a50f56fc,
    0x3bcd9610de3abb60,
    0xa4b322e511096ff7,
    0x2ec61bb514ea9082,
    0xea1dee57585959be,
    0x9aa36f883f92794b,
    0x6a22b3113e479ebf,
    0xbf9380aee2bfd177,
    0xcd369aac949195e9,
    0x1e37431a4aba538f,
    0xb4f8c1030857b66b,
];

#[path = "suite.rs"]
mod suite;
