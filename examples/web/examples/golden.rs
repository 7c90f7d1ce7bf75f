//! The hashes of all scenes on this machine, as `node.mjs --golden` prints those of WebAssembly.

use unisize_web::{golden, scenes};

fn main() {
    for engine in [
        "rapier2d-027",
        "rapier3d-027",
        "rapier2d-036",
        "rapier3d-036",
    ] {
        for scene in scenes() {
            let hash = golden(engine, &scene).unwrap_or_else(|_| unreachable!("both are known"));
            println!("{engine} {scene} {hash}");
        }
    }
}
