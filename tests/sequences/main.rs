//! The broad phase over time: random sequences of what can happen to colliders, against a model.
//!
//! A [`Sequence`](ops::Sequence) is a list of updates, each a list of [`Op`](ops::Op)s. It is played in three
//! ways: with hand-made lists of colliders, odd ones included (`direct`); and in the steps of
//! Rapier's own `CollisionPipeline` and `PhysicsPipeline`, so that the lists are the engine's. Each update is
//! checked by `CheckedBroadPhase`, which forwards it and compares the answer with that of `Model`: the contract by
//! brute force, written without regard to the implementation.
//!
//! `distances` and `sizes` need no model: they ask Parry about the colliders that a broad phase tells apart by their shapes.
//!
//! A failure shows the shortest sequence found that still fails. Raise `PROPTEST_CASES` for more sequences. `fuzzed` reads
//! sequences from bytes, the fuzzer's as well, and `replay` plays the inputs that the fuzzer has kept.
#![cfg(feature = "_adapter")]

// With this attribute, its modules are looked for beside it and not in a folder of its name.
#[path = "flavours.rs"]
mod flavours;
mod fuzzed;
mod ops;
mod replay;
mod strategies;

#[path = "../common/cases.rs"]
mod cases;
#[path = "../common/random_values.rs"]
mod random_values;

// It does not look into macros.
#[cfg(rustfmt)]
mod dim2;
#[cfg(rustfmt)]
mod dim3;
#[cfg(rustfmt)]
mod pipelines;
#[cfg(rustfmt)]
mod rapier_027;
#[cfg(rustfmt)]
mod rapier_036;
#[cfg(rustfmt)]
mod suite;
