//! Inverses of matrices whose columns are nearly alike.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Eye planes.
pub const EYE_PLANES: Check = Check {
    name: "eye-plane-inverse",
    citation: "GL 2.1, 2.11.4, equation 2.5: (p1' p2' p3' p4') = (p1 p2 p3 p4) M^-1",
    what: "the rows of the inverse of integer matrices of determinant 1 with elements up to 1e6, by glGetTexGendv",
    unit: Unit::Ulp,
    tolerance: 0.0,
    why: "the inverse is of integers below 2^24, which f32 has exactly; the matrix is inverted in more digits than f32 has",
    run: eye_planes,
};

type Matrix = [[i64; 4]; 4];

const IDENTITY: Matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// A product of shears, and its inverse, by rows; all elements below 2^23.
fn sheared(rng: &mut Rng) -> [Matrix; 2] {
    let (mut matrix, mut inverse) = (IDENTITY, IDENTITY);
    loop {
        let (i, j) = (rng.integer(0, 3) as usize, rng.integer(0, 3) as usize);
        if i == j {
            continue;
        }
        let by = rng.integer(-30, 30);
        let (mut shear, mut back) = (IDENTITY, IDENTITY);
        (shear[i][j], back[i][j]) = (by, -by);
        let next = [product(&matrix, &shear), product(&back, &inverse)];
        if next.iter().flatten().flatten().any(|element| element.abs() >= 1 << 23) {
            return [matrix, inverse];
        }
        [matrix, inverse] = next;
    }
}

/// A matrix, its inverse, and the plane that is a row of the identity.
#[derive(Clone, Copy, Debug)]
struct Case {
    matrix: Matrix,
    inverse: Matrix,
    row: usize,
}

fn eye_planes(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("eye-plane-inverse");
    let cases: Vec<Case> = (0..harness.cases(256))
        .flat_map(|_| {
            let [matrix, inverse] = sheared(&mut rng);
            [0, 1, 2, 3].map(|row| Case { matrix, inverse, row })
        })
        .collect();
    let largest = |matrix: &Matrix| {
        matrix.iter().flatten().fold(0.0, |most: f64, element| most.max(element.abs() as f64))
    };
    let stiff = cases.iter().filter(|case| largest(&case.matrix) * largest(&case.inverse) > 1e8);
    tally.reach("matrices of condition 1e8", stiff.count(), cases.len() / 2);
    let expect = |case: &Case, variant: Variant| match variant.has(Mutation::EyePlaneNotMoved) {
        true => IDENTITY[case.row].map(|c| c as f64),
        false => case.inverse[case.row].map(|c| c as f64),
    };
    harness.compare(tally, &"eye planes", &cases, expect, |session| {
        let mut planes = Vec::with_capacity(cases.len());
        for Case { matrix, row, .. } in &cases {
            // By columns.
            let m: [f64; 16] = std::array::from_fn(|at| matrix[at % 4][at / 4] as f64);
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixd(&m);
            glTexGendv(GL_S, GL_EYE_PLANE, &IDENTITY[*row].map(|c| c as f64));
            let mut plane = [0.0f64; 4];
            glGetTexGendv(GL_S, GL_EYE_PLANE, &mut plane);
            planes.push(plane);
        }
        session.check("setting eye planes")?;
        Ok(planes)
    })
}
