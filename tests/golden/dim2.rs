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
    0x470795fb48856718,
    0xd6164d58bc226b73,
    0xef1941d963668511,
    0x618d16bb68415165,
    0x0bb44bf830240f75,
    0x0022006aeccf9b30,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 21] = [
    0x0d66d9eb2117f486,
    0x6342bc289035b930,
    0xfd64795eccd120c8,
    0x8a499b30b6fff045,
    0x1a84988a8ec09807,
    0xaa0a006e2dd8126f,
    0xb011fb46aed5555f,
    0xc622499fa1d963a8,
    0x9d2573815a8ec274,
    0x1a06fdcdef0cff00,
    0x028e6ccad09d6c7a,
    0x6fc07d66de17a556,
    0x008b8eef92b1f42c,
    0x8600a428b67eded8,
    0x92564a6637adae6e,
    0x4c5109ba2ba1591f,
    0xd54a58aac6f1c302,
    0xde89350bfac0fcd5,
    0xcd369aac949195e9,
    0x231225433ef25e27,
    0xc9e6ec4bce8e39a3,
];

#[path = "suite.rs"]
mod suite;
