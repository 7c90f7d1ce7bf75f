//! The tests of the scenes in `benches/scenes/tests`, on a patched Rapier 0.36.

#[macro_use]
#[path = "../../../scenes/tests/suite/mod.rs"]
mod suite;

scene_tests!(dim2_036);
scene_tests!(dim3_036);
