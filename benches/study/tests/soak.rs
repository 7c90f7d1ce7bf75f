//! Many updates in the same memory, in a process of its own: the allocator counts what all threads hold.

use std::process::Command;

#[test]
fn memory_does_not_grow() {
    let mut study = Command::new(env!("CARGO_BIN_EXE_study"));
    let output = study.args(["soak", "--steps", "20000"]).output().unwrap();
    assert!(output.status.success(), "{output:?}");
}
