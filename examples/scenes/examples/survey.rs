//! Steps every scene, or those that are named, with Rapier's default broad phase and prints what it took and whether it stayed sane.
//!
//! `cargo run --release -p unisize-scenes --features rapier2d-027,rapier3d-027 --example survey -- [steps] [bodies] [scene]...`

use std::time::Instant;
use unisize_scenes::SceneKind;

macro_rules! survey {
    ($dim:ident, $kind:expr, $bodies:expr, $steps:expr) => {{
        use unisize_scenes::$dim::{Scene, rapier::prelude::DefaultBroadPhase};
        let mut scene = Scene::build($kind, $bodies, 1);
        let initial = scene.sanity();
        let mut broad_phase = DefaultBroadPhase::new();
        let start = Instant::now();
        for _ in 0..$steps {
            scene.step(&mut broad_phase, &(), &());
        }
        let seconds = start.elapsed().as_secs_f64();
        let sanity = scene.sanity();
        let verdict = match sanity.verdict(&initial) {
            Ok(()) => "sane".to_owned(),
            Err(reason) => reason,
        };
        println!(
            "{:14} {} {:6} bodies {seconds:7.2} s, {:6} asleep, energy {:10.0} of {:10.0}, stretch {:.2}: {verdict}",
            $kind.name(),
            stringify!($dim),
            sanity.bodies,
            sanity.sleeping,
            sanity.energy(),
            initial.energy() + sanity.supplied_energy,
            sanity.max_rope_stretch.unwrap_or(0.0),
        );
    }};
}

fn main() {
    let arguments = || std::env::args().skip(1);
    let numbers: Vec<usize> = arguments().flat_map(|number| number.parse()).collect();
    let named = |kind: &SceneKind| arguments().any(|name| name == kind.name());
    let is_any_named = SceneKind::ALL.iter().any(named);
    let steps = numbers.first().copied().unwrap_or(300);
    for kind in SceneKind::ALL {
        if is_any_named && !named(&kind) {
            continue;
        }
        let bodies = numbers.get(1).copied().unwrap_or(kind.default_bodies());
        survey!(dim2, kind, bodies, steps);
        survey!(dim3, kind, bodies, steps);
    }
}
