//! The few operations on 3 × 3 matrices that colours need, also at compile time.

use core::array::from_fn;

/// Row by row.
pub(super) type Matrix = [[f64; 3]; 3];

pub(super) const fn apply(m: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    [
        m[0][0] * x + m[0][1] * y + m[0][2] * z,
        m[1][0] * x + m[1][1] * y + m[1][2] * z,
        m[2][0] * x + m[2][1] * y + m[2][2] * z,
    ]
}

const fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The vector products of the rows are the columns of the inverse, times the determinant.
pub(super) const fn inverse(&[a, b, c]: &Matrix) -> Matrix {
    let (p, q, r) = (cross(b, c), cross(c, a), cross(a, b));
    let d = a[0] * p[0] + a[1] * p[1] + a[2] * p[2];
    [[p[0] / d, q[0] / d, r[0] / d], [p[1] / d, q[1] / d, r[1] / d], [p[2] / d, q[2] / d, r[2] / d]]
}

pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| {
        from_fn(|column| row[0] * b[0][column] + row[1] * b[1][column] + row[2] * b[2][column])
    })
}
