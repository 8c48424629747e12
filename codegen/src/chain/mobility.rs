//! How much a joint can be accelerated by what acts on it: a bound of each diagonal entry of the
//! inverse of the mass matrix that holds in every state.
//!
//! In: a chain. Out: a number for each joint. It never looks at a posture: the rate of a joint is
//! the difference of what two bodies do about its axis, or along it, and their share of the kinetic
//! energy is there whatever the others do.

use super::frames::{Body, Layout, arrange};
use super::{Chain, Motion};
use crate::expression::{Double, Term};
use crate::matrix::{Rotation, Vector};

/// The bounds \[1/(kg m²), of joints that slide 1/kg\], infinite where one of the two bodies that a
/// joint connects has no inertia of the kind; none where something is known at run time only, or
/// where a body is none: then kinetic energy may be negative.
///
/// (M⁻¹)ₖₖ is the greatest q̇ₖ²/(q̇ᵗM q̇). With x and y what the two bodies do, q̇ₖ = x − y, and
/// q̇ᵗM q̇ ≥ x²/a + y²/b, this is at most a + b.
#[must_use]
pub fn mobility(chain: &Chain) -> Option<Vec<f64>> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED).bodies;
    let solids: Vec<Solid> = bodies.iter().map(Solid::of).collect::<Option<_>>()?;
    let joint = |(body, solid): (&Body<'_>, &Solid)| match body.parent {
        None => Some(solid.on_the_base(body.motion)),
        Some(parent) => {
            let parent = &solids[parent];
            let axis = [0, 1, 2].map(|row| body.placement.rotation.0[row][2]);
            let axis = numbers(axis)?;
            Some(match body.motion {
                Motion::Revolute | Motion::Screw(_) => solid.turns(Z) + parent.turns(axis),
                Motion::Prismatic => {
                    // A line along the axis moves along itself alike in both bodies; this one goes
                    // through the centre of mass of the outer one.
                    let centre = Vector::constant(&graph, solid.centre);
                    let through = numbers(body.placement.point(centre).0)?;
                    solid.slides(Z, solid.centre) + parent.slides(axis, through)
                }
            })
        }
    };
    bodies.iter().zip(&solids).map(joint).collect()
}

/// The axis of a joint in the frame of its body.
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A body as a mass with a rotational inertia about its centre, in the body's frame.
struct Solid {
    mass: f64,
    centre: [f64; 3],
    inertia: [[f64; 3]; 3],
}

impl Solid {
    /// None for what no body is, and for what is known at run time only.
    fn of(body: &Body<'_>) -> Option<Self> {
        let [mass] = numbers([body.inertia.mass])?;
        let first = numbers(body.inertia.q.0)?;
        let second = Rotation(body.inertia.second.rows()).0;
        let [xx, yy, zz] = [0, 1, 2].map(|k| numbers(second[k]));
        let second = [xx?, yy?, zz?];
        if mass < 0.0 || mass == 0.0 && first != [0.0; 3] {
            return None;
        }
        let centre = first.map(|q| if mass > 0.0 { q / mass } else { 0.0 });
        let about_centre =
            |row: usize, column: usize| second[row][column] - first[row] * centre[column];
        let trace: f64 = (0..3).map(|k| about_centre(k, k)).sum();
        let entry = |row, column| {
            let whole = if row == column { trace } else { 0.0 };
            whole - about_centre(row, column)
        };
        let inertia = [0, 1, 2].map(|row| [0, 1, 2].map(|column| entry(row, column)));
        inverse_form(inertia, [0.0; 3])?;
        Some(Self {
            mass,
            centre,
            inertia,
        })
    }

    /// a of ω² ≤ 2a T, where ω is the body's rate about an axis and T its kinetic energy.
    fn turns(&self, axis: [f64; 3]) -> f64 {
        inverse_form(self.inertia, axis).unwrap_or(f64::INFINITY)
    }

    /// a of v² ≤ 2a T, where v is the velocity, along an axis, of what is at a point.
    fn slides(&self, axis: [f64; 3], point: [f64; 3]) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|k| point[k] - self.centre[k]);
        let [u, v, w] = axis;
        self.mass.recip() + self.turns([y * w - z * v, z * u - x * w, x * v - y * u])
    }

    /// a of q̇² ≤ 2a T, where nothing else moves the body.
    fn on_the_base(&self, motion: Motion) -> f64 {
        let [x, y, _] = self.centre;
        match motion {
            Motion::Prismatic => self.mass.recip(),
            // A screw moves it along the axis as well.
            Motion::Revolute | Motion::Screw(_) => {
                (self.inertia[2][2] + self.mass * (x * x + y * y)).recip()
            }
        }
    }
}

/// xᵗA⁻¹x of a matrix without a negative direction: infinite where A resists nothing along x, none
/// where A has a negative direction.
fn inverse_form(mut a: [[f64; 3]; 3], mut x: [f64; 3]) -> Option<f64> {
    /// What a pivot is taken for zero below, in relation to the trace: files have rounded digits.
    const NOTHING: f64 = 1e-9;
    let nothing = NOTHING * (0..3).map(|k| a[k][k].abs()).sum::<f64>();
    let mut form = 0.0;
    for k in 0..3 {
        let (above, known) = (a[k], x[k]);
        let pivot = above[k];
        if pivot > nothing {
            form += known * known / pivot;
            for (below, x) in a.iter_mut().zip(&mut x).skip(k + 1) {
                let l = below[k] / pivot;
                *x -= l * known;
                for (entry, above) in below.iter_mut().zip(above) {
                    *entry -= l * above;
                }
            }
        } else if pivot < -nothing || above[k + 1..].iter().any(|entry| entry.abs() > nothing) {
            return None;
        } else if known != 0.0 {
            form = f64::INFINITY;
        }
    }
    Some(form)
}

fn numbers<const N: usize>(terms: [Term<'_>; N]) -> Option<[f64; N]> {
    let mut numbers = [0.0; N];
    for (number, term) in numbers.iter_mut().zip(terms) {
        *number = term.value().map(Double::to_f64)?;
    }
    Some(numbers)
}
