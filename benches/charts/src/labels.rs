//! Labels of points, put where they do not cover each other.

/// The width of a letter and the height of a line, at the size of the labels.
const LETTER: i32 = 7;
const LINE: i32 = 14;

/// How far a label is from its point.
const GAP: i32 = 11;

/// A rectangle on the page: left, top, right, bottom.
type Rectangle = [i32; 4];

/// What is taken already.
#[derive(Default)]
pub(crate) struct Labels(Vec<Rectangle>);

impl Labels {
    /// Keeps labels off a point of this radius.
    pub(crate) fn avoid(&mut self, (x, y): (i32, i32), radius: i32) {
        self.0
            .push([x - radius, y - radius, x + radius, y + radius]);
    }

    /// Where the upper left corner of a label should be, from its point: at the first place around it, nearer ones
    /// first, that is free and within these bounds.
    pub(crate) fn place(
        &mut self,
        (x, y): (i32, i32),
        text: &str,
        bounds: Rectangle,
    ) -> (i32, i32) {
        let width = LETTER * text.len() as i32;
        let around = (0..4).flat_map(|round| {
            let gap = GAP + round * LINE;
            [
                (gap - 3, gap - 6),
                (-width / 2, gap - 2),
                (-width / 2, -gap - LINE + 2),
                (3 - gap - width, -gap - LINE + 6),
                (gap, -LINE / 2),
                (-gap - width, -LINE / 2),
                (gap - 3, -gap - LINE + 6),
                (3 - gap - width, gap - 6),
            ]
        });
        let rectangle = |(dx, dy): (i32, i32)| [x + dx, y + dy, x + dx + width, y + dy + LINE];
        let is_free = |offset: &(i32, i32)| {
            let r = rectangle(*offset);
            let is_inside =
                r[0] >= bounds[0] && r[1] >= bounds[1] && r[2] <= bounds[2] && r[3] <= bounds[3];
            is_inside && !self.0.iter().any(|taken| overlap(taken, &r))
        };
        let offset = around.clone().find(is_free).unwrap_or((GAP, GAP));
        self.0.push(rectangle(offset));
        offset
    }
}

fn overlap(a: &Rectangle, b: &Rectangle) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

#[cfg(test)]
mod tests {
    use super::Labels;

    #[test]
    fn labels_of_one_point_go_to_different_places() {
        let mut labels = Labels::default();
        let bounds = [0, 0, 400, 400];
        let places: Vec<_> = (0..8)
            .map(|_| labels.place((200, 200), "0.05", bounds))
            .collect();
        for (i, place) in places.iter().enumerate() {
            assert!(!places[..i].contains(place));
        }
    }
}
