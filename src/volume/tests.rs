//! Volumes that touch must meet, by however little; volumes that are apart should be told apart.

use oorandom::Rand64;

use super::*;

const KINDS: [VolumeKind; 3] = [VolumeKind::Ball, VolumeKind::Capsule, VolumeKind::Cuboid];

/// A volume of about this size, and its farthest point in some direction, both as exactly as `f64` can say.
struct Placed<const D: usize> {
    center: [f64; D],
    radius: f64,
    halves: Vec<[f64; D]>,
    kind: VolumeKind,
}

impl<const D: usize> Placed<D> {
    fn random(random: &mut Rand64, kind: VolumeKind, place: f64, size: f64) -> Self {
        let mut vector =
            |length: f64| core::array::from_fn(|_| length * (random.rand_float() * 2.0 - 1.0));
        let center = vector(place);
        let mut halves: Vec<[f64; D]> = Vec::new();
        while halves.len() < kind.axes::<D>() {
            // At right angles to those before.
            let mut half: [f64; D] = vector(size);
            for &other in &halves {
                let along = dot(half, other) / dot(other, other);
                half = core::array::from_fn(|k| half[k] - along * other[k]);
            }
            if dot(half, half) > 1e-3 * size * size {
                halves.push(half);
            }
        }
        Self {
            center,
            radius: size * random.rand_float() * if kind == VolumeKind::Cuboid { 0.1 } else { 1.0 },
            halves,
            kind,
        }
    }

    fn farthest(&self, direction: [f64; D]) -> [f64; D] {
        let length = dot(direction, direction).sqrt();
        let mut point: [f64; D] =
            core::array::from_fn(|k| self.center[k] + self.radius * direction[k] / length);
        for &half in &self.halves {
            let sign = if dot(half, direction) < 0.0 {
                -1.0
            } else {
                1.0
            };
            point = core::array::from_fn(|k| point[k] + sign * half[k]);
        }
        point
    }

    fn rounded<R: Real>(&self) -> Volume<R, D> {
        let halves: Vec<_> = self
            .halves
            .iter()
            .map(|half| half.map(R::from_f64))
            .collect();
        let center = self.center.map(R::from_f64);
        Volume::new(self.kind, center, R::from_f64(self.radius), &halves)
    }

    /// The box around it.
    fn aabb<R: Real>(&self) -> Aabb<R, D> {
        let reach: [f64; D] = core::array::from_fn(|k| {
            self.halves
                .iter()
                .fold(self.radius, |sum, half| sum + half[k].abs())
        });
        Aabb::new(
            core::array::from_fn(|k| R::from_f64(self.center[k] - reach[k])),
            core::array::from_fn(|k| R::from_f64(self.center[k] + reach[k])),
        )
    }
}

/// Two volumes that touch in one point, in this direction from the first one, or are as far apart in it.
fn touching<const D: usize>(
    random: &mut Rand64,
    [first, second]: [VolumeKind; 2],
    place: f64,
    gap: f64,
) -> [Placed<D>; 2] {
    let a = Placed::random(random, first, place, 1.0);
    let mut b = Placed::random(random, second, place, 1.0);
    let direction: [f64; D] = core::array::from_fn(|_| random.rand_float() * 2.0 - 1.0);
    let length = dot(direction, direction).sqrt();
    let (from, to) = (a.farthest(direction), b.farthest(direction.map(|x| -x)));
    b.center =
        core::array::from_fn(|k| b.center[k] + from[k] - to[k] + gap * direction[k] / length);
    [a, b]
}

fn all_that_touch_meet<R: Real, const D: usize>() {
    let mut random = Rand64::new(11);
    for place in [0.0, 1.0, 30.0, 1e3, 1e6] {
        for first in KINDS {
            for second in KINDS {
                for _ in 0..300 {
                    let pair = touching::<D>(&mut random, [first, second], place, 0.0);
                    let [a, b] = pair.each_ref().map(Placed::rounded::<R>);
                    assert!(a.meets(&b, R::ZERO) && b.meets(&a, R::ZERO), "{a:?} {b:?}");
                    // As in a broad phase, where a ball is what its box says.
                    let [a, b] = [0, 1].map(|i| [a, b][i].in_box(&pair[i].aabb()));
                    assert!(
                        !a.ball.center[0].to_f64().is_nan(),
                        "{a:?} does not fill its box"
                    );
                    assert!(a.meets(&b, R::ZERO), "{a:?} {b:?}");
                    // And anything that is nearer than the slack.
                    let pair = touching::<D>(&mut random, [first, second], place, 0.125);
                    let [a, b] = pair.each_ref().map(Placed::rounded::<R>);
                    assert!(a.meets(&b, R::from_f64(0.125)), "{a:?} {b:?}");
                }
            }
        }
    }
}

#[test]
fn volumes_that_touch_meet_whatever_the_rounding() {
    all_that_touch_meet::<f32, 2>();
    all_that_touch_meet::<f32, 3>();
    all_that_touch_meet::<f64, 2>();
    all_that_touch_meet::<f64, 3>();
}

/// How many of those that are apart in a random direction are told apart.
fn told_apart<const D: usize>(kinds: [VolumeKind; 2]) -> usize {
    let mut random = Rand64::new(12);
    let is_told = |_: &i32| {
        let pair = touching::<D>(&mut random, kinds, 10.0, 0.01);
        let [a, b] = pair.each_ref().map(Placed::rounded::<f32>);
        !a.meets(&b, 0.0)
    };
    (0..1000).filter(is_told).count()
}

#[test]
fn volumes_that_are_apart_are_told_apart() {
    use VolumeKind::{Ball, Capsule, Cuboid};
    for kinds in [
        [Ball, Ball],
        [Ball, Capsule],
        [Capsule, Ball],
        [Capsule, Capsule],
    ] {
        // Nearly parallel capsules have no good axis.
        assert!(told_apart::<2>(kinds) >= 995, "{kinds:?}");
        assert!(told_apart::<3>(kinds) >= 995, "{kinds:?}");
    }
    // Of two edges, not all axes are tried.
    for (kinds, in_2d, in_3d) in [
        ([Ball, Cuboid], 995, 995),
        ([Cuboid, Ball], 995, 995),
        ([Cuboid, Cuboid], 980, 800),
        ([Cuboid, Capsule], 750, 330),
    ] {
        assert!(told_apart::<2>(kinds) >= in_2d, "{kinds:?}");
        assert!(told_apart::<3>(kinds) >= in_3d, "{kinds:?}");
    }
}

#[test]
fn a_half_space_is_told_apart_from_what_is_in_front_of_it() {
    let plane = Volume::new(VolumeKind::HalfSpace, [1.0, 2.0], 0.0, &[[0.6, 0.8]]);
    let at = |distance: f32| {
        let center = [1.0 + 0.6 * distance + 8.0, 2.0 + 0.8 * distance - 6.0];
        Volume::new(VolumeKind::Capsule, center, 0.25, &[[0.3, 0.4]])
    };
    for (distance, meets) in [
        (-9.0, true),
        (0.0, true),
        (0.7499, true),
        (0.7501, false),
        (9.0, false),
    ] {
        assert_eq!(plane.meets(&at(distance), 0.0), meets, "{distance}");
        assert_eq!(at(distance).meets(&plane, 0.0), meets, "{distance}");
    }
    assert!(plane.meets(&at(0.85), 0.125) && plane.meets(&plane, 0.0));
}

#[test]
fn what_does_not_fill_its_box_or_has_no_numbers_meets_all() {
    let ball = |x: f32| Volume::new(VolumeKind::Ball, [x, 0.0], 0.5, &[]);
    let capsule = |x: f32| Volume::new(VolumeKind::Capsule, [x, x], 0.25, &[[0.0, 0.5]]);
    let swept = Aabb::new([-0.5, -0.5], [1.5, 0.5]);
    for volume in [ball(0.0), capsule(0.0)] {
        assert!(!volume.meets(&ball(5.0), 0.0));
        assert!(volume.in_box(&swept).meets(&ball(5.0), 0.0));
    }
    for volume in [capsule(f32::NAN), capsule(f32::INFINITY), Volume::BOX] {
        assert!(volume.meets(&ball(5.0), 0.0) && ball(5.0).meets(&volume, 0.0));
    }
}

#[cfg(feature = "serde-serialize")]
#[test]
fn numbers_make_the_volume_again_or_one_that_meets_all() {
    let mut random = Rand64::new(13);
    for kind in KINDS {
        let volume = Placed::<3>::random(&mut random, kind, 3.0, 1.0).rounded::<f32>();
        let numbers = volume.as_ref().numbers();
        assert_eq!(Volume::of_numbers(kind, &numbers), Some(volume));
        assert_eq!(Volume::<f32, 3>::of_numbers(kind, &numbers[..3]), None);
        let radius = volume.ball.radius;
        for (radius, kept) in [(radius, vec![radius]), (f32::INFINITY, vec![])] {
            let lost = Volume::new(kind, [f32::NAN; 3], radius, &volume.half_axes);
            let ball = Ball {
                radius,
                ..lost.ball
            };
            assert_eq!(Volume { ball, ..lost }.as_ref().numbers(), kept);
            let found = Volume::<f32, 3>::of_numbers(kind, &kept).unwrap();
            assert!(found.kind == kind && found.meets(&volume, 0.0));
        }
    }
}
