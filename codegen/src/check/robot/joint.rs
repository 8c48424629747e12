//! The bodies of a joint, one for each of its motions.
//!
//! In: a joint, its motion, and its placement. Out: its bodies without mass, at the end of a list; the last of them is
//! the link.

use super::matrices::across;
use super::{Approximate, Contradiction, JointCoordinate, Places, RobotReader, fixed, held, place};
use crate::dense::{BodyId, DegreeOfFreedom, DenseBody, Matrix, Moved};
use crate::description::Joint;
use crate::expression::Arithmetic;
use crate::joint::{self, Along, Manifold, Movement};
use crate::list::List;

impl RobotReader<'_> {
    /// Adds the bodies of a joint whose motions follow one another; returns the last of them.
    pub(super) fn in_series(
        &self,
        joint: &Joint,
        motion: JointCoordinate<'_>,
        (mut parent, mut placement): (Option<BodyId>, Matrix<Approximate>),
        places: &Places<'_>,
        bodies: &mut List<BodyId, DenseBody>,
    ) -> Result<BodyId, Contradiction> {
        if !joint.kind.moves() {
            return Ok(bodies.push(fixed(parent, placement)));
        }
        let velocities = joint.kind.velocities(&joint.name.text);
        for (k, (own, degree_of_freedom)) in velocities.enumerate() {
            let screw = self.screw(joint, degree_of_freedom)?;
            let one = (Approximate::exact(1.0), Approximate::exact(0.0));
            let body = bodies.push(match motion {
                JointCoordinate::Held(at) => held(parent, placement, screw, at),
                JointCoordinate::Own => DenseBody {
                    parent,
                    placement,
                    ..places.along(&own, screw, one)?
                },
                JointCoordinate::Mimic(mimicked, factor, offset) => DenseBody {
                    parent,
                    placement,
                    ..places.along(mimicked, screw, (factor, offset))?
                },
            });
            for degree_of_freedom in &mut bodies[body].degrees_of_freedom {
                degree_of_freedom.actuator = self.actuator(joint, k);
            }
            (parent, placement) = (Some(body), Matrix::identity());
        }
        Ok(parent.expect("joints that move have velocities"))
    }

    /// Adds the body of a joint without an axis of its own, and, if its frame has other axes than the link's, a body
    /// for the link's frame; returns the last of them.
    pub(super) fn placed(
        &self,
        joint: &Joint,
        manifold: Manifold,
        (parent, mut placement): (Option<BodyId>, Matrix<Approximate>),
        places: &Places<'_>,
        bodies: &mut List<BodyId, DenseBody>,
    ) -> Result<BodyId, Contradiction> {
        let name = &joint.name.text;
        let rotation = match manifold {
            Manifold::Planar => Some(across(self.direction(joint, &joint.axis)?)),
            Manifold::Spherical | Manifold::Floating => None,
        };
        if let Some(rotation) = &rotation {
            placement = placement.times(rotation);
        }
        let coordinates = joint.kind.coordinates(name);
        let mut degrees_of_freedom = Vec::new();
        for (k, (own, degree_of_freedom)) in joint.kind.velocities(name).enumerate() {
            degrees_of_freedom.push(DegreeOfFreedom {
                screw: self.screw(joint, degree_of_freedom)?,
                velocity: place(places.velocities, &own)?,
                factor: Approximate::exact(1.0),
                actuator: self.actuator(joint, k),
            });
        }
        let body = bodies.push(DenseBody {
            parent,
            placement,
            moved: Moved::Manifold(manifold, place(places.coordinates, &coordinates[0].0)?),
            degrees_of_freedom,
            inertia: Matrix::zero(),
        });
        Ok(match rotation {
            Some(rotation) => bodies.push(fixed(Some(body), rotation.inverse())),
            None => body,
        })
    }

    pub(super) fn screw(
        &self,
        joint: &Joint,
        degree_of_freedom: joint::DegreeOfFreedom,
    ) -> Result<[[Approximate; 3]; 2], Contradiction> {
        let nothing = [Approximate::literal(0.0); 3];
        let axis = match degree_of_freedom.along {
            Along::Axis => self.direction(joint, &joint.axis)?,
            Along::Second => self.direction(joint, &joint.second_axis)?,
            Along::Frame(k) => {
                let mut axis = nothing;
                axis[k] = Approximate::literal(1.0);
                axis
            }
        };
        Ok(match degree_of_freedom.movement {
            Movement::Rotation => [axis, nothing],
            Movement::Translation => [nothing, axis],
            Movement::Helix => {
                let pitch = Approximate::written(joint.kind.pitch().unwrap_or_default().exact());
                [axis, axis.map(|entry| entry * pitch)]
            }
        })
    }
}
