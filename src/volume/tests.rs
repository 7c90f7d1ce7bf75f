//! Volumes that touch must meet, at every distance from the origin. `tests/sequences/suite/sizes.rs` has shapes of every size. `tests/sequences`
//! compares separated volumes with a model, and shapes of all kinds with Parry's distances.

use oorandom::Rand64;

use super::*;

const KINDS: [VolumeKind; 3] = [VolumeKind::Ball, VolumeKind::Capsule, VolumeKind::Cuboid];

/// A random volume of about size 1, without a bound on rounding errors in its radius.
fn volume<const D: usize>(random: &mut Rand64, kind: VolumeKind, place: f64) -> Volume<f64, D> {
    let mut vector =
        |length: f64| core::array::from_fn(|_| length * (random.rand_float() * 2.0 - 1.0));
    let mut volume = Volume {
        kind,
        ..Volume::BOX
    };
    volume.ball.center = vector(place);
    let mut count = 0;
    while count < kind.axes::<D>() {
        // Orthogonal to those before.
        let half = volume.half_axes[..count]
            .iter()
            .fold(vector(1.0), |half, &other| {
                let along = dot(half, other) / dot(other, other);
                core::array::from_fn(|k| half[k] - along * other[k])
            });
        if dot(half, half) > 1e-3 {
            volume.half_axes[count] = half;
            count += 1;
        }
    }
    let most = if kind == VolumeKind::Cuboid { 0.1 } else { 1.0 };
    volume.ball.radius = most * random.rand_float();
    volume
}

/// The support point in a direction of length 1.
fn farthest<const D: usize>(volume: &Volume<f64, D>, direction: [f64; D]) -> [f64; D] {
    let Ball { center, radius } = volume.ball;
    let point = core::array::from_fn(|k| center[k] + radius * direction[k]);
    let halves = volume.as_ref().half_axes.iter();
    halves.fold(point, |point, &half| {
        let sign = dot(half, direction).signum();
        core::array::from_fn(|k| point[k] + sign * half[k])
    })
}

fn rounded<R: Real, const D: usize>(volume: &Volume<f64, D>) -> Volume<R, D> {
    let Ball { center, radius } = volume.ball;
    let halves = volume.half_axes.map(|half| half.map(R::from_f64));
    let center = center.map(R::from_f64);
    Volume::new(volume.kind, center, R::from_f64(radius), &halves)
}

/// The box around a volume.
fn aabb_of<R: Real, const D: usize>(volume: &Volume<f64, D>) -> Aabb<R, D> {
    let Ball { center, radius } = volume.ball;
    let extent = extent_of(volume.as_ref().half_axes.iter().copied());
    let corner =
        |sign: f64| core::array::from_fn(|k| R::from_f64(center[k] + sign * (radius + extent[k])));
    Aabb::new(corner(-1.0), corner(1.0))
}

/// Two volumes that touch in one point, or are this far apart.
fn touching<const D: usize>(
    random: &mut Rand64,
    kinds: [VolumeKind; 2],
    place: f64,
    gap: f64,
) -> [Volume<f64, D>; 2] {
    let [a, mut b] = kinds.map(|kind| volume(random, kind, place));
    let direction: [f64; D] = core::array::from_fn(|_| random.rand_float() * 2.0 - 1.0);
    let length = dot(direction, direction).sqrt();
    let direction = direction.map(|x| x / length);
    let between = sub(farthest(&a, direction), farthest(&b, direction.map(|x| -x)));
    b.ball.center = core::array::from_fn(|k| b.ball.center[k] + between[k] + gap * direction[k]);
    [a, b]
}

/// A volume, moved to the middle of its box if it is a ball.
fn in_box<R: Real, const D: usize>(volume: Volume<R, D>, aabb: &Aabb<R, D>) -> Volume<R, D> {
    match volume.kind {
        VolumeKind::Ball => Volume {
            ball: volume.ball.in_box(aabb),
            ..volume
        },
        _ => volume,
    }
}

fn check_volumes_that_touch<R: Real, const D: usize>() {
    let mut random = Rand64::new(11);
    for place in [0.0, 1.0, 30.0, 1e3, 1e6] {
        for kinds in KINDS
            .map(|first| KINDS.map(|second| [first, second]))
            .concat()
        {
            for _ in 0..300 {
                let pair = touching::<D>(&mut random, kinds, place, 0.0);
                let [a, b] = pair.each_ref().map(rounded::<R, D>);
                assert!(a.meets(&b, R::ZERO) && b.meets(&a, R::ZERO), "{a:?} {b:?}");
                // As in a broad phase, where a ball moves to the middle of its box.
                let [a, b] = [0, 1].map(|i| in_box([a, b][i], &aabb_of(&pair[i])));
                let fills = !a.ball.center[0].to_f64().is_nan();
                assert!(fills, "{a:?} does not fill its box");
                assert!(a.meets(&b, R::ZERO), "{a:?} {b:?}");
                // Volumes within the slack meet too.
                let pair = touching::<D>(&mut random, kinds, place, 0.125);
                let [a, b] = pair.each_ref().map(rounded::<R, D>);
                assert!(a.meets(&b, R::from_f64(0.125)), "{a:?} {b:?}");
            }
        }
    }
}

#[test]
fn volumes_that_touch_meet_despite_rounding() {
    check_volumes_that_touch::<f32, 2>();
    check_volumes_that_touch::<f32, 3>();
    check_volumes_that_touch::<f64, 2>();
    check_volumes_that_touch::<f64, 3>();
}

#[test]
fn points_are_separated_and_tiny_volumes_meet() {
    let cuboid = |x: f32, half: f32| {
        let halves = [[half, 0.0], [0.0, half]];
        Volume::new(VolumeKind::Cuboid, [x, 0.0], 0.0, &halves)
    };
    let ball = |x: f32, radius: f32| Volume::new(VolumeKind::Ball, [x, 0.0], radius, &[]);
    assert!(!ball(0.0, 0.0).meets(&ball(1.0, 0.0), 0.0));
    assert!(!cuboid(0.0, 0.0).meets(&cuboid(1.0, 0.0), 0.0));
    assert!(!cuboid(0.0, 0.0).meets(&ball(1.0, 0.5), 0.0));
    assert!(cuboid(0.1, 0.0).meets(&ball(0.0, 0.6), 0.0));
    assert!(ball(0.0, 1e-23).meets(&ball(2.65e-23, 2e-23), 0.0));
}

#[test]
fn an_axis_with_an_overflow_proves_nothing() {
    let ball = Volume::new(VolumeKind::Ball, [3.5e20_f32, 1e20], 2.2e20, &[]);
    let halves = [[1e18, -1e18], [2e20, 2e20]];
    let cuboid = Volume::new(VolumeKind::Cuboid, [0.0; 2], 0.0, &halves);
    assert!(ball.meets(&cuboid, 0.0) && cuboid.meets(&ball, 0.0));
}

#[test]
fn volumes_smaller_than_their_box_or_without_numbers_meet_all_others() {
    let ball = |x: f32| Volume::new(VolumeKind::Ball, [x, 0.0], 0.5, &[]);
    let capsule = |x: f32| Volume::new(VolumeKind::Capsule, [x, x], 0.25, &[[0.0, 0.5]]);
    let swept = Aabb::new([-0.5, -0.5], [1.5, 0.5]);
    assert!(!ball(0.0).meets(&ball(5.0), 0.0));
    assert!(in_box(ball(0.0), &swept).meets(&ball(5.0), 0.0));
    for volume in [capsule(f32::NAN), capsule(f32::INFINITY), Volume::BOX] {
        assert!(volume.meets(&ball(5.0), 0.0) && ball(5.0).meets(&volume, 0.0));
    }
}

#[cfg(feature = "serde-serialize")]
#[test]
fn volumes_survive_serialization_or_meet_all_others() {
    let mut random = Rand64::new(13);
    for kind in KINDS {
        let volume: Volume<f32, 3> = rounded(&volume(&mut random, kind, 3.0));
        let radius = volume.ball.radius;
        for (radius, kept) in [(radius, vec![radius]), (f32::INFINITY, vec![])] {
            let mut lost = Volume::new(kind, [f32::NAN; 3], radius, &volume.half_axes);
            lost.ball.radius = radius;
            assert_eq!(lost.as_ref().numbers(), kept);
            let found = Volume::<f32, 3>::of_numbers(kind, &kept).unwrap();
            assert!(found.kind == kind && found.meets(&volume, 0.0));
        }
    }
    // The volume of a negative radius can be written as well.
    let volume = Volume::<f32, 3>::new(VolumeKind::Ball, [0.0; 3], -1.0, &[]);
    let numbers = volume.as_ref().numbers();
    assert_eq!(Volume::of_numbers(VolumeKind::Ball, &numbers), Some(volume));
}
