//! Whether a candidate is a pair.

/// The state of a candidate. A byte with a bit for each question, so that many candidates are asked at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum PairState {
    /// Its boxes do not overlap.
    Apart = 0b00,
    /// Its boxes overlap. It is not held, because its volumes have not met yet, no longer do, or met only after its keys had forbidden it.
    Near = 0b01,
    /// It is held.
    Held = 0b10,
}

/// Which of up to 64 candidates are near, and which are held. The first candidate is the lowest bit.
#[inline(always)]
pub(super) fn near_and_held(states: &[PairState]) -> [u64; 2] {
    /// The lowest bit of each byte.
    const LOWEST: u64 = 0x0101_0101_0101_0101;
    /// Gathers the lowest bits of all bytes in the highest byte.
    const GATHER: u64 = 0x0102_0408_1020_4080;
    let (mut near, mut held) = (0, 0);
    for (i, eight) in states.chunks(8).enumerate() {
        let word = match eight.first_chunk::<8>() {
            Some(eight) => u64::from_le_bytes(eight.map(|state| state as u8)),
            None => eight
                .iter()
                .rfold(0, |word, &state| word << 8 | u64::from(state as u8)),
        };
        let gathered = |bits: u64| ((bits & LOWEST).wrapping_mul(GATHER) >> 56) << (8 * i);
        near |= gathered(word);
        held |= gathered(word >> 1);
    }
    [near, held]
}
