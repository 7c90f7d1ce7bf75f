//! The suite for rapier3d.

use rapier3d as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d::PairFilter;
use unisize::rapier3d::{Kernel, Settings, UnisizeBroadPhase};
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
    0xa87f97e3e1852ed2,
    0x065fd72b53b8bc7d,
    0xdd530dbeb92d485b,
    0x848adb162d994bf9,
    0xc213fea3d58e9f23,
    0x3967def74ac7b62c,
    0x36f92143cab71384,
    0xbf6ffe66ff28407a,
    0x4fe8e44b01702cd1,
    0x4ec9fceada718202,
    0x9e3631081fa2cd02,
    0xf707c428a8cb14ac,
    0xd59aed3afcd544e1,
    0xe4b26f06cb81835e,
    0x828c67ec432fc99b,
    0x523ab56ce1711901,
    0xa6c52a965f18540f,
    0x75b3c391b2e55172,
    0x89baa39164fbe5b3,
    0x9802902faec2bd2f,
    0xcaa7a614e17756ec,
    0x0c9f0556a7482545,
    0x4bea7ba5a03037af,
    0x7605ddf42f95d2be,
    0xb00b50c93d62c5c0,
];

#[path = "suite.rs"]
mod suite;
