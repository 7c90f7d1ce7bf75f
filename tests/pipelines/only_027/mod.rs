//! What is tested with Rapier 0.27 alone: what its pipelines do, its trait of broad phases, random worlds and questions.

#[cfg(feature = "_debug-render")]
use super::hinge;
use super::rapier;
use super::suite::twins;
use super::{PairFilter, Settings, UnisizeBroadPhase, World};
use super::{height_field, mesh_floor, spin, version};

mod choices;
#[cfg(feature = "_debug-render")]
mod debug_render;
mod exchange;
mod floors;
mod turning_casts;
