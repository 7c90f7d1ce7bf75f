//! The suite for rapier3d.

use rapier3d as rapier;
use unisize::rapier3d::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d::{PairFilter, Settings};
use unisize_scenes::dim3::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim3::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x9a4b885c0f572c51,
    0xf2a5db4f644a3c7c,
    0xf83580695d42826c,
    0x56ac2ab10a9dbd0a,
    0x9cf6d753f02cc2ea,
    0x015dca8e17839922,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0xd3d61c844ee380cf,
    0x9975a8338cbe766d,
    0x58e83297a73a3849,
    0x71434b733ab87934,
    0x3af68eb035a89b23,
    0xad17c27022c894a3,
    0x771726bc323f1704,
    0x535d3be784263c7a,
    0xc0e1fbecb453faa1,
    0xc534871509a307b2,
    0xf373315de0002bd2,
    0x55aaa44b1e0e691c,
    0x3d6f644559f85921,
    0x2131ce2d15376d62,
    0x9676520d3db79e28,
    0x136edc66647664a8,
    0xe337c0937605e0af,
    0xd1f2068e216a7bd8,
    0xc86502f53146d093,
    0x98f335e4d29d61df,
    0x5a68d5ead9411ae7,
    0x230a30256d679555,
    0xee606903da2e374f,
    0xb1553818a74128be,
    0xaf854e363a949c80,
];

#[path = "suite.rs"]
mod suite;
