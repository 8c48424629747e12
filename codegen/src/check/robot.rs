//! A robot as it was described: every link a body, every joint where it stands, nothing merged.
//!
//! In: a description, a request, and what was reported of both: the order of q and the numbers that
//! were taken for right angles or zero. Out: a [`Robot`] whose placements are products of the
//! elementary motions that were written. It shares no step with [`crate::chain`], whose merging,
//! locking and cutting are to be checked; what a report claims of a number is checked against its
//! digits.

use std::collections::HashMap;
use std::f64::consts::FRAC_PI_2;

use crate::chain::Chain;
use crate::dense::{Approximate, Body, BodyId, Closed, Freedom, Matrix, Moved, Robot};
use crate::description::{
    Axis, Description, Inertial, Joint, Link, LinkId, Mimic, Name, Number, Step,
};
use crate::expression::{Arithmetic, Double};
use crate::joint::drive::Part;
use crate::joint::{self, Along, Movement, Posture};
use crate::list::{Id, List};
use crate::request::{FieldId, Request, Target};
use crate::space::{CoordinateId, FrameId, Kind, Space, VelocityId};

type Scalar = Approximate;

/// What a robot cannot be made of.
#[derive(Debug)]
pub(super) struct Contradiction(pub(super) String);

/// The robot whose fields have these values.
pub(super) fn robot(
    description: &Description,
    request: &Request,
    chain: &Chain,
    fields: &List<FieldId, Vec<f64>>,
) -> Result<Robot, Contradiction> {
    let reader = Reader {
        description,
        request,
        fields,
        snapped: (chain.report.snapped.iter())
            .map(|number| {
                let key = (number.item.as_str(), number.written.to_bits());
                (key, number.quarters)
            })
            .collect(),
    };
    let links: HashMap<&str, LinkId> =
        places(description.links.iter().map(|link| link.name.text.as_str()));
    let spaces = chain.spaces();
    let coordinates = places(spaces.names(Space::Coordinates));
    let velocities = places(spaces.names(Space::Velocities));
    let base = match &request.base {
        Some(base) => base.text.as_str(),
        None => &chain.report.base,
    };
    let kept = reader.kept(base, &links);
    let tip = chain.frames.first().filter(|_| chain.has_tip);
    let path = reader.path(tip.map(|tip| tip.name.as_str()));

    let mut bodies: List<BodyId, Body> = List::new();
    let mut seats: HashMap<&str, BodyId> = HashMap::new();
    if let Some(placement) = reader.base() {
        let nothing = [[Scalar::literal(0.0); 3]; 2];
        seats.insert(base, bodies.push(held(None, placement, nothing, 0.0)));
    }
    let mut moving = 0;
    let places = Places {
        coordinates: &coordinates,
        velocities: &velocities,
    };
    // The bodies that a joint moves, by its link.
    let mut moved: HashMap<&str, Vec<BodyId>> = HashMap::new();
    for &joint in &kept {
        let before = bodies.len();
        let place = (
            seats.get(joint.parent.text.as_str()).copied(),
            reader.origin(joint)?,
        );
        let motion = reader.motion(joint, &kept, &path);
        let own = matches!(motion, Motion::Own);
        let of_joint = joint.kind.coordinates(&joint.name.text);
        let is_listed = |(name, _): &(String, Kind)| coordinates.contains_key(name.as_str());
        if joint.kind.moves() && of_joint.iter().all(is_listed) != own {
            let name = &joint.name.text;
            return Err(Contradiction(format!("whether joint {name} moves")));
        }
        moving += if own { joint.kind.freedoms().len() } else { 0 };
        // What the last motion moves is the link; what others move has no mass.
        let link = match joint.kind.posture() {
            Some(posture) if own => reader.placed(joint, posture, place, &places, &mut bodies)?,
            _ => reader.in_series(joint, motion, place, &places, &mut bodies)?,
        };
        let child = joint.child.text.as_str();
        bodies[link].inertia = reader.inertia(&description[links[child]])?;
        seats.insert(child, link);
        moved.insert(child, bodies.ids().skip(before).collect());
    }
    if moving != spaces.velocities.len() {
        return Err(Contradiction("how many joints move".to_owned()));
    }
    let frames = chain.frames.iter().chain(&chain.external);
    let mut frames: List<FrameId, Option<BodyId>> = frames
        .map(|frame| seats.get(frame.name.as_str()).copied())
        .collect();
    let mut actuated = Vec::new();
    for joint in &kept {
        let mut named = request.actuated.iter();
        if named.any(|name| name.text == joint.name.text) {
            for (name, _) in joint.kind.velocities(&joint.name.text) {
                actuated.push(place(&velocities, &name)?);
            }
        }
    }
    let loops = reader.loops(chain, &seats, &mut bodies, &mut frames)?;
    let on = |name: &Name| seats.get(name.text.as_str()).copied();
    let external: Option<Vec<BodyId>> = request.external.iter().map(on).collect();
    let external = external.ok_or_else(|| Contradiction("what is acted on".to_owned()))?;
    Ok(Robot {
        bodies,
        velocities: moving,
        gravity: reader.gravity(),
        frames,
        loops,
        actuated,
        base_columns: chain.base_parameters.columns().collect(),
        identified: (chain.joints.iter())
            .filter(|_| chain.identifies_drives)
            .filter_map(|joint| moved.get(joint.link.as_ref()?.0.as_str()).cloned())
            .collect(),
        links: (chain.joints.iter())
            .filter_map(|joint| seats.get(joint.link.as_ref()?.0.as_str()).copied())
            .collect(),
        external: (external, request.external_in_frame_0),
    })
}

fn places<'n, I: Id>(names: impl Iterator<Item = &'n str>) -> HashMap<&'n str, I> {
    names.zip((0..).map(I::new)).collect()
}

/// Where coordinates and velocities stand, by name.
struct Places<'p> {
    coordinates: &'p HashMap<&'p str, CoordinateId>,
    velocities: &'p HashMap<&'p str, VelocityId>,
}

impl Places<'_> {
    /// A body that the coordinate of that name moves along a screw, times a factor and from an offset on.
    fn along(
        &self,
        name: &str,
        screw: [[Scalar; 3]; 2],
        (factor, offset): (Scalar, Scalar),
    ) -> Result<Body, Contradiction> {
        Ok(Body {
            parent: None,
            placement: Matrix::identity(),
            moved: Moved::By {
                screw,
                coordinate: place(self.coordinates, name)?,
                factor,
                offset,
            },
            freedoms: vec![Freedom {
                screw,
                velocity: place(self.velocities, name)?,
                factor,
                drive: [Scalar::literal(0.0); 3],
            }],
            inertia: Matrix::zero(),
        })
    }
}

fn place<I: Id>(places: &HashMap<&str, I>, name: &str) -> Result<I, Contradiction> {
    let place = places.get(name).copied();
    place.ok_or_else(|| Contradiction(format!("what is called {name}")))
}

/// A body that stays so far along a screw.
fn held(
    parent: Option<BodyId>,
    placement: Matrix<Scalar>,
    screw: [[Scalar; 3]; 2],
    at: f64,
) -> Body {
    Body {
        parent,
        placement,
        moved: Moved::Held(screw, at),
        freedoms: Vec::new(),
        inertia: Matrix::zero(),
    }
}

/// What moves a joint.
#[derive(Clone, Copy)]
enum Motion<'d> {
    /// Its own coordinates.
    Own,
    /// That of a joint of this name, times a factor, and an offset.
    Follows(&'d str, Scalar, Scalar),
    /// Nothing: it stays there.
    Held(f64),
}

struct Reader<'d> {
    description: &'d Description,
    request: &'d Request,
    /// The values of the struct's fields.
    fields: &'d List<FieldId, Vec<f64>>,
    /// What was taken for quarter turns or zero, by item and bits.
    snapped: HashMap<(&'d str, u64), i64>,
}

impl<'d> Reader<'d> {
    /// The joints that carry what is modelled, parents before children.
    fn kept(&self, base: &'d str, links: &HashMap<&'d str, LinkId>) -> Vec<&'d Joint> {
        let mut carried: List<LinkId, Vec<&Joint>> = List::filled(Vec::new(), links.len());
        for joint in &self.description.joints {
            carried[links[joint.parent.text.as_str()]].push(joint);
        }
        let drop = &self.request.drop;
        let mut kept = Vec::new();
        let mut waiting = vec![base];
        while let Some(link) = waiting.pop() {
            for joint in &carried[links[link]] {
                let child = &joint.child.text;
                if drop.iter().all(|dropped| dropped.text != *child) {
                    kept.push(*joint);
                    waiting.push(child);
                }
            }
        }
        kept
    }

    /// The joints between a link and the root.
    fn path(&self, link: Option<&'d str>) -> Vec<&'d str> {
        let carriers = self.description.joints.iter();
        let carriers: HashMap<&str, &Joint> = carriers
            .map(|joint| (joint.child.text.as_str(), joint))
            .collect();
        let mut path = Vec::new();
        let mut at = link;
        while let Some(joint) = at.and_then(|link| carriers.get(link)) {
            path.push(joint.name.text.as_str());
            at = Some(&joint.parent.text);
        }
        path
    }

    /// What moves one of the joints that are kept.
    fn motion(&self, joint: &'d Joint, kept: &[&'d Joint], path: &[&str]) -> Motion<'d> {
        if let Some(at) = self.locked(joint) {
            return Motion::Held(at);
        }
        if self.leader(joint).is_none() {
            let leads = |other: &&'d Joint| {
                let on_path = path.contains(&other.name.text.as_str());
                on_path && self.leads(joint, other)
            };
            let moves = !self.request.path_only || kept.iter().any(leads);
            return if moves {
                Motion::Own
            } else {
                Motion::Held(0.0)
            };
        }
        let (mut factor, mut offset) = (Scalar::exact(1.0), Scalar::exact(0.0));
        // Where it is held is a number of 53 bits, of which no step before is rounded.
        let [mut value, mut along] = [0.0, 1.0].map(Double::from);
        let mut at = joint;
        while let Some((mimic, leader)) = self.leader(at) {
            offset = offset + factor * Scalar::literal(mimic.offset.value);
            factor = factor * Scalar::literal(mimic.multiplier.value);
            value = value + along * Double::from(mimic.offset.value);
            along = along * Double::from(mimic.multiplier.value);
            at = leader;
        }
        let there = kept.iter().any(|other| other.name.text == at.name.text);
        match self.motion(at, kept, path) {
            Motion::Own if there && !along.is_zero() => {
                Motion::Follows(&at.name.text, factor, offset)
            }
            Motion::Held(held) if there => {
                Motion::Held((along * Double::from(held) + value).to_f64())
            }
            _ => Motion::Held(value.to_f64()),
        }
    }

    /// What a joint makes of another, and that, where it follows one.
    fn leader(&self, joint: &'d Joint) -> Option<(&'d Mimic, &'d Joint)> {
        let mimic = joint
            .mimic
            .as_ref()
            .filter(|_| self.locked(joint).is_none())?;
        let mut others = self.description.joints.iter();
        let leader = others.find(|other| other.name.text == mimic.leader.text)?;
        Some((mimic, leader))
    }

    /// Whether a joint is another, or moves it.
    fn leads(&self, joint: &Joint, other: &'d Joint) -> bool {
        let next = |joint: &&'d Joint| self.leader(joint).map(|(_, leader)| leader);
        let mut chain = std::iter::successors(Some(other), next);
        chain.any(|other| other.name.text == joint.name.text)
    }

    /// Where a joint is held, by its kind or by what was asked.
    fn locked(&self, joint: &Joint) -> Option<f64> {
        if !joint.kind.moves() {
            return Some(0.0);
        }
        let mut locks = self.request.lock.iter();
        let (_, at) = locks.find(|(lock, _)| lock.text == joint.name.text)?;
        Some(at.map_or(0.0, |at| at.value))
    }

    /// The loops that the chain has, with their frames as bodies that are held on the links.
    fn loops(
        &self,
        chain: &Chain,
        seats: &HashMap<&str, BodyId>,
        bodies: &mut List<BodyId, Body>,
        frames: &mut List<FrameId, Option<BodyId>>,
    ) -> Result<Vec<Closed>, Contradiction> {
        let mut loops = Vec::new();
        for closed in &chain.loops {
            let mut described = self.description.loops.iter();
            let described = described
                .find(|described| described.name.text == closed.name)
                .ok_or_else(|| Contradiction(format!("that loop {} is there", closed.name)))?;
            let name = &described.name.text;
            let ends = [
                (&described.from, &described.at),
                (&described.to, &described.to_at),
            ];
            let first = frames.next();
            let mut axes = Vec::new();
            for ((link, steps), axis) in ends.into_iter().zip(&described.axes) {
                let mut placement = self.placement(name, steps)?;
                if described.closure.definition().axes > 0 {
                    let axis = of_length_1(self.components(name, axis)?);
                    placement = placement.times(&across(axis));
                    axes.push(axis);
                }
                let nothing = [[Scalar::literal(0.0); 3]; 2];
                let link = seats.get(link.text.as_str()).copied();
                frames.push(Some(bodies.push(held(link, placement, nothing, 0.0))));
            }
            let size = match (described.closure.length(), &*axes) {
                (Some(length), _) => Scalar::literal(length.value),
                (None, [[ax, ay, az], [bx, by, bz]]) => *ax * *bx + *ay * *by + *az * *bz,
                (None, _) => Scalar::literal(0.0),
            };
            loops.push(Closed {
                frames: [first, first.plus(1)],
                rows: closed.rows.clone(),
                size,
            });
        }
        Ok(loops)
    }

    /// Adds the bodies of a joint whose motions come one after the other; the last of them.
    fn in_series(
        &self,
        joint: &Joint,
        motion: Motion<'_>,
        (mut parent, mut placement): (Option<BodyId>, Matrix<Scalar>),
        places: &Places<'_>,
        bodies: &mut List<BodyId, Body>,
    ) -> Result<BodyId, Contradiction> {
        if !joint.kind.moves() {
            let nothing = [[Scalar::literal(0.0); 3]; 2];
            return Ok(bodies.push(held(parent, placement, nothing, 0.0)));
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
    fn placed(
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
                bodies.push(held(Some(body), turn.inverse(), nothing, 0.0))
            }
            None => body,
        })
    }

    /// The value of the field that stands for a target.
    fn field<const N: usize>(&self, is: impl Fn(&Target) -> bool) -> Option<[Scalar; N]> {
        let mut parameters = self.request.parameters.iter();
        let field = parameters.position(|parameter| is(&parameter.target))?;
        Some(std::array::from_fn(|k| {
            Scalar::exact(self.fields[FieldId::new(field)][k])
        }))
    }

    /// Armature, damping and friction of the velocity that has this place among those of a joint.
    fn drive(&self, joint: &Joint, place: usize) -> [Scalar; 3] {
        let said = |part: Part| {
            let numbers = self.request.drive(&joint.name.text, &joint.drive, part);
            let number = numbers.get(if numbers.len() == 1 { 0 } else { place });
            number.map(|number| Scalar::literal(number.value))
        };
        let zero = Scalar::literal(0.0);
        let ratio = said(Part::Ratio).unwrap_or(Scalar::exact(1.0));
        let rotor = said(Part::Rotor).map_or(zero, |rotor| ratio * ratio * rotor);
        [Part::Armature, Part::Damping, Part::Friction].map(|part| {
            let field = self.field(|target| {
                let of = target.drives();
                of.is_some_and(|(name, of)| of == part && name.text == joint.name.text)
            });
            let described = said(part).unwrap_or(zero);
            match (field, part) {
                (Some([field]), _) => field,
                (None, Part::Armature) => described + rotor,
                (None, _) => described,
            }
        })
    }

    /// Where the base is, if a field says so.
    fn base(&self) -> Option<Matrix<Scalar>> {
        let position = self.field(|target| matches!(target, Target::BasePosition));
        let placement = self.field(|target| matches!(target, Target::BasePlacement));
        position.map(Matrix::translation).or(placement.map(placed))
    }

    fn gravity(&self) -> [Scalar; 3] {
        let field = self.field(|target| matches!(target, Target::Gravity));
        let described = self
            .request
            .gravity
            .map(|gravity| gravity.map(|entry| entry.value));
        let described = described.unwrap_or([0.0, 0.0, -9.81]);
        field.unwrap_or(described.map(Scalar::literal))
    }

    /// What was made of a number, if that is within its digits or its last bits.
    fn quarters(&self, item: &str, number: &Number) -> Result<Option<i64>, Contradiction> {
        let Some(&quarters) = self.snapped.get(&(item, number.value.to_bits())) else {
            // `pi/2` is what it says, and so is 0.
            let turns = (number.value / FRAC_PI_2).round();
            let distance = (number.value - turns * FRAC_PI_2).abs();
            let said = number.resolution == 0.0
                && turns.abs() <= 1e6
                && distance <= number.value.abs() * f64::EPSILON;
            #[expect(clippy::cast_possible_truncation, reason = "a whole number of turns")]
            return Ok(said.then_some(turns as i64));
        };
        #[expect(clippy::cast_precision_loss, reason = "few turns are many")]
        let distance = (number.value - quarters as f64 * FRAC_PI_2).abs();
        let digits = 0.5 * number.resolution + number.value.abs() * f64::EPSILON;
        let excused = distance <= (1.0 + 1e-6) * digits.max(4.0 * f64::EPSILON);
        if excused && !self.request.exact {
            Ok(Some(quarters))
        } else {
            let written = number.value;
            Err(Contradiction(format!(
                "that {written} of {item} is rounded"
            )))
        }
    }

    /// An entry of an offset or an axis.
    fn component(&self, item: &str, number: &Number) -> Result<Scalar, Contradiction> {
        let zero =
            number.value != 0.0 && self.snapped.contains_key(&(item, number.value.to_bits()));
        if zero && self.quarters(item, number)? == Some(0) {
            return Ok(Scalar::literal(0.0));
        }
        Ok(Scalar::literal(number.value))
    }

    fn components(&self, item: &str, numbers: &[Number; 3]) -> Result<[Scalar; 3], Contradiction> {
        let [x, y, z] = numbers;
        let component = |number| self.component(item, number);
        Ok([component(x)?, component(y)?, component(z)?])
    }

    fn placement(&self, item: &str, steps: &[Step]) -> Result<Matrix<Scalar>, Contradiction> {
        let mut placement = Matrix::identity();
        for step in steps {
            let step = match step {
                Step::Translate(offset) => Matrix::translation(self.components(item, offset)?),
                Step::Rotate(axis, angle) => {
                    let axis = match axis {
                        Axis::X => 0,
                        Axis::Y => 1,
                        Axis::Z => 2,
                    };
                    let turn = match self.quarters(item, angle)? {
                        Some(quarters) => {
                            let [sine, cosine] = [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0]]
                                [usize::try_from(quarters.rem_euclid(4)).unwrap_or(0)];
                            (Scalar::literal(sine), Scalar::literal(cosine))
                        }
                        None => Scalar::literal(angle.value).sin_cos(),
                    };
                    Matrix::rotation(axis, turn)
                }
            };
            placement = placement.times(&step);
        }
        Ok(placement)
    }

    fn origin(&self, joint: &Joint) -> Result<Matrix<Scalar>, Contradiction> {
        let name = &joint.name.text;
        let mut placement = self.placement(name, &joint.origin)?;
        let field = self.field(|target| matches!(target, Target::OriginOf(of) if of.text == *name));
        if let Some(offset) = field {
            placement.set_column(offset);
        }
        let field =
            self.field(|target| matches!(target, Target::PlacementOf(of) if of.text == *name));
        Ok(field.map_or(placement, placed))
    }

    /// A direction, of length 1.
    fn direction(&self, joint: &Joint, axis: &[Number; 3]) -> Result<[Scalar; 3], Contradiction> {
        let axis = self.components(&joint.name.text, axis)?;
        Ok(of_length_1(axis))
    }

    fn screw(
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
                let pitch = Scalar::literal(joint.kind.pitch().unwrap_or_default().value);
                [axis, axis.map(|entry| entry * pitch)]
            }
        })
    }

    fn inertia(&self, link: &Link) -> Result<Matrix<Scalar>, Contradiction> {
        let is = |name: &Name| name.text == link.name.text;
        let mass = self.field(|target| matches!(target, Target::MassOf(of) if is(of)));
        let center = self.field(|target| matches!(target, Target::CenterOfMassOf(of) if is(of)));
        let nothing = Inertial {
            origin: Vec::new(),
            mass: Number::default(),
            inertia: [Number::default(); 6],
            place: link.name.place,
        };
        let inertial = link.inertial.as_ref().unwrap_or(&nothing);
        let [mass] = mass.unwrap_or([Scalar::literal(inertial.mass.value)]);
        let tensor = self.field(|target| matches!(target, Target::InertiaOf(of) if is(of)));
        let described = inertial.inertia.map(|entry| Scalar::literal(entry.value));
        let [xx, xy, xz, yy, yz, zz] = tensor.unwrap_or(described);
        // ½ Tr(I) − I, and the mass.
        let half = (xx + yy + zz) * Scalar::exact(0.5);
        let none = Scalar::exact(0.0);
        let central = Matrix([
            [half - xx, -xy, -xz, none],
            [-xy, half - yy, -yz, none],
            [-xz, -yz, half - zz, none],
            [none, none, none, mass],
        ]);
        let mut origin = self.placement(&link.name.text, &inertial.origin)?;
        if let Some(center) = center {
            origin.set_column(center);
        }
        let payload = self.field(|target| matches!(target, Target::PayloadOn(of) if is(of)));
        let inertia = origin.times(&central).times(&origin.transposed());
        Ok(match payload {
            Some(payload) => inertia.plus(&loaded(payload)),
            None => inertia,
        })
    }
}

/// A placement by its origin and its roll, pitch and yaw.
fn placed([x, y, z, roll, pitch, yaw]: [Scalar; 6]) -> Matrix<Scalar> {
    let turns = [(2, yaw), (1, pitch), (0, roll)].into_iter();
    let turns = turns.map(|(axis, angle)| Matrix::rotation(axis, angle.sin_cos()));
    turns.fold(Matrix::translation([x, y, z]), |placement, turn| {
        placement.times(&turn)
    })
}

/// J of a payload in the frame of its link: ∫rrᵗdm of what is about its centre, and m c cᵗ.
fn loaded([mass, x, y, z, xx, xy, xz, yy, yz, zz]: [Scalar; 10]) -> Matrix<Scalar> {
    let half = (xx + yy + zz) * Scalar::exact(0.5);
    let at = |a, b| mass * a * b;
    let (one, two, three) = (at(x, y) - xy, at(x, z) - xz, at(y, z) - yz);
    Matrix([
        [at(x, x) + half - xx, one, two, mass * x],
        [one, at(y, y) + half - yy, three, mass * y],
        [two, three, at(z, z) + half - zz, mass * z],
        [mass * x, mass * y, mass * z, mass],
    ])
}

/// A direction with length 1.
fn of_length_1(direction: [Scalar; 3]) -> [Scalar; 3] {
    let sizes = direction.iter().map(|entry| entry.size());
    let largest = Scalar::exact(sizes.fold(0.0, f64::max));
    let scaled = direction.map(|entry| entry / largest);
    let [x, y, z] = scaled;
    let length = (x * x + y * y + z * z).sqrt();
    scaled.map(|entry| entry / length)
}

/// A turn that takes z to the normal of a plane. Along an axis of the frame, x and y go to those that
/// follow it; else x goes to the product of the normal with the axis that it is farthest from.
fn across(normal: [Scalar; 3]) -> Matrix<Scalar> {
    let sizes = normal.map(Scalar::size);
    let alone = (0..3).find(|&k| sizes[(k + 1) % 3] == 0.0 && sizes[(k + 2) % 3] == 0.0);
    let mut axes = [[Scalar::literal(0.0); 3]; 3];
    if let Some(k) = alone {
        axes[0][(k + 1) % 3] = Scalar::literal(1.0);
    } else {
        let least = (0..3).fold(
            0,
            |least, k| if sizes[k] < sizes[least] { k } else { least },
        );
        let mut farthest = [Scalar::literal(0.0); 3];
        farthest[least] = Scalar::literal(1.0);
        axes[0] = of_length_1(cross(farthest, normal));
    }
    axes[1] = cross(normal, axes[0]);
    axes[2] = normal;
    let mut turn = Matrix::identity();
    for (column, axis) in axes.into_iter().enumerate() {
        for (row, entry) in axis.into_iter().enumerate() {
            turn.0[row][column] = entry;
        }
    }
    turn
}

fn cross([ax, ay, az]: [Scalar; 3], [bx, by, bz]: [Scalar; 3]) -> [Scalar; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}
