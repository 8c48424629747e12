//! The bodies of a joint, each beyond one of its motions.
//!
//! In: a joint, what moves it, and where it stands. Out: its bodies without mass, at the end of a list. What
//! the last of them moves is the link.

use super::matrices::across;
use super::{Contradiction, Motion, Places, Reader, Scalar, held, place};
use crate::dense::{Body, BodyId, Freedom, Matrix, Moved};
use crate::description::Joint;
use crate::expression::{Arithmetic, Double};
use crate::joint::{self, Along, Movement, Posture};
use crate::list::List;

impl Reader<'_> {
    /// Adds the bodies of a joint whose motions come one after the other; the last of them.
    pub(super) fn in_series(
        &self,
        joint: &Joint,
        motion: Motion<'_>,
        (mut parent, mut placement): (Option<BodyId>, Matrix<Scalar>),
        places: &Places<'_>,
        bodies: &mut List<BodyId, Body>,
    ) -> Result<BodyId, Contradiction> {
        if !joint.kind.moves() {
            let nothing = [[Scalar::literal(0.0); 3]; 2];
            return Ok(bodies.push(held(parent, placement, nothing, Double::ZERO)));
        }
        let velocities = joint.kind.velocities(&joint.name.text);
        for (k, (own, freedom)) in velocities.enumerate() {
            let screw = self.screw(joint, freedom)?;
            let one = (Scalar::exact(1.0), Scalar::exact(0.0));
            let body = bodies.push(match motion {
                Motion::Held(at) => held(parent, placement, screw, at),
                Motion::Own => Body {
                    parent,
                    placement,
                    ..places.along(&own, screw, one)?
                },
                Motion::Follows(leader, factor, offset) => Body {
                    parent,
                    placement,
                    ..places.along(leader, screw, (factor, offset))?
                },
            });
            for freedom in &mut bodies[body].freedoms {
                freedom.drive = self.drive(joint, k);
            }
            (parent, placement) = (Some(body), Matrix::identity());
        }
        Ok(parent.expect("joints that move have velocities"))
    }

    /// Adds the bodies of a joint whose coordinates are a posture: its own, and, where that is seen in other
    /// axes than the link's, the link's; the last of them.
    pub(super) fn placed(
        &self,
        joint: &Joint,
        posture: Posture,
        (parent, mut placement): (Option<BodyId>, Matrix<Scalar>),
        places: &Places<'_>,
        bodies: &mut List<BodyId, Body>,
    ) -> Result<BodyId, Contradiction> {
        let name = &joint.name.text;
        let turn = match posture {
            Posture::Planar => Some(across(self.direction(joint, &joint.axis)?)),
            Posture::Spherical | Posture::Floating => None,
        };
        if let Some(turn) = &turn {
            placement = placement.times(turn);
        }
        let coordinates = joint.kind.coordinates(name);
        let mut freedoms = Vec::new();
        for (k, (own, freedom)) in joint.kind.velocities(name).enumerate() {
            freedoms.push(Freedom {
                screw: self.screw(joint, freedom)?,
                velocity: place(places.velocities, &own)?,
                factor: Scalar::exact(1.0),
                drive: self.drive(joint, k),
            });
        }
        let body = bodies.push(Body {
            parent,
            placement,
            moved: Moved::Posture(posture, place(places.coordinates, &coordinates[0].0)?),
            freedoms,
            inertia: Matrix::zero(),
        });
        Ok(match turn {
            Some(turn) => {
                let nothing = [[Scalar::literal(0.0); 3]; 2];
                bodies.push(held(Some(body), turn.inverse(), nothing, Double::ZERO))
            }
            None => body,
        })
    }

    pub(super) fn screw(
        &self,
        joint: &Joint,
        freedom: joint::Freedom,
    ) -> Result<[[Scalar; 3]; 2], Contradiction> {
        let nothing = [Scalar::literal(0.0); 3];
        let axis = match freedom.along {
            Along::Axis => self.direction(joint, &joint.axis)?,
            Along::Second => self.direction(joint, &joint.second_axis)?,
            Along::Frame(k) => {
                let mut axis = nothing;
                axis[k] = Scalar::literal(1.0);
                axis
            }
        };
        Ok(match freedom.movement {
            Movement::Turn => [axis, nothing],
            Movement::Slide => [nothing, axis],
            Movement::Helix => {
                let pitch = Scalar::written(joint.kind.pitch().unwrap_or_default().exact());
                [axis, axis.map(|entry| entry * pitch)]
            }
        })
    }
}
