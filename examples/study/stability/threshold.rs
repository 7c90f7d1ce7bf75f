//! The threshold of a family: the largest value of its parameter at which nothing fails, found by bisection.
//!
//! Near the limit worlds are chaotic, so that a larger value may hold where a smaller one fails. The threshold is one value that
//! holds whose neighbour fails, and not the only such value.

/// The last of so many indices that is sound, if the first ones are; `None` if the first one is not. It is asked for about as many
/// indices as the logarithm of their number.
pub(crate) fn last_sound(count: usize, mut is_sound: impl FnMut(usize) -> bool) -> Option<usize> {
    let [mut sound, mut failing] = [0, count.checked_sub(1)?];
    if !is_sound(sound) {
        return None;
    }
    if is_sound(failing) {
        return Some(failing);
    }
    while failing - sound > 1 {
        let middle = sound.midpoint(failing);
        match is_sound(middle) {
            true => sound = middle,
            false => failing = middle,
        }
    }
    Some(sound)
}

#[cfg(test)]
mod tests {
    use super::last_sound;

    #[test]
    fn the_last_sound_one_is_found_in_few_steps() {
        for count in 1..40 {
            for sound in 0..=count {
                let mut asked = 0;
                let found = last_sound(count, |index| {
                    asked += 1;
                    index < sound
                });
                assert_eq!(found, sound.checked_sub(1));
                assert!(asked <= 3 + count.ilog2() as usize, "{count} {asked}");
            }
        }
        assert_eq!(last_sound(0, |_| true), None);
    }
}
