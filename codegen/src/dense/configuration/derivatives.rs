//! Derivatives of the torques of a motion by q and q̇, by the product rule.
//!
//! In: a configuration, q̇ and q̈. Out: matrices, with a row for each torque. A displacement along L changes the
//! matrices of the bodies that it carries by ∂L' = L L' − L' L and ∂J = L J + J Lᵗ; the rest follows from W, H and Φ
//! as sums and products of 4×4 matrices, whose changes are passed from link to link. Neither composite inertias nor
//! closed formulas of derivatives are used.

use super::{Approximate, Configuration, Rates};
use crate::dense::{BodyId, Matrix};
use crate::expression::Double;
use crate::list::{List, Square};
use crate::space::VelocityId;

/// The variable of a derivative.
#[derive(Clone, Copy, PartialEq, Eq)]
enum StateVariable {
    Coordinates,
    Rates,
}

/// The derivatives of a link's matrices.
struct LinkDerivatives {
    w: Matrix<Approximate>,
    h: Matrix<Approximate>,
    /// The derivative of each L of its joint.
    screws: Vec<Matrix<Approximate>>,
}

impl Configuration {
    /// ∂τ/∂q and ∂τ/∂q̇ of a motion, against gravity.
    pub(in crate::dense) fn torque_derivatives(
        &self,
        rates: &Rates,
    ) -> [Square<VelocityId, Approximate>; 2] {
        let [by_coordinate, mut by_rate] = [StateVariable::Coordinates, StateVariable::Rates]
            .map(|of| self.by_columns(|joint, screw| self.change(rates, joint, screw, of)));
        // Of the actuator's terms only viscous friction depends on q̇; the sign is constant between its steps.
        for degree_of_freedom in self.degrees_of_freedom() {
            let [_, damping, _] = degree_of_freedom.actuator;
            let own = &mut by_rate[(degree_of_freedom.velocity, degree_of_freedom.velocity)];
            *own = *own + degree_of_freedom.factor * degree_of_freedom.factor * damping;
        }
        [by_coordinate, by_rate]
    }

    /// ∂(Σ Jᵗ Φ)/∂q of external wrenches: Φ in the link's frame rotates with it, Φ in frame 0 is constant.
    pub(in crate::dense) fn external_derivative(
        &self,
        actions: &[Double],
    ) -> Square<VelocityId, Approximate> {
        let rotates = !self.robot.external.1;
        let actions: Vec<_> = self.external_wrenches(actions).collect();
        self.by_columns(|joint, along| {
            let carried = self.carried(joint);
            let mut torques = self.nothing();
            for (link, action) in &actions {
                let turned = along.times(action);
                let turned = turned.plus(&action.times(&along.transposed()));
                for body in self.inwards(*link) {
                    for (velocity, screw) in &self.screws[body] {
                        let mut change = Approximate::exact(0.0);
                        if carried[body] {
                            change = change + super::along(&along.commutator(screw), action);
                        }
                        if rotates && carried[*link] {
                            change = change + super::along(screw, &turned);
                        }
                        torques[*velocity] = torques[*velocity] + change;
                    }
                }
            }
            torques
        })
    }

    /// C of M q̈ + C q̇, from the part of H at q̈ = 0 that is linear in each q̇ₘ: Σ (L̇ₘ + Lₘ W) q̇ₘ.
    pub(in crate::dense) fn coriolis_matrix(
        &self,
        rates: &Rates,
    ) -> Square<VelocityId, Approximate> {
        let motions = self.motions(rates);
        self.by_columns(|joint, screw| {
            let (rate, carried) = (motions[joint].0.commutator(screw), self.carried(joint));
            self.forces(|link| carried[link].then(|| rate.plus(&screw.times(&motions[link].0))))
        })
    }

    /// A matrix by its columns. Each is the sum over all screws that belong to a velocity; `column` gets such a screw
    /// with the body whose joint has it.
    fn by_columns(
        &self,
        column: impl Fn(BodyId, &Matrix<Approximate>) -> List<VelocityId, Approximate>,
    ) -> Square<VelocityId, Approximate> {
        let mut matrix = Square::filled(Approximate::exact(0.0), self.robot.velocities);
        for (joint, screws) in self.screws.numbered() {
            for (velocity, screw) in screws {
                for (row, &own) in column(joint, screw).numbered() {
                    let entry = &mut matrix[(row, *velocity)];
                    *entry = *entry + own;
                }
            }
        }
        matrix
    }

    /// For each body, true if the joint of a body carries it.
    pub(super) fn carried(&self, joint: BodyId) -> List<BodyId, bool> {
        let mut carried = List::new();
        for (link, body) in self.robot.bodies.numbered() {
            let outer = body.parent.is_some_and(|parent| carried[parent]);
            carried.push(link == joint || outer);
        }
        carried
    }

    /// The derivative of the torques by a displacement or a velocity of a body's joint along a screw.
    fn change(
        &self,
        rates: &Rates,
        joint: BodyId,
        along: &Matrix<Approximate>,
        of: StateVariable,
    ) -> List<VelocityId, Approximate> {
        let carried = self.carried(joint);
        let motions = self.motions(rates);
        let minus_gravity = self.minus_gravity();
        let mut changes: List<BodyId, LinkDerivatives> = List::new();
        let mut actions: List<BodyId, [Matrix<Approximate>; 2]> = List::new();
        for (link, body) in self.robot.bodies.numbered() {
            let inertia = &self.inertias[link];
            let h = motions[link].1.plus(&minus_gravity);
            let action = h.times(inertia).skew();
            let screws = self.screws[link].iter().map(|(_, screw)| match of {
                StateVariable::Coordinates if carried[link] => along.commutator(screw),
                _ => Matrix::zero(),
            });
            let screws: Vec<_> = screws.collect();
            if !carried[link] {
                let (w, h) = (Matrix::zero(), Matrix::zero());
                changes.push(LinkDerivatives { w, h, screws });
                actions.push([action, Matrix::zero()]);
                continue;
            }
            let still = || (Matrix::zero(), Matrix::zero(), Matrix::zero());
            let (w, w_change, h_change) = body.parent.map_or_else(still, |parent| {
                let LinkDerivatives { w, h, .. } = &changes[parent];
                (motions[parent].0.clone(), w.clone(), h.clone())
            });
            // The derivative of H + Σ L q̈ + (Σ L q̇)² + 2 W Σ L q̇.
            let (mut own, mut own_change) = (Matrix::zero(), Matrix::zero());
            let mut second_change = Matrix::zero();
            for ((k, screw), change) in self.screws[link].iter().zip(&screws) {
                own = own.plus(&screw.scaled(&rates.first[*k]));
                own_change = own_change.plus(&change.scaled(&rates.first[*k]));
                second_change = second_change.plus(&change.scaled(&rates.second[*k]));
            }
            if of == StateVariable::Rates && link == joint {
                own_change = along.clone();
            }
            let squares = own_change.times(&own).plus(&own.times(&own_change));
            let mixed = w_change.times(&own).plus(&w.times(&own_change));
            let h_change = (h_change.plus(&second_change).plus(&squares))
                .plus(&mixed.scaled(&Approximate::exact(2.0)));
            let mut flow = h_change.times(inertia);
            if of == StateVariable::Coordinates {
                let turned = along.times(inertia);
                flow = flow.plus(&h.times(&turned.plus(&turned.transposed())));
            }
            actions.push([action, flow.skew()]);
            changes.push(LinkDerivatives {
                w: w_change.plus(&own_change),
                h: h_change,
                screws,
            });
        }
        let mut torques = self.nothing();
        for (link, body) in self.robot.bodies.numbered().rev() {
            let [action, action_change] = actions[link].clone();
            for ((k, screw), change) in self.screws[link].iter().zip(&changes[link].screws) {
                let own = super::along(screw, &action_change) + super::along(change, &action);
                torques[*k] = torques[*k] + own;
            }
            if let Some(parent) = body.parent {
                let [outer, outer_change] = &actions[parent];
                actions[parent] = [outer.plus(&action), outer_change.plus(&action_change)];
            }
        }
        torques
    }
}
