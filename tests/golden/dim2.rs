//! The suite for rapier2d.

use rapier2d as rapier;
use unisize::rapier2d::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d::{PairFilter, Settings};
use unisize_scenes::dim2::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim2::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x126311ff4ea04fec,
    0x8ebb208d5d542caf,
    0xc13f688a463dcd79,
    0xa29e1e1488a6a93d,
    0x5d366d613d097c09,
    0x4fc3935a616176b0,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0xac08f5316adbaf7f,
    0x6342bc289035b930,
    0x0035429dba9e0568,
    0xcf19bb7c0b6a693c,
    0xdb3a8c2c30274bc6,
    0x01e0286f185e1ab4,
    0xb011fb46aed5555f,
    0x2aba51e6cc5617c8,
    0x9d2573815a8ec274,
    0xe6c85cd9ff9683c0,
    0xd22f017af25866ca,
    0x103db5fadcdc0666,
    0xfc3c33cabd8540db,
    0x9fabe985c30c406d,
    0x5863702cbff2570a,
    0xf2baa4eb9751ee7d,
    0xd797f517f24ebc59,
    0xde89350bfac0fcd5,
    0xcd369aac949195e9,
    0x231225433ef25e27,
    0x6537d9b6e48b9e15,
    0x1751054cf85183c5,
    0xd88f61307bdd5d0f,
    0x1eb108af16d75c8d,
    0xb852aecff81072ff,
];

#[path = "suite.rs"]
mod suite;
