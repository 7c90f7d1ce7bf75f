//! Every scene, in every flavour: it stays sane under Rapier's default broad phase, whatever the number
//! of bodies, and it is determined by its seed.

#[macro_use]
mod suite;

scene_tests!(dim2);
scene_tests!(dim3);
scene_tests!(dim2_f64);
scene_tests!(dim3_f64);
