//! The Pareto front: the methods that no other one beats in both accuracy and time.

/// The indices of the points for which no other point is as good in both coordinates and better in one, by the first
/// coordinate. Less is better. Of equal points there is the first one only. **O(n log n)**.
pub(crate) fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<_> = (0..points.len()).collect();
    let key = |index: usize| points[index];
    order.sort_by(|&a, &b| {
        let ((x, y), (other_x, other_y)) = (key(a), key(b));
        x.total_cmp(&other_x).then(y.total_cmp(&other_y))
    });
    let mut least = f64::INFINITY;
    order.retain(|&index| {
        let (_, y) = key(index);
        let is_better = y < least;
        least = least.min(y);
        is_better
    });
    order
}

/// The corners of the line below which no method lies: along the first coordinate, then down to the next point.
pub(crate) fn staircase(front: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut corners = Vec::new();
    for &(x, y) in front {
        if let Some(&(_, before)) = corners.last() {
            corners.push((x, before));
        }
        corners.push((x, y));
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::{front, staircase};

    #[test]
    fn the_front_has_what_nothing_beats() {
        let points = [
            (0.0, 5.0),
            (0.0, 4.0),
            (0.1, 4.0),
            (0.1, 3.0),
            (0.5, 3.5),
            (0.2, 1.0),
            (0.2, 1.0),
            (1.0, 2.0),
        ];
        assert_eq!(front(&points), [1, 3, 5]);
        assert_eq!(front(&[]), [0; 0]);
        assert_eq!(front(&[(0.3, 0.3)]), [0]);
    }

    #[test]
    fn no_point_of_the_front_is_beaten_and_every_other_one_is() {
        let mut random = oorandom::Rand32::new(5);
        let mut number = || f64::from(random.rand_range(0..20));
        let points: Vec<_> = (0..60).map(|_| (number(), number())).collect();
        let front = front(&points);
        let beats = |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
        for (index, &point) in points.iter().enumerate() {
            let is_beaten = points.iter().any(|&other| beats(other, point));
            let is_twin = points[..index].contains(&point);
            assert_eq!(front.contains(&index), !is_beaten && !is_twin);
        }
    }

    #[test]
    fn a_staircase_goes_along_and_down() {
        let corners = staircase(&[(0.0, 4.0), (0.1, 3.0), (0.2, 1.0)]);
        let expected = [(0.0, 4.0), (0.1, 4.0), (0.1, 3.0), (0.2, 3.0), (0.2, 1.0)];
        assert_eq!(corners, expected);
    }
}
