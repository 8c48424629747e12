//! Bounds of the velocities of joints and bodies by the kinetic energy, in every configuration. They show that
//! a mass matrix is positive definite, and how far it is from singular.
//!
//! In: a chain, its layout and the range of its fields. Out: bounds of the velocities of joints and bodies.
//! The configuration is not needed: the velocity of a joint is the difference of the velocities of its two
//! bodies about its axis, or along it, and both bodies have their share of the kinetic energy, whatever the
//! others do. A mass in a field is taken at its least: more of it only adds energy. Quaternions are taken to
//! have length 1, but for their rounding.

mod row;

use std::iter::successors;

use crate::chain::{BodyId, Chain, Position};
use crate::expression::{Double, Expr, Input, Term, evaluate};
use crate::joint::Motion;
use crate::layout::{Body, Layout};
use crate::list::{Id, List};
use crate::plan;
use crate::range::Range;
use crate::request::Target;
use crate::schedule::bound;
use crate::space::VelocityId;

/// Bounds of squares of velocities by twice the kinetic energy; infinite if a body has no inertia of the
/// kind.
#[derive(Clone, Debug)]
pub struct Mobility {
    /// For each velocity a bound of the diagonal entry of M⁻¹ \[1/(kg m²), of prismatic joints 1/kg\].
    pub joints: List<VelocityId, f64>,
    /// For each body bounds for ω \[1/(kg m²)\] and for the velocity of its frame's origin \[1/kg\].
    pub bodies: List<BodyId, [f64; 2]>,
}

/// Bounds the velocities of the joints and bodies of a chain.
///
/// (M⁻¹)ₖₖ is the greatest q̇ₖ²/(q̇ᵗM q̇). With x and y the velocities of the joint's two bodies along its axis,
/// q̇ₖ = x − y. From q̇ᵗM q̇ ≥ x²/a + y²/b it is at most a + b; with an armature c, which adds c q̇ₖ² to the energy,
/// at most 1/(1/(a + b) + c). Where bodies between have little inertia or none, bodies further away give bounds
/// (`mobility/row.rs`). A velocity that moves several joints, each by a factor, is bounded by each of them.
///
/// # Errors
/// The reason why there is no bound: a non-physical inertia, with which kinetic energy may be negative; centres
/// of mass, inertias or offsets that are known at run time only.
pub fn mobility(chain: &Chain, layout: Layout, range: &Range) -> Result<Mobility, &'static str> {
    let moves = |target: &Target| {
        use Target::{BasePlacement, CenterOfMassOf, InertiaOf, OriginOf, PlacementOf};
        let is_turned = matches!(target, BasePlacement | PlacementOf(_));
        is_turned || matches!(target, CenterOfMassOf(_) | InertiaOf(_) | OriginOf(_))
    };
    let read = chain.request.parameters.iter().zip(&chain.nominal);
    let read = read.filter(|(_, nominal)| !nominal.is_empty());
    if read.into_iter().any(|(field, _)| moves(&field.target)) {
        return Err(
            "centres of mass, inertias, offsets and placements that are fields are not followed",
        );
    }
    let graph = chain.graph.clone();
    let bodies = plan::arranged(&graph, chain, layout).bodies;
    let numbers: Vec<Expr> = (bodies.iter())
        .flat_map(|body| numbers(body).map(Term::expr))
        .collect();
    let numbers = evaluate(&graph, &numbers, |input| {
        let least = match input {
            // A payload never reduces the energy, so that the least energy is that without it.
            Input::Parameter(field, _) if chain.field(field.into()).target.is_payload() => {
                Some(0.0)
            }
            Input::Parameter(..) => range.get(input).map(|[least, _]| least),
            Input::Variable(..) => None,
        };
        Double::from(least.unwrap_or(f64::NAN))
    });
    let mut solids: List<BodyId, Solid> = List::new();
    for (body, numbers) in bodies.iter().zip(numbers.chunks(NUMBERS)) {
        let carrier = body
            .parent
            .map_or(Spin::Still, |parent| solids[parent].spin);
        let solid = Solid::of(body, numbers, carrier);
        solids.push(solid.ok_or("an inertia is none that a body has, as far as its digits tell")?);
    }
    // A joint with several degrees of freedom and no axis of its own is a run of bodies, of which only the last
    // has inertia.
    let last = |k: BodyId| {
        let taken = bodies.iter().skip(k.number());
        let taken = taken.take_while(|body| matches!(body.position, Position::Taken));
        k.plus(taken.count())
    };
    let whole: Vec<&Solid> = bodies.ids().map(|k| &solids[last(k)]).collect();
    // The parent of the first of them, and the distance at which it is seen.
    let carrier = |k: BodyId| {
        let taken = |k: &BodyId| matches!(bodies[*k].position, Position::Taken);
        let mut inwards = successors(Some(k), |k| bodies[*k].parent.filter(|_| taken(k)));
        let first = &bodies[inwards.find(|k| !taken(k))?];
        Some((&solids[first.parent?], reach(first, range)))
    };
    let joint = |(k, solid): (BodyId, &&Solid)| match solid.parent {
        _ if solid.free => {
            let (axis, translates) = (AXES[bodies[k].axis], bodies[k].motion.translates());
            let of_carrier =
                carrier(k).map_or(0.0, |(solid, reach)| solid.within(reach, translates));
            let own = if translates {
                solid.translation(axis, [0.0; 3])
            } else {
                solid.rotation(axis)
            };
            own + ROUNDED * of_carrier
        }
        None => solid.on_the_base,
        Some(parent) => {
            let parent = &solids[parent];
            let axis = [0, 1, 2].map(|row| solid.placement[3 * row + 2]);
            if solid.translates {
                // A line along the axis moves along itself alike in both bodies; this one goes through
                // the centre of mass of the outer one.
                let through = solid.seen_from_parent(solid.centre);
                solid.translation(Z, solid.centre) + parent.translation(axis, through)
            } else {
                solid.rotation(Z) + parent.rotation(axis)
            }
        }
    };
    let mut joints: List<BodyId, f64> = bodies.ids().zip(&whole).map(joint).collect();
    let reaches = bodies.iter().map(|body| reach(body, range)).collect();
    row::slowed(&mut joints, &solids, &reaches);
    // The armature's share of the energy comes on top.
    for (most, solid) in joints.iter_mut().zip(&solids) {
        if solid.armature > 0.0 {
            *most = (most.recip() + solid.armature).recip();
        }
    }
    let fastest = whole.into_iter().map(Solid::fastest).collect();
    let fastest = row::carried(fastest, &joints, &solids, &reaches);
    let mut of_velocities = List::filled(f64::INFINITY, chain.spaces().velocities.len());
    for (body, &most) in bodies.iter().zip(&joints) {
        let factor = body.factor().and_then(|factor| graph.term(factor).value());
        let factor = factor.map_or(1.0, Double::to_f64);
        let of_velocity = &mut of_velocities[body.velocity];
        // A mimic joint with factor 0 does not move, and gives no bound.
        *of_velocity = f64::min(*of_velocity, most / (factor * factor));
    }
    Ok(Mobility {
        joints: of_velocities,
        bodies: fastest,
    })
}

/// The largest distance of a body's origin from that of its parent \[m\]; infinite where it is unknown, as for a
/// screw joint.
pub(super) fn reach(body: &Body<'_>, range: &Range) -> f64 {
    let slide = match (body.position, body.motion) {
        (_, Motion::Screw(_)) => f64::INFINITY,
        (Position::Along { coordinate, .. }, Motion::Prismatic) => {
            let [lo, hi] = range.coordinate(coordinate);
            lo.abs().max(hi.abs())
        }
        (Position::Manifold(manifold, first), _) => {
            manifold.reach(|entry| range.coordinate(first.plus(entry)))
        }
        (Position::Along { .. }, Motion::Revolute) | (Position::Taken, _) => 0.0,
    };
    let number = |entry: Term<'_>| entry.value().map_or(f64::INFINITY, Double::to_f64);
    slide + bound::root(body.placement.translation.0.map(number))
}

/// The axis of a joint in the frame of its body.
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// The axes of a frame.
const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], Z];

/// Factor, with a margin, for the length of an axis rotated by a rounded quaternion in `f32`.
const ROUNDED: f64 = 1.0 + 1e-6;

/// Largest deviation of axes that count as parallel: a rounding in extended precision.
const PARALLEL: f64 = 1e-28;

/// Number of values that describe a body.
const NUMBERS: usize = 23;

/// m, q, ∫rrᵗdm (xx, yy, zz, xy, xz, yz), R by rows and t of the placement; the joint's armature.
fn numbers<'g>(body: &Body<'g>) -> [Term<'g>; NUMBERS] {
    let inertia = body.inertia;
    let rotation = body.placement.rotation.0.concat();
    std::array::from_fn(|k| match k {
        0 => inertia.mass,
        1..4 => inertia.q.0[k - 1],
        4..10 => inertia.second.0[k - 4],
        10..19 => rotation[k - 10],
        19..22 => body.placement.translation.0[k - 19],
        _ => body.actuator.armature,
    })
}

/// Directions of the angular velocity of a body.
#[derive(Clone, Copy)]
enum Spin {
    /// It does not rotate.
    Still,
    /// One direction in its frame, in every state.
    About([f64; 3]),
    /// Any direction.
    Any,
}

/// A body as a mass with a rotational inertia about its centre, in the body's frame.
struct Solid {
    parent: Option<BodyId>,
    translates: bool,
    screws: bool,
    /// True for a floating or planar joint, which has no axis of its own.
    free: bool,
    /// R by rows and t of the placement.
    placement: [f64; 12],
    mass: f64,
    centre: [f64; 3],
    inertia: [[Double; 3]; 3],
    spin: Spin,
    armature: f64,
    /// a of q̇² ≤ 2a T if the joint alone moved the body.
    on_the_base: f64,
}

impl Solid {
    /// `None` if the inertia is not physical.
    fn of(body: &Body<'_>, numbers: &[Double], carrier: Spin) -> Option<Self> {
        let mass = numbers[0];
        let first = [numbers[1], numbers[2], numbers[3]];
        let [xx, yy, zz, xy, xz, yz] = std::array::from_fn(|k| numbers[4 + k]);
        let second = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let some = first.iter().any(|q| q.to_f64() != 0.0);
        let regular = mass.to_f64() > 0.0 || mass.to_f64() == 0.0 && !some;
        if !regular {
            return None;
        }
        let centre = first.map(|q| {
            if mass.to_f64() > 0.0 {
                q / mass
            } else {
                Double::ZERO
            }
        });
        let about_centre =
            |row: usize, column: usize| second[row][column] - first[row] * centre[column];
        let trace = about_centre(0, 0) + about_centre(1, 1) + about_centre(2, 2);
        let inertia = [0, 1, 2].map(|row| {
            [0, 1, 2].map(|column| {
                let whole = if row == column { trace } else { Double::ZERO };
                whole - about_centre(row, column)
            })
        });
        inverse_form(inertia, [0.0; 3])?;
        let placement: [f64; 12] = std::array::from_fn(|k| numbers[10 + k].to_f64());
        let centre = centre.map(Double::to_f64);
        let mass = mass.to_f64();
        let translates = body.motion.translates();
        let on_the_base = if translates {
            mass.recip()
        } else {
            // A screw moves it along the axis as well.
            let [x, y, _] = centre;
            (inertia[2][2].to_f64() + mass * (x * x + y * y)).recip()
        };
        Some(Self {
            parent: body.parent,
            translates,
            screws: matches!(body.motion, Motion::Screw(_)),
            free: !body.has_own_axis(),
            placement,
            mass,
            centre,
            inertia,
            spin: if body.has_own_axis() {
                carrier.carried(&placement, translates)
            } else {
                Spin::Any
            },
            armature: numbers[22].to_f64(),
            on_the_base,
        })
    }

    /// Bounds for ω and for the velocity of its origin, in any direction.
    fn fastest(&self) -> [f64; 2] {
        let rotations = AXES.iter().map(|&axis| self.rotation(axis));
        let translations = AXES.iter().map(|&axis| self.translation(axis, [0.0; 3]));
        [rotations.sum(), translations.sum()]
    }

    /// Bound of the square of its ω, or of the velocity of a point within a distance from its origin, by twice the
    /// energy.
    fn within(&self, reach: f64, translates: bool) -> f64 {
        let [rotation, origin] = self.fastest();
        if !translates {
            return rotation;
        }
        // At distance zero nothing is added, even if ω has no bound.
        let across = if reach > 0.0 {
            reach * rotation.sqrt()
        } else {
            0.0
        };
        let speed = origin.sqrt() + across;
        speed * speed
    }

    /// a of ω² ≤ 2a T, where ω is the body's angular velocity about an axis and T its kinetic energy.
    fn rotation(&self, axis: [f64; 3]) -> f64 {
        match self.spin {
            _ if axis == [0.0; 3] => 0.0,
            Spin::Still => 0.0,
            Spin::About(direction) => {
                let along = dot(axis, direction);
                let share = along * along;
                let resists = if self.parent.is_none() {
                    self.on_the_base.recip()
                } else {
                    let rows = self
                        .inertia
                        .map(|row| dot(row.map(Double::to_f64), direction));
                    dot(rows, direction)
                };
                if share == 0.0 { 0.0 } else { share / resists }
            }
            Spin::Any => inverse_form(self.inertia, axis).unwrap_or(f64::INFINITY),
        }
    }

    /// a of v² ≤ 2a T, where v is the velocity along an axis of a body's point.
    fn translation(&self, axis: [f64; 3], point: [f64; 3]) -> f64 {
        if self.parent.is_none() && !self.translates && !self.free {
            let across = axis[1] * point[0] - axis[0] * point[1];
            let about = if across == 0.0 {
                0.0
            } else {
                across * across * self.on_the_base
            };
            // The translation of a screw joint along its axis is bounded by the mass alone.
            let along = if self.screws && axis[2] != 0.0 {
                self.mass.recip()
            } else {
                0.0
            };
            return about + along;
        }
        let [x, y, z] = [0, 1, 2].map(|k| point[k] - self.centre[k]);
        let [u, v, w] = axis;
        self.mass.recip() + self.rotation([y * w - z * v, z * u - x * w, x * v - y * u])
    }

    /// A point of this body in the parent's frame, at q = 0.
    fn seen_from_parent(&self, point: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|row| {
            let r = [0, 1, 2].map(|column| self.placement[3 * row + column]);
            dot(r, point) + self.placement[9 + row]
        })
    }
}

impl Spin {
    /// The directions of a body whose parent has these.
    fn carried(self, placement: &[f64; 12], translates: bool) -> Self {
        let seen = |direction: [f64; 3]| {
            let column = |k: usize| [0, 1, 2].map(|row| placement[3 * row + k]);
            [0, 1, 2].map(|k| dot(column(k), direction))
        };
        match self {
            Self::Still if translates => Self::Still,
            Self::Still => Self::About(Z),
            Self::About(direction) if translates => Self::About(seen(direction)),
            Self::About(direction) => {
                let [x, y, _] = seen(direction);
                let along = x.abs().max(y.abs()) <= PARALLEL;
                if along { Self::About(Z) } else { Self::Any }
            }
            Self::Any => Self::Any,
        }
    }
}

/// xᵗA⁻¹x of a positive semidefinite matrix: infinite where A resists nothing along x; `None` where A may be
/// indefinite. A pivot that is zero within the 106 bits counts as zero: it is far below what an operation of
/// generated code loses.
fn inverse_form(mut a: [[Double; 3]; 3], x: [f64; 3]) -> Option<f64> {
    let mut x = x.map(Double::from);
    let mut form = 0.0;
    for k in 0..3 {
        let (above, known) = (a[k], x[k]);
        let pivot = above[k];
        if pivot.is_sharp() && pivot.to_f64() > 0.0 {
            let share = known * known / pivot;
            form += share.to_f64() + share.radius();
            for (below, x) in a.iter_mut().zip(&mut x).skip(k + 1) {
                let l = below[k] / pivot;
                *x = *x - l * known;
                for (entry, above) in below.iter_mut().zip(above) {
                    *entry = *entry - l * above;
                }
            }
        } else if !pivot.is_zero() || above[k + 1..].iter().any(|entry| !entry.is_zero()) {
            return None;
        } else if !known.is_zero() {
            form = f64::INFINITY;
        }
    }
    Some(form)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}
