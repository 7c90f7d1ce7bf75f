//! The suite for rapier3d-f64.

use rapier3d_f64 as rapier;
use unisize::rapier3d_f64::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d_f64::{PairFilter, Settings};
use unisize_scenes::dim3_f64::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim3_f64::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x52e617281998aa32,
    0xfc4b0e8e52544f80,
    0xdafe624b3c445db4,
    0x24facf216e8359ba,
    0x5106e6118ad96346,
    0x31d01c4b949b23e9,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 19] = [
    0x84c3c22759bcd322,
    0x9975a8338cbe766d,
    0x76161b6c0d3432a9,
    0xa4d91fadcddb7f00,
    0xa3ac7e563fb0c119,
    0x1497e939fcccbb8a,
    0x6658c2176fcbe39a,
    0xc0e1fbecb453faa1,
    0x8661b0784f559c22,
    0x4f5278d2ec7ede52,
    0x941cd146e0b6341c,
    0xb33871136aa24733,
    0x84a14a3b770fe7db,
    0xfb74257d15c56af9,
    0x0ddbcb59022501b4,
    0x186bf03e97be65ea,
    0xc86502f53146d093,
    0x2490aacec0507346,
    0x7d2e0046fbf8544c,
];

#[path = "suite.rs"]
mod suite;
