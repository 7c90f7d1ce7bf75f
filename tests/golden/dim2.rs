//! The suite for rapier2d.

use rapier2d as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d::PairFilter;
use unisize::rapier2d::{Kernel, Settings, UnisizeBroadPhase};
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
    0x1368a87537bd9b29,
    0xe55d8756d6768d60,
    0xa4b5c4d8f49f4b08,
    0x8b7152c9b292bd92,
    0x97b34304bb3b479c,
    0x464e5a0886642dd2,
    0xc449d40a56d1c3df,
    0x3bb584b2eb5cae58,
    0x1f44393b25b862e4,
    0x8330583b579ab2f3,
    0x5ea3bd5144d01402,
    0xb309e90d80dd1024,
    0xc25da6a476379f1b,
    0x9a07ab5cefd11420,
    0xc02f4ab3deed40ef,
    0x141e86c1c6147d71,
    0x83094ed0372d5151,
    0x0825092acac0fe55,
    0xf3234a725782f789,
    0x188967e845bc1af7,
    0x2b3e390a9f28eaab,
    0xe45979a9a61f20c5,
    0x4bea7ba5a03037af,
    0xd11d1ee9fa12e0ad,
    0x09adf3028068648f,
];

#[path = "suite.rs"]
mod suite;
