//! The choice of a horizon: trials that pay, fail, rest, and are cut short.

use super::*;

const FAST: Motion = Motion {
    speed: Some(0.1),
    pairs: 1.0,
};

/// What a trial's updates have cost, at this price of each of 10 moves in each update.
fn spent(price: u64) -> Spent {
    Spent {
        updates: TRIAL_UPDATES,
        moved: 10 * TRIAL_UPDATES,
        searching: 0,
        all: 10 * price * TRIAL_UPDATES,
    }
}

fn next(foresight: Foresight, price: u64) -> Foresight {
    foresight.adapted::<2>(spent(price), || panic!("the speed no longer decides"))
}

/// One that has just settled on this number of moves.
fn settled(moves: u16) -> Foresight {
    Foresight {
        moves,
        phase: Phase::Settled,
        is_longer_next: true,
        ..Foresight::new(None)
    }
}

/// The moves that are tried one after the other, where a number of moves has this price.
fn tried(mut foresight: Foresight, price: impl Fn(u16) -> u64, trials: usize) -> Vec<u16> {
    let mut moves = vec![foresight.moves];
    for _ in 0..trials {
        foresight = next(foresight, price(foresight.moves));
        moves.push(foresight.moves);
    }
    moves
}

#[test]
fn the_first_guess_goes_by_speed_and_density() {
    let first = |speed, pairs| {
        let motion = || Motion {
            speed: Some(speed),
            pairs,
        };
        let foresight = Foresight::new(None).adapted::<2>(Spent::default(), motion);
        foresight.moves
    };
    assert_eq!(first(1e-6, 1.0), LONGEST);
    assert_eq!(first(0.0, 1.0), LONGEST);
    assert!(first(0.01, 1.0) > first(0.2, 1.0));
    assert!(first(0.1, 0.5) > first(0.1, 8.0));
    assert_eq!(first(0.1, 0.0), first(0.1, 0.1));
    assert!(first(TOO_FAST, 100.0) == 1 && first(TOO_FAST, 1.0) >= 1);
    assert_eq!(first(TOO_FAST * 1.01, 1.0), 0);
}

#[test]
fn the_first_guess_is_the_nearest_power_of_two() {
    // The square of the best number of moves is 1 / (growth * ratio).
    let ratio = SEARCHED as f64 / COMPARED as f64;
    let pairs_for = |best: f64| ratio / (best * best) / 2.0 / 0.01;
    assert_eq!(guess::<2>(0.01, pairs_for(8.0)), 8);
    assert_eq!(guess::<2>(0.01, pairs_for(11.2)), 8);
    assert_eq!(guess::<2>(0.01, pairs_for(11.4)), 16);
    assert_eq!(guess::<2>(0.01, pairs_for(5.7)), 8);
    assert_eq!(guess::<2>(0.01, pairs_for(5.6)), 4);
    // There are more candidates in three dimensions.
    assert_eq!(guess::<3>(0.01, pairs_for(8.0) * 2.0 / 3.0), 8);
}

#[test]
fn what_is_new_says_nothing() {
    let new = Foresight::new(None);
    assert_eq!(new.adapted::<2>(Spent::default(), Motion::default), new);
    assert_eq!(new.moves(), FIRST);
    assert!(!new.is_fixed() && new.is_any());
}

#[test]
fn it_guesses_until_there_are_enough_updates() {
    let guessed = |foresight: Foresight, updates, speed| {
        let few = Spent {
            updates,
            ..spent(1000)
        };
        foresight.adapted::<2>(few, || Motion {
            speed: Some(speed),
            pairs: 1.0,
        })
    };
    let slow = guessed(Foresight::new(None), TRIAL_UPDATES - 2, 0.001);
    assert_eq!(slow.moves, LONGEST);
    let fast = guessed(slow, 1, 0.1);
    assert_eq!(fast.moves, guess::<2>(0.1, 1.0));
    let tried = guessed(fast, 1, 0.1);
    assert_eq!(tried.moves, fast.moves / 2);
    assert_eq!(next(tried, 2000).moves, fast.moves);
}

#[test]
fn what_is_fixed_stays() {
    let fixed = Foresight::new(Some(5));
    let adapted = fixed.adapted::<2>(spent(1), || panic!("it is fixed"));
    assert_eq!((adapted, adapted.moves()), (fixed, 5));
    assert!(fixed.is_fixed());
    assert_eq!(Foresight::new(Some(1000)).moves(), LONGEST);
    assert!(!Foresight::new(Some(0)).is_any());
}

#[test]
fn nothing_is_tried_before_enough_updates() {
    let few = Spent {
        updates: TRIAL_UPDATES - 1,
        ..spent(1)
    };
    let once = settled(8).adapted::<2>(few, || FAST);
    assert_eq!((once.moves, once.phase), (8, Phase::Settled));
    let one = Spent {
        updates: 1,
        ..Spent::default()
    };
    let twice = once.adapted::<2>(one, || FAST);
    assert_eq!(
        (twice.moves, twice.phase),
        (16, Phase::Tried { settled: 8 })
    );
    assert_eq!(twice.spent, Spent::default());
}

#[test]
fn it_climbs_to_the_cheapest_from_either_side() {
    let dear = |best: u16| move |moves: u16| 1000 + 1000 * u64::from(moves.abs_diff(best));
    assert_eq!(tried(settled(2), dear(16), 7), [2, 4, 8, 16, 32, 16, 8, 16]);
    // The first trial is of a longer one.
    assert_eq!(tried(settled(8), dear(0), 8), [8, 16, 8, 4, 2, 1, 0, 0, 1]);
}

#[test]
fn it_does_not_leave_the_range() {
    let longer = |moves: u16| 1000 - 10 * u64::from(moves);
    assert!(
        tried(settled(LONGEST), longer, 50)
            .iter()
            .all(|&moves| moves <= LONGEST)
    );
    assert_eq!(tried(settled(32), longer, 2), [32, 64, 64]);
    let shorter = |moves: u16| 1000 + 10 * u64::from(moves);
    assert_eq!(tried(settled(0), shorter, 2), [0, 1, 0]);
}

#[test]
fn a_small_gain_is_no_gain() {
    let gain = |is_longer_next, price: u64| {
        let settled = Foresight {
            is_longer_next,
            ..settled(8)
        };
        let trial = next(settled, 10_000);
        next(trial, price).phase
    };
    let least = (10_000.0 * (1.0 - GAIN)) as u64;
    assert_eq!(gain(true, least), Phase::Settled);
    assert_eq!(gain(true, least - 1), Phase::Tried { settled: 16 });
    // And a small loss is no loss, if it looks less far ahead.
    let most = (10_000.0 * (1.0 + GAIN)) as u64;
    assert_eq!(gain(false, most), Phase::Settled);
    assert_eq!(gain(false, most - 1), Phase::Tried { settled: 4 });
}

#[test]
fn trials_become_rare_where_none_pays() {
    let best = |moves: u16| 1000 + 1000 * u64::from(moves.abs_diff(8));
    let all = tried(settled(8), best, 400);
    // Between two trials it rests for 1, 2 + 1, 1, 4 + 1, ... measurements.
    let rests: Vec<_> = all.split(|&moves| moves != 8).map(<[u16]>::len).collect();
    assert_eq!(rests[..8], [1, 1, 3, 1, 5, 1, 9, 1]);
    let longest = rests.iter().max().copied();
    assert_eq!(longest, Some(MOST_REST as usize + 1));
    let both = |tried: u16| all.contains(&tried);
    assert!(both(4) && both(16) && !both(2) && !both(32));
}

#[test]
fn a_trial_that_pays_ends_the_rest() {
    let rested = Foresight {
        failures: 9,
        ..settled(8)
    };
    let trial = next(rested, 1000);
    assert_eq!(trial.moves, 16);
    let paid = next(trial, 100);
    assert_eq!((paid.moves, paid.failures), (32, 0));
    let failed = next(paid, 1000);
    assert_eq!((failed.moves, failed.rest, failed.failures), (16, 0, 1));
}

#[test]
fn the_price_is_that_of_a_move() {
    let trial = next(settled(8), 1000);
    // Half as many have moved, and it has cost half as much.
    let half = Spent {
        updates: TRIAL_UPDATES,
        moved: 5 * TRIAL_UPDATES,
        searching: 0,
        all: 5 * 1000 * TRIAL_UPDATES,
    };
    assert_eq!(trial.adapted::<2>(half, || FAST).phase, Phase::Settled);
    let none = Spent { moved: 0, ..half };
    assert_eq!(trial.adapted::<2>(none, || FAST).phase, Phase::Settled);
}

#[test]
fn it_is_shortened_where_there_are_too_many_candidates() {
    let mut foresight = next(settled(16), 1000);
    assert_eq!(foresight.moves, 32);
    foresight.shorten();
    assert_eq!((foresight.moves, foresight.phase), (8, Phase::Settled));
    for _ in 0..2 {
        foresight = next(foresight, 1000);
        assert_eq!(foresight.moves, 8);
    }
    foresight = next(foresight, 1000);
    assert_eq!(foresight.moves, 16);
    // More rarely, if it was not the last time.
    for rest in [4, 8] {
        foresight.shorten();
        assert_eq!((foresight.rest, foresight.is_longer_next), (rest, true));
    }
    assert_eq!(foresight.moves, 1);
    foresight.shorten();
    let none = foresight;
    assert!(!none.is_any() && none.rest == 16);
    foresight.shorten();
    assert_eq!(foresight, none);
}

#[test]
fn work_is_added_up_and_never_overflows() {
    let some = Spent {
        updates: 1,
        moved: 2,
        searching: 3,
        all: 4,
    };
    let mut sum = some;
    sum.add(some);
    let expected = Spent {
        updates: 2,
        moved: 4,
        searching: 6,
        all: 8,
    };
    assert_eq!(sum, expected);
    let most = Spent {
        updates: u64::MAX,
        moved: u64::MAX,
        searching: u64::MAX,
        all: u64::MAX,
    };
    sum.add(most);
    assert_eq!(sum, most);
}
