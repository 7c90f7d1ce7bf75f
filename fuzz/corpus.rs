//! The inputs that the fuzzer has kept, for tests that run without a fuzzer. `corpus.py` beside this file tells the format of a pack.

use std::fs;
use std::path::Path;

/// Checks every input kept for this fuzz target.
pub(crate) fn replay(target: &str, check: impl Fn(&[u8])) {
    let packs = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    let pack = fs::read(packs.join(target).with_extension("pack"));
    let pack = pack.expect("the inputs are in the repository");
    assert!(!pack.is_empty(), "no inputs for {target}");
    let (mut rest, mut number) = (&pack[..], 0);
    while let Some((length, records)) = rest.split_first_chunk() {
        let (input, next) = records.split_at(u32::from_le_bytes(*length) as usize);
        println!("input {number:05} of {target}");
        check(input);
        (rest, number) = (next, number + 1);
    }
    assert!(rest.is_empty(), "the last record of {target} is cut off");
}
