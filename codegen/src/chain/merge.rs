//! Fixed and locked joints vanish: what they connect becomes one body.
//!
//! In: the description and its tree. Out: a [`Chain`] whose bodies move against each other, with
//! the mass of all that is fixed to them. Struct fields enter here as inputs; from here on they are
//! scalars like all others. It never drops a mass.

mod closure;
mod drive;

use std::collections::HashMap;

use super::tree::{Branch, Follow, Tree};
use super::turn::roll_pitch_yaw;
use super::{BodyId, Chain, Frame, Mimicked, Position, Report, Snapped, angle, limits};
use crate::description::{Axis, Description, Joint, JointId, Link, LinkId, Name, Number, Step};
use crate::expression::{Double, Graph, Input, Term};
use crate::joint::{Along, Drive, Freedom, JointKind, Motion, Movement, Posture, entry};
use crate::list::{Id, List};
use crate::matrix::{Inertia, Pose, Rotation, Symmetric, Vector};
use crate::request::{FieldId, Request, Target};
use crate::space::{ACTION, CoordinateId, Entry, Spaces, VelocityId};

/// Standard gravity as robot software has it, in a base whose z points up [m/s²].
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Where a link ended up: in which body, and where in it.
#[derive(Clone, Copy)]
struct Seat<'g> {
    body: Option<BodyId>,
    pose: Pose<Term<'g>>,
}

/// A body beyond one freedom of a joint; only that beyond the last is a link.
struct Body<'g> {
    joint: JointId,
    velocity: String,
    parent: Option<BodyId>,
    motion: Motion,
    placement: Pose<Term<'g>>,
    axis: Vector<Term<'g>>,
    /// The link that it is, and M from its frame to the link's.
    link: Option<(LinkId, Pose<Term<'g>>)>,
    inertia: Inertia<Term<'g>>,
    moved: Moved<'g>,
    drive: Drive<Term<'g>>,
}

/// What moves a body.
#[derive(Clone, Copy)]
enum Moved<'g> {
    /// A coordinate of its own.
    Own,
    /// That of another joint, times a factor.
    Follows { leader: JointId, factor: Term<'g> },
    /// Coordinates that move it with all that come after it of its joint.
    Posture(Posture),
    /// The body before it.
    Taken,
}

/// Merges what does not move.
pub fn merge(description: &Description, request: &Request, tree: &Tree) -> Chain {
    let graph = Graph::new();
    let mut reader = Reader {
        graph: &graph,
        request,
        nominal: List::filled(Vec::new(), request.parameters.len()),
        report: Report::default(),
    };
    let name = |link: LinkId| description[link].name.text.clone();
    let (seats, bodies) = seat(description, tree, &mut reader);
    let frame = |link: LinkId| {
        let seat = seats[link]?;
        Some(Frame {
            name: name(link),
            body: seat.body,
            placement: seat.pose.map(Term::expr),
        })
    };
    let frames = tree.tip.iter().chain(&tree.frames);
    let frames = frames.filter_map(|&link| frame(link)).collect();
    let external = tree.external.iter().filter_map(|&link| frame(link));
    let external: Vec<Frame> = external.collect();
    let loops = closure::closed(description, &seats, &mut reader);
    let gravity = reader.gravity().map(Term::expr);
    reader.report.base = name(tree.base);
    let modelled = seats.ids().filter(|&link| seats[link].is_some());
    reader.report.links = modelled.map(name).collect();
    reader.report.dropped = tree.dropped.iter().map(|&link| name(link)).collect();
    let (joints, mut spaces) = listed(description, bodies, &graph);
    spaces.actions = actions(&external);
    let Reader {
        nominal, report, ..
    } = reader;
    Chain {
        nominal,
        parameters: request.parameters.clone().into(),
        joints,
        spaces,
        loops,
        actuated: List::new(),
        frames,
        external,
        external_in_frame_0: request.external_in_frame_0,
        has_tip: tree.tip.is_some(),
        gravity,
        report,
        source: description.source.clone(),
        identifies_drives: false,
        base_parameters: super::base_parameters::BaseParameters::default(),
        graph,
    }
}

/// The entries of the actions on some links.
fn actions(external: &[Frame]) -> Vec<Entry> {
    let entries = external.iter().flat_map(|link| {
        ACTION.map(|(name, kind)| Entry {
            name: entry(&link.name, name),
            kind,
            range: None,
        })
    });
    entries.collect()
}

/// The bodies with their places in the lists of coordinates and velocities, and those lists.
fn listed(
    description: &Description,
    bodies: List<BodyId, Body<'_>>,
    graph: &Graph,
) -> (List<BodyId, super::Joint>, Spaces) {
    let mut spaces = Spaces::default();
    // Of each joint with one coordinate, its places among coordinates and velocities.
    let mut leaders = HashMap::new();
    let mut places = Vec::with_capacity(bodies.len());
    for body in &bodies {
        let described = &description[body.joint];
        let (coordinate, velocity) = (spaces.coordinates.next(), spaces.velocities.next());
        places.push((coordinate, velocity));
        // Which of several coordinates limits are of, no format says.
        let one = described.limits.filter(|_| !described.kind.has_several());
        let entry = |name: String, kind, range| Entry { name, kind, range };
        match body.moved {
            Moved::Follows { .. } => continue,
            Moved::Own => {
                leaders.insert(body.joint, (coordinate, velocity));
                let (name, kind) = (body.velocity.clone(), body.motion.kind());
                let range = one.and_then(limits::reach);
                spaces.coordinates.push(entry(name, kind, range));
            }
            Moved::Posture(_) => {
                let names = described.kind.coordinates(&described.name.text).into_iter();
                let entries = names.map(|(name, kind)| entry(name, kind, None));
                spaces.coordinates.extend(entries);
            }
            Moved::Taken => {}
        }
        let (name, kind) = (body.velocity.clone(), body.motion.kind());
        let range = one.and_then(limits::rates);
        spaces.velocities.push(entry(name, kind, range));
    }
    let one = graph.constant(1.0).expr();
    let joint = |(body, (coordinate, velocity)): (Body<'_>, (CoordinateId, VelocityId))| {
        let described = &description[body.joint];
        let (position, velocity) = match body.moved {
            Moved::Own => {
                let factor = one;
                (Position::Along { coordinate, factor }, velocity)
            }
            Moved::Follows { leader, factor } => {
                let (coordinate, velocity) = leaders[&leader];
                let factor = factor.expr();
                (Position::Along { coordinate, factor }, velocity)
            }
            Moved::Posture(posture) => (Position::Posture(posture, coordinate), velocity),
            Moved::Taken => (Position::Taken, velocity),
        };
        super::Joint {
            name: body.velocity,
            of: described.name.text.clone(),
            place: described.name.place,
            parent: body.parent,
            motion: body.motion,
            placement: body.placement.map(Term::expr),
            axis: body.axis.map(Term::expr),
            link: body.link.map(|(link, pose)| {
                let name = description[link].name.text.clone();
                (name, pose.map(Term::expr))
            }),
            inertia: body.inertia.map(Term::expr),
            position,
            velocity,
            drive: body.drive.map(Term::expr),
        }
    };
    let joints = bodies.into_iter().zip(places).map(joint).collect();
    (joints, spaces)
}

/// Gives every link its seat, and every joint that moves its bodies.
fn seat<'g>(
    description: &Description,
    tree: &Tree,
    reader: &mut Reader<'g, '_>,
) -> (List<LinkId, Option<Seat<'g>>>, List<BodyId, Body<'g>>) {
    let graph = reader.graph;
    let mut bodies = List::new();
    let mut seats = List::filled(None, description.links.len());
    seats[tree.base] = Some(Seat {
        body: None,
        pose: reader.base(),
    });
    for branch in &tree.branches {
        let joint = &description[branch.joint];
        let parent = seats[branch.parent].expect("parents come before children");
        let pose = parent.pose * reader.origin(description, branch);
        let axes = reader.axes(joint);
        let seat = if let Some(held) = branch.held {
            Seat {
                body: parent.body,
                pose: pose * held_at(graph, joint.kind, axes, graph.constant(held.value)),
            }
        } else {
            let (last, link) = moved(
                description,
                branch,
                (parent.body, pose),
                axes,
                &mut bodies,
                reader,
            );
            bodies[last].link = Some((branch.child, link));
            Seat {
                body: Some(last),
                pose: link,
            }
        };
        reader.note(description, branch);
        if let Some(body) = seat.body
            && let Some(inertia) = reader.inertia(&description[branch.child])
        {
            bodies[body].inertia = bodies[body].inertia + inertia.change_frame(seat.pose);
        }
        seats[branch.child] = Some(seat);
    }
    (seats, bodies)
}

/// Adds the bodies that a joint moves; the last of them, and where the link that it carries is in that.
fn moved<'g>(
    description: &Description,
    branch: &Branch,
    (mut parent, mut placement): (Option<BodyId>, Pose<Term<'g>>),
    axes: [Vector<Term<'g>>; 2],
    bodies: &mut List<BodyId, Body<'g>>,
    reader: &mut Reader<'g, '_>,
) -> (BodyId, Pose<Term<'g>>) {
    let (graph, joint) = (reader.graph, &description[branch.joint]);
    let (kind, name) = (joint.kind, &joint.name.text);
    let mut link = Pose::identity(graph);
    let mut moved = Moved::Own;
    if let Some(follow) = branch.follows {
        reader.note_follower(description, branch.joint, follow);
        let offset = number(graph, follow.offset);
        placement = placement * held_at(graph, kind, axes, offset);
        moved = Moved::Follows {
            leader: follow.leader,
            factor: number(graph, follow.multiplier),
        };
    } else {
        reader.report.joints.push(name.clone());
    }
    if let Some(posture) = kind.posture() {
        moved = Moved::Posture(posture);
        if posture == Posture::Planar {
            let turn = Pose::rotation(Rotation::with_z(axes[0]));
            placement = placement * turn;
            link = turn.inverse();
        }
    }
    for (place, (velocity, freedom)) in kind.velocities(name).enumerate() {
        let axis = direction(graph, freedom, axes);
        let body = bodies.push(Body {
            joint: branch.joint,
            velocity,
            parent,
            motion: reader.motion(kind, freedom),
            placement,
            axis,
            link: None,
            inertia: Inertia::zero(graph),
            moved,
            drive: reader.drive(joint, place),
        });
        (parent, placement) = (Some(body), Pose::identity(graph));
        if kind.posture().is_some() {
            moved = Moved::Taken;
        }
    }
    (parent.expect("joints that move have velocities"), link)
}

/// About or along which direction a freedom is, in the frame of the moved body.
fn direction<'g>(
    graph: &'g Graph,
    freedom: Freedom,
    [axis, second]: [Vector<Term<'g>>; 2],
) -> Vector<Term<'g>> {
    match freedom.along {
        Along::Axis => axis,
        Along::Second => second,
        Along::Frame(k) => {
            let mut entries = [0.0; 3];
            entries[k] = 1.0;
            Vector::constant(graph, entries)
        }
    }
}

/// Turns what was written into scalars, and keeps account of it.
struct Reader<'g, 'r> {
    graph: &'g Graph,
    request: &'r Request,
    /// What is described where struct fields stand.
    nominal: List<FieldId, Vec<f64>>,
    report: Report,
}

impl<'g> Reader<'g, '_> {
    fn number(&self, number: &Number) -> Term<'g> {
        self.graph.constant(number.value)
    }

    /// The inputs of the struct field that stands for a target, or what is described where none
    /// does.
    fn free<const N: usize>(
        &mut self,
        is: impl Fn(&Target) -> bool,
        described: [Term<'g>; N],
    ) -> [Term<'g>; N] {
        let mut parameters = self.request.parameters.iter();
        let Some(field) = parameters.position(|parameter| is(&parameter.target)) else {
            return described;
        };
        let field = FieldId::new(field);
        self.nominal[field] = described
            .map(|term| term.value().map_or(0.0, Double::to_f64))
            .to_vec();
        let index = |k: usize| u16::try_from(k).expect("few struct fields");
        std::array::from_fn(|entry| {
            self.graph
                .input(Input::Parameter(index(field.index()), index(entry)))
        })
    }

    fn gravity(&mut self) -> Vector<Term<'g>> {
        let described = match &self.request.gravity {
            Some(gravity) => gravity.map(|entry| self.number(&entry)),
            None => Vector::constant(self.graph, GRAVITY).0,
        };
        Vector(self.free(|target| matches!(target, Target::Gravity), described))
    }

    /// Where the base is in frame 0: there, but for a struct field.
    fn base(&mut self) -> Pose<Term<'g>> {
        let there = Vector::zero(self.graph).0;
        let position = self.free(|target| matches!(target, Target::BasePosition), there);
        let there = Pose::translation(Vector(position));
        self.placed(|target| matches!(target, Target::BasePlacement), there)
    }

    /// A placement taken from the struct field that stands for it, where one does.
    fn placed(
        &mut self,
        is: impl Fn(&Target) -> bool,
        described: Pose<Term<'g>>,
    ) -> Pose<Term<'g>> {
        let mut fields = self.request.parameters.iter();
        if !fields.any(|field| is(&field.target)) {
            return described;
        }
        let [x, y, z] = described.translation.0;
        let angles = roll_pitch_yaw(&described.rotation);
        let [roll, pitch, yaw] = angles.map(|angle| self.graph.constant(angle));
        let [x, y, z, roll, pitch, yaw] = self.free(is, [x, y, z, roll, pitch, yaw]);
        let [roll, pitch, yaw] = [roll, pitch, yaw].map(Term::sin_cos);
        Pose {
            rotation: Rotation::about_z(yaw) * Rotation::about_y(pitch) * Rotation::about_x(roll),
            translation: Vector([x, y, z]),
        }
    }

    fn motion(&self, kind: JointKind, freedom: Freedom) -> Motion {
        Motion::of(freedom.movement, || {
            let pitch = kind.pitch().unwrap_or_default();
            self.number(&pitch).expr()
        })
    }

    /// The placement of a joint, it or its translation taken from a struct field where one stands for it.
    fn origin(&mut self, description: &Description, branch: &Branch) -> Pose<Term<'g>> {
        let joint = &description[branch.joint];
        let mut placement = self.placement(&joint.name.text, &joint.origin);
        let is = |target: &Target| matches!(target, Target::OriginOf(name) if name.text == joint.name.text);
        placement.translation = Vector(self.free(is, placement.translation.0));
        let is = |target: &Target| matches!(target, Target::PlacementOf(name) if name.text == joint.name.text);
        self.placed(is, placement)
    }

    fn placement(&mut self, item: &str, steps: &[Step]) -> Pose<Term<'g>> {
        steps
            .iter()
            .fold(Pose::identity(self.graph), |pose, step| match step {
                Step::Translate(offset) => {
                    let offset = offset.map(|entry| self.component(item, &entry));
                    pose * Pose::translation(Vector(offset))
                }
                Step::Rotate(axis, angle) => {
                    let angle = self.sin_cos(item, angle);
                    pose * Pose::rotation(match axis {
                        Axis::X => Rotation::about_x(angle),
                        Axis::Y => Rotation::about_y(angle),
                        Axis::Z => Rotation::about_z(angle),
                    })
                }
            })
    }

    /// An entry of an offset \[m\] or of a direction, 0 where rounding left no more of it.
    fn component(&mut self, item: &str, entry: &Number) -> Term<'g> {
        if self.request.exact || !angle::is_residue(entry) {
            return self.number(entry);
        }
        self.snap(item, entry, 0);
        self.graph.constant(0.0)
    }

    /// The directions of a joint's axes, of length 1 to all digits; zero of those it has not.
    fn axes(&mut self, joint: &Joint) -> [Vector<Term<'g>>; 2] {
        let count = joint.kind.definition().axes();
        let mut axes = [Vector::zero(self.graph); 2];
        let described = [joint.axis, joint.second_axis].into_iter();
        for (axis, described) in axes.iter_mut().zip(described).take(count) {
            let entries = described.map(|entry| self.component(&joint.name.text, &entry));
            let direction = Vector(entries).normalized();
            *axis = direction.expect("an axis without a direction is refused");
        }
        axes
    }

    fn snap(&mut self, item: &str, number: &Number, quarters: i64) {
        self.report.snapped.push(Snapped {
            item: item.to_owned(),
            written: number.value,
            quarters,
            place: number.place,
        });
    }

    /// Sine and cosine of an angle, exact where it is a right angle.
    fn sin_cos(&mut self, item: &str, angle: &Number) -> (Term<'g>, Term<'g>) {
        // A number without digits, such as `pi/2`, is what it says.
        let written = angle.resolution > 0.0;
        let quarters = angle::quarters(angle).filter(|_| !(written && self.request.exact));
        let Some(quarters) = quarters else {
            return self.number(angle).sin_cos();
        };
        if written && angle.value != 0.0 {
            self.snap(item, angle, quarters);
        }
        let (sine, cosine) = match quarters.rem_euclid(4) {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
        (self.graph.constant(sine), self.graph.constant(cosine))
    }

    /// J of a link in its own frame, where anything is said of it.
    fn inertia(&mut self, link: &Link) -> Option<Inertia<Term<'g>>> {
        let is = |name: &Name| name.text == link.name.text;
        let of_mass = |target: &Target| matches!(target, Target::MassOf(name) if is(name));
        let of_center =
            |target: &Target| matches!(target, Target::CenterOfMassOf(name) if is(name));
        let of_inertia = |target: &Target| matches!(target, Target::InertiaOf(name) if is(name));
        let nothing = self.graph.constant(0.0);
        let (mass, tensor, mut origin) = match &link.inertial {
            Some(inertial) => (
                self.number(&inertial.mass),
                inertial.inertia.map(|entry| self.number(&entry)),
                self.placement(&link.name.text, &inertial.origin),
            ),
            // A struct field can give a mass to a link that is described without.
            None => (nothing, [nothing; 6], Pose::identity(self.graph)),
        };
        let [mass] = self.free(of_mass, [mass]);
        origin.translation = Vector(self.free(of_center, origin.translation.0));
        let tensor = self.free(of_inertia, tensor);
        let free = (tensor.iter().chain([&mass])).any(|entry| entry.value().is_none());
        let own = (free || link.inertial.is_some())
            .then(|| Inertia::central(mass, Symmetric::from_tensor(tensor)).change_frame(origin));
        let payload = self.payload(link);
        match (own, payload) {
            (Some(own), Some(payload)) => Some(own + payload),
            (own, payload) => own.or(payload),
        }
    }

    /// J of what a struct field puts on a link, in the link's frame.
    fn payload(&mut self, link: &Link) -> Option<Inertia<Term<'g>>> {
        let is = |target: &Target| matches!(target, Target::PayloadOn(name) if name.text == link.name.text);
        let free = self.request.loads(&link.name);
        free.then(|| {
            let nothing = [self.graph.constant(0.0); 10];
            let [mass, x, y, z, tensor @ ..] = self.free(is, nothing);
            let center = Pose::translation(Vector([x, y, z]));
            Inertia::central(mass, Symmetric::from_tensor(tensor)).change_frame(center)
        })
    }

    fn note_follower(&mut self, description: &Description, joint: JointId, follow: Follow) {
        let name = |joint: JointId| description[joint].name.text.clone();
        self.report.mimicked.push(Mimicked {
            joint: name(joint),
            leader: name(follow.leader),
            multiplier: follow.multiplier.to_f64(),
            offset: follow.offset.to_f64(),
        });
    }

    fn note(&mut self, description: &Description, branch: &Branch) {
        let Some(held) = branch.held else { return };
        let joint = &description[branch.joint];
        let [parent, child]: [String; 2] =
            [branch.parent, branch.child].map(|link| description[link].name.text.clone());
        if joint.kind.moves() {
            self.report
                .locked
                .push((joint.name.text.clone(), held.value));
        }
        self.report.merged.push((child, parent));
    }
}

/// A number of 106 bits.
fn number(graph: &Graph, value: Double) -> Term<'_> {
    let first = value.to_f64();
    let rest = value - Double::from(first);
    graph.constant(first) + graph.constant(rest.to_f64())
}

/// The displacement of a joint that is held at a coordinate, or of which all coordinates are zero.
fn held_at<'g>(
    graph: &'g Graph,
    kind: JointKind,
    axes: [Vector<Term<'g>>; 2],
    q: Term<'g>,
) -> Pose<Term<'g>> {
    let turn = |axis: Vector<Term<'g>>| {
        // R = 1 + u̲ sin φ + u̲² (1 − cos φ)
        let (sine, cosine) = q.sin_cos();
        let versine = graph.constant(1.0) - cosine;
        let [x, y, z] = axis.0;
        let outer = |a: Term<'g>, b: Term<'g>| a * b * versine;
        Pose::rotation(Rotation([
            [
                cosine + outer(x, x),
                outer(x, y) - z * sine,
                outer(x, z) + y * sine,
            ],
            [
                outer(x, y) + z * sine,
                cosine + outer(y, y),
                outer(y, z) - x * sine,
            ],
            [
                outer(x, z) - y * sine,
                outer(y, z) + x * sine,
                cosine + outer(z, z),
            ],
        ]))
    };
    let displacement = |freedom: &Freedom| {
        let axis = direction(graph, *freedom, axes);
        match freedom.movement {
            Movement::Turn => turn(axis),
            Movement::Slide => Pose::translation(axis * q),
            Movement::Helix => {
                let pitch = kind.pitch().unwrap_or_default();
                Pose {
                    translation: axis * (q * graph.constant(pitch.value)),
                    ..turn(axis)
                }
            }
        }
    };
    let freedoms = kind.freedoms().iter();
    freedoms
        .map(displacement)
        .fold(Pose::identity(graph), |pose, next| pose * next)
}
