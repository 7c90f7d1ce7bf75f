//! Bodies that are where nothing should be.

use super::space::place_of;
use super::{Gauge, Place, Reading, World};

/// The share of the bodies that are outside at the end.
pub(crate) struct Outside {
    name: &'static str,
    is_outside: fn(Place, f64) -> bool,
    limit: f64,
    share: f64,
}

impl Outside {
    /// By a condition on a place and this limit.
    pub(crate) fn new(name: &'static str, limit: f64, is_outside: fn(Place, f64) -> bool) -> Self {
        Self {
            name,
            is_outside,
            limit,
            share: 0.0,
        }
    }
}

impl Gauge for Outside {
    fn look(&mut self, world: &World, _time: f64) {
        let bodies = world.bodies.iter().map(|(_, body)| body);
        let places = bodies.filter(|body| body.is_dynamic()).map(place_of);
        let [mut all, mut outside] = [0_u32; 2];
        for place in places {
            all += 1;
            let is_lost = place.iter().any(|x| !x.is_finite());
            outside += u32::from(is_lost || (self.is_outside)(place, self.limit));
        }
        self.share = f64::from(outside) / f64::from(all.max(1));
    }

    fn read(&self) -> Vec<Reading> {
        vec![Reading {
            name: self.name,
            value: self.share,
        }]
    }
}
