//! A rectangle cut into cells of about equal probability, by a k-d tree over points.

/// A rectangle in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Rectangle {
    pub from: [f64; 2],
    pub to: [f64; 2],
}

impl Rectangle {
    pub fn width(&self, axis: usize) -> f64 {
        self.to[axis] - self.from[axis]
    }

    /// The axis along which it is wider.
    pub fn longer(&self) -> usize {
        usize::from(self.width(1) > self.width(0))
    }

    pub fn area(&self) -> f64 {
        self.width(0) * self.width(1)
    }

    /// The ends along an axis, moved inwards by little: at the ends themselves, which may be the
    /// horizon, a function need not have its limit.
    pub fn inset(&self, axis: usize) -> [f64; 2] {
        let inset = 1e-5 * self.width(axis);
        [self.from[axis] + inset, self.to[axis] - inset]
    }

    /// Both parts of a cut across an axis.
    pub fn cut(self, axis: usize, at: f64) -> [Self; 2] {
        let (mut below, mut above) = (self, self);
        below.to[axis] = at;
        above.from[axis] = at;
        [below, above]
    }

    /// As many parts of the same size along either axis.
    pub fn cut_evenly(self, pieces: u32) -> impl Iterator<Item = Self> {
        let end = move |axis: usize, index: u32| {
            if index == pieces {
                self.to[axis]
            } else {
                self.from[axis] + self.width(axis) * f64::from(index) / f64::from(pieces)
            }
        };
        let places = (0..pieces).flat_map(move |x| (0..pieces).map(move |y| [x, y]));
        places.map(move |[x, y]| Self {
            from: [end(0, x), end(1, y)],
            to: [end(0, x + 1), end(1, y + 1)],
        })
    }

    pub fn cut_in_half(self, axis: usize) -> [Self; 2] {
        self.cut(axis, 0.5 * (self.from[axis] + self.to[axis]))
    }
}

/// Cells that fill a rectangle, narrow where points are dense.
pub struct Partition {
    nodes: Vec<Node>,
    cells: Vec<Rectangle>,
}

enum Node {
    /// Places below `at` belong to the next node, the others to node `above`.
    Cut {
        axis: usize,
        at: f64,
        above: usize,
    },
    Cell(usize),
}

impl Partition {
    /// Cuts until no cell holds more than `most` points. Wide margins without points become cells
    /// of their own, ever narrower towards the points: what lies beyond them, the tail of a lobe,
    /// is as wide as they are, and a rule with few nodes in a much wider cell would not see it.
    /// `lengths` are the lengths of a unit along the axes, by which widths are compared.
    pub fn grow(
        whole: Rectangle,
        mut points: Vec<[f64; 2]>,
        most: usize,
        lengths: [f64; 2],
    ) -> Self {
        let mut partition = Self { nodes: Vec::new(), cells: Vec::new() };
        partition.add(whole, &mut points, most, lengths);
        partition
    }

    pub fn cells(&self) -> &[Rectangle] {
        &self.cells
    }

    /// The cell of a place; the nearest one of a place outside.
    pub fn locate(&self, place: [f64; 2]) -> usize {
        let mut index = 0;
        loop {
            match self.nodes[index] {
                Node::Cut { axis, at, .. } if place[axis] < at => index += 1,
                Node::Cut { above, .. } => index = above,
                Node::Cell(cell) => return cell,
            }
        }
    }

    fn add(&mut self, cell: Rectangle, points: &mut [[f64; 2]], most: usize, lengths: [f64; 2]) {
        match choose_cut(&cell, points, most, lengths) {
            Some((axis, at)) => {
                let node = self.nodes.len();
                self.nodes.push(Node::Cut { axis, at, above: 0 });
                let [below, above] = cell.cut(axis, at);
                points.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
                let (left, right) = points.split_at_mut(points.partition_point(|p| p[axis] < at));
                self.add(below, left, most, lengths);
                self.nodes[node] = Node::Cut { axis, at, above: self.nodes.len() };
                self.add(above, right, most, lengths);
            }
            None => {
                self.nodes.push(Node::Cell(self.cells.len()));
                self.cells.push(cell);
            }
        }
    }
}

/// The axis and place of the next cut, if one is due.
fn choose_cut(
    cell: &Rectangle,
    points: &mut [[f64; 2]],
    most: usize,
    lengths: [f64; 2],
) -> Option<(usize, f64)> {
    if points.len() <= most {
        return None;
    }
    let ends = [0, 1].map(|axis| {
        points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, largest], point| {
            [least.min(point[axis]), largest.max(point[axis])]
        })
    });
    // Of the margins the one that is widest against the points, but for a quarter of it.
    let margins = [0, 1].into_iter().flat_map(|axis| {
        let [least, largest] = ends[axis];
        let (below, above) = (least - cell.from[axis], cell.to[axis] - largest);
        let range = largest - least;
        [(below / range, axis, least - 0.25 * below), (above / range, axis, largest + 0.25 * above)]
    });
    let wide = margins.filter(|margin| margin.0 > 1.0 && margin.0.is_finite());
    if let Some((_, axis, at)) = wide.max_by(|a, b| a.0.total_cmp(&b.0)) {
        return Some((axis, at));
    }
    let width = |axis: usize| (ends[axis][1] - ends[axis][0]) * lengths[axis];
    let axis = usize::from(width(1) > width(0));
    let middle = points.len() / 2;
    let (below, median, _) =
        points.select_nth_unstable_by(middle, |a, b| a[axis].total_cmp(&b[axis]));
    let before = below.iter().map(|point| point[axis]).fold(f64::NEG_INFINITY, f64::max);
    let at = 0.5 * (before + median[axis]);
    (at > before).then_some((axis, at))
}
