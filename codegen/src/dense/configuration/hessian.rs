//! Second derivatives of λᵀτ along a direction, by the product rule.
//!
//! In: a configuration, q̇, q̈, weights λ and a direction. Out: the derivative, along the direction, of each entry of the
//! gradient of λᵀτ. With Λ = Σ λ L of the joints that carry a link, λᵀτ = Σ Tr(Λᵗ H J), and its gradient is the sum
//! over links of what each coordinate or velocity changes there. All matrices have their derivative along the direction
//! beside them. Composite inertias, and closed formulas of derivatives, are not used.

use super::{Approximate, Configuration, Rates, along};
use crate::dense::{BodyId, Matrix};
use crate::expression::Double;
use crate::list::List;
use crate::space::VelocityId;

/// A direction in which first derivatives are differentiated.
#[derive(Clone, Copy)]
pub(in crate::dense) enum Direction<'a> {
    /// Changes of the configuration, along each velocity.
    Coordinates(&'a List<VelocityId, Approximate>),
    /// Changes of q̇.
    Rates(&'a List<VelocityId, Approximate>),
}

/// The derivatives of the gradient along a direction.
pub(in crate::dense) struct Gradient {
    /// Of its entries by q.
    pub(in crate::dense) q: List<VelocityId, Approximate>,
    /// Of those by q̇.
    pub(in crate::dense) qd: List<VelocityId, Approximate>,
    /// Of those by q̈.
    pub(in crate::dense) qdd: List<VelocityId, Approximate>,
}

/// A matrix with its derivative along the direction.
#[derive(Clone)]
struct Dual {
    value: Matrix<Approximate>,
    change: Matrix<Approximate>,
}

/// The matrices of a link.
struct LinkMatrices {
    /// The screws of its joint, with their velocities.
    screws: Vec<(VelocityId, Dual)>,
    inertia: Dual,
    lambda: Dual,
    w: Dual,
    /// H, less gravity.
    h: Dual,
    /// The external wrench, as far as it is on this link.
    action: Dual,
}

impl Configuration {
    /// The derivatives of the gradient of λᵀτ along a direction, with external wrenches.
    pub(in crate::dense) fn torque_hessian(
        &self,
        rates: &Rates,
        lambda: &List<VelocityId, Approximate>,
        actions: &[Double],
        direction: Direction<'_>,
    ) -> Gradient {
        let links = self.links_along(rates, lambda, actions, direction);
        let mut found = Gradient {
            q: self.nothing(),
            qd: self.nothing(),
            qdd: self.nothing(),
        };
        for (joint, body) in self.robot.bodies.numbered() {
            let base = || LinkMatrices::base(&self.minus_gravity());
            let outer = body
                .parent
                .map_or_else(base, |parent| links[parent].still());
            let carried = self.carried(joint);
            for (velocity, screw) in &links[joint].screws {
                let of_links = links.numbered().filter(|(link, _)| carried[*link]);
                for (_, link) in of_links {
                    let add = |sums: &mut List<VelocityId, Approximate>, term: Approximate| {
                        sums[*velocity] = sums[*velocity] + term;
                    };
                    add(
                        &mut found.q,
                        link.by_coordinate(&outer, screw, self.robot.external.1),
                    );
                    add(&mut found.qd, link.by_rate(&outer, &links[joint], screw));
                    add(&mut found.qdd, link.power(&screw.times(&link.inertia)));
                }
            }
        }
        found
    }

    /// All links, with their derivatives along a direction.
    fn links_along(
        &self,
        rates: &Rates,
        lambda: &List<VelocityId, Approximate>,
        actions: &[Double],
        direction: Direction<'_>,
    ) -> List<BodyId, LinkMatrices> {
        let mut links: List<BodyId, LinkMatrices> = List::new();
        // Σ L times the direction of the joints that carry a link.
        let mut turned: List<BodyId, Matrix<Approximate>> = List::new();
        for (k, body) in self.robot.bodies.numbered() {
            let mut moved = body
                .parent
                .map_or_else(Matrix::zero, |parent| turned[parent].clone());
            let mut faster = Matrix::zero();
            for (velocity, screw) in &self.screws[k] {
                match direction {
                    Direction::Coordinates(along) => {
                        moved = moved.plus(&screw.scaled(&along[*velocity]));
                    }
                    Direction::Rates(along) => {
                        faster = faster.plus(&screw.scaled(&along[*velocity]));
                    }
                }
            }
            let screws = self.screws[k].iter().map(|(velocity, screw)| {
                let change = moved.commutator(screw);
                (
                    *velocity,
                    Dual {
                        value: screw.clone(),
                        change,
                    },
                )
            });
            let screws: Vec<(VelocityId, Dual)> = screws.collect();
            let sum = |of: &List<VelocityId, Approximate>| {
                let terms = screws.iter().map(|(k, screw)| screw.scaled(&of[*k]));
                terms.fold(Dual::zero(), |sum, term| sum.plus(&term))
            };
            let base = || LinkMatrices::base(&self.minus_gravity());
            let outer = body
                .parent
                .map_or_else(base, |parent| links[parent].still());
            let mut own = sum(&rates.first);
            own.change = own.change.plus(&faster);
            let second = sum(&rates.second).plus(&own.times(&own));
            let mixed = outer.w.times(&own);
            let turned_by = |value: &Matrix<Approximate>| {
                let half = moved.times(value);
                half.plus(&value.times(&moved.transposed()))
            };
            let inertia = self.inertias[k].clone();
            let mut action = Dual::zero();
            for (_, wrench) in self
                .external_wrenches(actions)
                .filter(|(body, _)| *body == k)
            {
                action.value = action.value.plus(&wrench);
            }
            if !self.robot.external.1 {
                action.change = turned_by(&action.value);
            }
            links.push(LinkMatrices {
                inertia: Dual {
                    change: turned_by(&inertia),
                    value: inertia,
                },
                lambda: outer.lambda.plus(&sum(lambda)),
                w: outer.w.plus(&own),
                h: outer.h.plus(&second).plus(&mixed).plus(&mixed),
                screws,
                action,
            });
            turned.push(moved);
        }
        links
    }
}

impl LinkMatrices {
    /// The base, which accelerates against gravity.
    fn base(minus_gravity: &Matrix<Approximate>) -> Self {
        let h = Dual {
            value: minus_gravity.clone(),
            change: Matrix::zero(),
        };
        Self {
            h,
            ..Self::nothing()
        }
    }

    fn nothing() -> Self {
        Self {
            screws: Vec::new(),
            inertia: Dual::zero(),
            lambda: Dual::zero(),
            w: Dual::zero(),
            h: Dual::zero(),
            action: Dual::zero(),
        }
    }

    /// Its motion alone.
    fn still(&self) -> Self {
        Self {
            lambda: self.lambda.clone(),
            w: self.w.clone(),
            h: self.h.clone(),
            ..Self::nothing()
        }
    }

    /// The derivative along the direction of Tr(Λᵗ A).
    fn power(&self, of: &Dual) -> Approximate {
        trace(&self.lambda, of)
    }

    /// That of what a displacement along a screw changes in Tr(Λᵗ H J) and in the power of the external wrench.
    /// `outer` is the parent link of the joint.
    fn by_coordinate(&self, outer: &Self, screw: &Dual, in_frame_0: bool) -> Approximate {
        // What the joint carries moves as a whole: Λ − Λₚ, W − Wₚ and H − Hₚ − 2 Wₚ (W − Wₚ).
        let lambda = screw.commutator(&self.lambda.minus(&outer.lambda));
        let own = self.w.minus(&outer.w);
        let mixed = outer.w.times(&own);
        let relative = self.h.minus(&outer.h).minus(&mixed).minus(&mixed);
        let twice = outer.w.times(&screw.commutator(&own));
        let h = screw.commutator(&relative).plus(&twice).plus(&twice);
        let inertia = screw.times(&self.inertia);
        let inertia = inertia.plus(&inertia.transposed());
        let flow = h.times(&self.inertia).plus(&self.h.times(&inertia));
        let mut found = trace(&lambda, &self.h.times(&self.inertia)) + self.power(&flow);
        found = found - power(&lambda, &self.action);
        if !in_frame_0 {
            let turned = screw.times(&self.action);
            let turned = turned.plus(&self.action.times(&screw.transposed()));
            found = found - power(&self.lambda, &turned);
        }
        found
    }

    /// The same for a velocity. `own` is the link of the joint.
    fn by_rate(&self, outer: &Self, own: &Self, screw: &Dual) -> Approximate {
        // H = Hₚ + (Σ L q̇)² + 2 Wₚ Σ L q̇ at the joint's link, and 2 W of that link times the rest beyond.
        let rate = own.w.minus(&outer.w);
        let squares = screw.times(&rate).plus(&rate.times(screw));
        let mixed = outer
            .w
            .times(screw)
            .plus(&screw.times(&self.w.minus(&own.w)));
        let h = squares.plus(&mixed).plus(&mixed);
        self.power(&h.times(&self.inertia))
    }
}

impl Dual {
    fn zero() -> Self {
        Self {
            value: Matrix::zero(),
            change: Matrix::zero(),
        }
    }

    fn times(&self, other: &Self) -> Self {
        let change = self.change.times(&other.value);
        Self {
            value: self.value.times(&other.value),
            change: change.plus(&self.value.times(&other.change)),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            value: self.value.plus(&other.value),
            change: self.change.plus(&other.change),
        }
    }

    fn minus(&self, other: &Self) -> Self {
        Self {
            value: self.value.minus(&other.value),
            change: self.change.minus(&other.change),
        }
    }

    fn commutator(&self, other: &Self) -> Self {
        self.times(other).minus(&other.times(self))
    }

    fn transposed(&self) -> Self {
        Self {
            value: self.value.transposed(),
            change: self.change.transposed(),
        }
    }

    fn scaled(&self, factor: &Approximate) -> Self {
        Self {
            value: self.value.scaled(factor),
            change: self.change.scaled(factor),
        }
    }
}

/// The derivative of Tr(Aᵗ B).
fn trace(a: &Dual, b: &Dual) -> Approximate {
    a.change.dot(&b.value) + a.value.dot(&b.change)
}

/// The derivative of Λ ⊗ Φ.
fn power(lambda: &Dual, action: &Dual) -> Approximate {
    along(&lambda.change, &action.value) + along(&lambda.value, &action.change)
}
