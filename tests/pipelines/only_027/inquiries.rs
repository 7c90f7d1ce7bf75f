//! Random worlds, random questions: the answers of both broad phases.
//!
//! With the default margin, the boxes of both are the same. With another one they are not, but boxes only rule out
//! what need not be tested: all answers are the same, except to the query about boxes itself.
//!
//! `cast_shape_nonlinear` is not among the questions (`queries` has it): Parry runs the same cast against a ball around each node of the
//! tree, and for some sizes and speeds that does not end, or reports a false hit. So the answer depends on the tree.

use proptest::test_runner::{Config, TestRunner};

use super::answers::Nearest;
use super::rapier::parry::bounding_volume::BoundingVolume;
use super::rapier::parry::query::ShapeCastOptions;
use super::rapier::prelude::*;
use super::watched::{Watched, builder, isometry, vector};
use crate::questions::{Cast, DEFAULT_MARGIN, Inquiry, Line, Question};
use crate::strategies::inquiries;

/// Worlds, unless `PROPTEST_CASES` says otherwise.
const CASES: u32 = 64;

#[test]
fn the_same_answers() {
    let mut config = Config {
        failure_persistence: None,
        ..Config::default()
    };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = CASES;
    }
    let outcome = TestRunner::new(config).run(&inquiries(), |inquiry| {
        play(&inquiry);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

fn play(inquiry: &Inquiry) {
    let mut asked = Asked {
        watched: Watched::new(inquiry.margin),
        are_boxes_the_same: inquiry.margin == DEFAULT_MARGIN,
    };
    for round in &inquiry.rounds {
        for &change in &round.changes {
            asked.watched.change(change);
        }
        for _ in 0..round.steps {
            asked.watched.step();
        }
        asked.watched.check_trees();
        for &(question, filter) in &round.questions {
            let multiples = filter.multiples.unwrap_or(u32::MAX);
            let is_none =
                |handle: ColliderHandle, _: &Collider| handle.into_raw_parts().0 % multiples != 0;
            let mut filter = asked.watched.filter(filter);
            if multiples != u32::MAX {
                filter.predicate = Some(&is_none);
            }
            asked.compare(question, filter);
        }
    }
}

struct Asked {
    watched: Watched,
    are_boxes_the_same: bool,
}

impl Asked {
    fn compare(&mut self, question: Question, filter: QueryFilter<'_>) {
        match question {
            Question::Ray(line) => self.ray(line, filter),
            Question::Point(at, solid) => self.point(vector(at).into(), solid, filter),
            Question::Shape(shape, pose) => {
                let (shape, pose) = (builder(shape).shape, isometry(pose));
                self.watched.compare_all(filter, |scene| {
                    let found = scene.intersect_shape(pose, &*shape);
                    found.map(|(handle, _)| (handle, String::new())).collect()
                });
            }
            Question::Region(center, half) => {
                if self.are_boxes_the_same {
                    let region = Aabb::from_half_extents(vector(center).into(), vector(half));
                    self.watched.compare_all(filter, |scene| {
                        // Parry does not look at the boxes of leaves that are children of the root.
                        let meets = |handle: ColliderHandle| {
                            let leaf = scene.bvh.leaf_node(handle.into_raw_parts().0);
                            leaf.is_some_and(|leaf| leaf.aabb().intersects(&region))
                        };
                        let found = scene.intersect_aabb_conservative(region);
                        let found = found.filter(|&(handle, _)| meets(handle));
                        found.map(|(handle, _)| (handle, String::new())).collect()
                    });
                }
            }
            Question::Cast(cast) => self.cast(cast, filter),
        }
    }

    fn ray(&mut self, line: Line, filter: QueryFilter<'_>) {
        let (reach, solid) = (line.reach.into(), line.solid);
        let ray = Ray::new(vector(line.origin).into(), vector(line.direction));
        self.watched.compare_all(filter, |scene| {
            let hits = scene.intersect_ray(ray, reach, solid);
            hits.map(|(handle, _, hit)| (handle, format!("{hit:?}")))
                .collect()
        });
        self.watched.compare_nearest(filter, |scene| {
            let hit = scene.cast_ray(&ray, reach, solid);
            hit.map(|(handle, time)| Nearest::new(handle, time, ()))
        });
        self.watched.compare_nearest(filter, |scene| {
            let hit = scene.cast_ray_and_get_normal(&ray, reach, solid);
            hit.map(|(handle, hit)| Nearest::new(handle, hit.time_of_impact, hit))
        });
    }

    fn point(&mut self, point: Point<Real>, solid: bool, filter: QueryFilter<'_>) {
        self.watched.compare_all(filter, |scene| {
            let found = scene.intersect_point(point);
            found.map(|(handle, _)| (handle, String::new())).collect()
        });
        if !self.watched.has_any(filter) {
            // Parry panics if there is nothing to project on.
            return;
        }
        self.watched.compare_nearest(filter, |scene| {
            let nearest = scene.project_point(&point, Real::MAX, solid);
            nearest.map(|(handle, projection)| {
                let distance = (projection.point - point).norm();
                Nearest::new(handle, distance, projection)
            })
        });
        self.watched.compare_nearest(filter, |scene| {
            let nearest = scene.project_point_and_get_feature(&point);
            nearest.map(|(handle, projection, feature)| {
                let distance = (projection.point - point).norm();
                Nearest::new(handle, distance, (projection, feature))
            })
        });
    }

    fn cast(&mut self, cast: Cast, filter: QueryFilter<'_>) {
        let shape = builder(cast.shape).shape;
        let (pose, velocity) = (isometry(cast.pose), vector(cast.velocity));
        let options = ShapeCastOptions {
            max_time_of_impact: cast.reach.into(),
            target_distance: cast.target_distance.into(),
            stop_at_penetration: cast.stop_at_penetration,
            compute_impact_geometry_on_penetration: true,
        };
        self.watched.compare_nearest(filter, |scene| {
            let hit = scene.cast_shape(&pose, &velocity, &*shape, options);
            hit.map(|(handle, hit)| Nearest::new(handle, hit.time_of_impact, hit))
        });
    }
}
