//! A description as dense matrices of 256 bits, joint by joint.
//!
//! In: a description and a request. Out: a placement, a motion and an inertia J for every joint that
//! hangs on the base, fixed and locked ones too: nothing is merged, turned or regrouped. It shares with
//! the generator the reading of the text and nothing after it. Where that is to be contradicted too,
//! [`trees::dense`](crate::trees::dense) makes the same matrices of numbers as they were drawn.

use std::collections::{BTreeMap, BTreeSet};

use homogen_codegen::closure::Closure;
use homogen_codegen::description::{self, Axis, Description, Inertial, Joint, Name, Number, Step};
use homogen_codegen::joint::JointKind;
use homogen_codegen::request::Request;

use super::drive::Drive;
use super::matrix::Matrix;
use super::motion::{self, Motion, Posture, across};
use crate::big::Big;

/// A robot in the matrices of the paper.
#[derive(Clone, Debug)]
pub struct Robot {
    /// The joints, parents before children.
    pub bodies: Vec<Body>,
    /// For the tip and every further frame asked for, the body whose frame it is; none for the base.
    pub frames: Vec<Option<usize>>,
    /// H_g (§ 4.5).
    pub gravity: Matrix,
    /// What holds bodies together that hang on the base anyhow.
    pub loops: Vec<Loop>,
    /// What drives joints beside bodies, of each of their velocities.
    pub drives: Vec<Drive>,
    /// Whether the regressor has columns of drives behind those of links.
    pub identifies_drives: bool,
    /// The bodies that the surroundings act on, and whether their actions are in frame 0.
    pub external: (Vec<usize>, bool),
}

/// Two frames that are held together.
#[derive(Clone, Debug)]
pub struct Loop {
    /// By what.
    pub closure: Closure,
    /// A and B, each with the body that it is fixed to, none for the base, and its place there; z is the
    /// axis of what holds them, where that has one.
    pub frames: [(Option<usize>, Matrix); 2],
    /// Of two axes the cosine of their angle as described.
    pub cosine: Big,
}

/// A joint and the link that it carries.
#[derive(Clone, Debug)]
pub struct Body {
    /// The body it hangs on; none for the base.
    pub parent: Option<usize>,
    /// M_parent,i where the joint is neutral.
    pub placement: Matrix,
    /// What moves it.
    pub motion: Motion,
    /// J in frame (i).
    pub inertia: Matrix,
    /// Whether it is a link that its joint moves, and not what moves by a part of a joint's freedoms.
    pub link: bool,
}

impl Robot {
    /// The part of a description that a request wants.
    ///
    /// # Panics
    /// Where the request names something that is not there, or has struct fields.
    #[must_use]
    pub fn of(description: &Description, request: &Request) -> Self {
        assert!(request.parameters.is_empty(), "struct fields are not read");
        let reader = Reader {
            description,
            request,
        };
        let base = reader.base();
        let tip = reader.tip(base);
        let mut robot = Self {
            bodies: Vec::new(),
            frames: Vec::new(),
            gravity: reader.gravity(),
            loops: Vec::new(),
            drives: Vec::new(),
            identifies_drives: request.models_friction() || request.models_armature(),
            external: (Vec::new(), request.external_in_frame_0),
        };
        let links = reader.hang(base, tip, &mut robot);
        let seat = |link: &str| {
            let body = links.iter().position(|carried| *carried == link);
            assert!(
                body.is_some() || link == base,
                "{link} does not hang on {base}"
            );
            body
        };
        let further = request.frames.iter().map(|frame| frame.text.as_str());
        robot.frames = tip.into_iter().chain(further).map(seat).collect();
        let loops = description.loops.iter();
        robot.loops = loops
            .map(|described| reader.held(described, seat))
            .collect();
        let external = request.external.iter();
        robot.external.0 = external.filter_map(|link| seat(&link.text)).collect();
        robot
    }

    /// How many velocities there are.
    #[must_use]
    pub fn velocities(&self) -> usize {
        let moving = self.bodies.iter().flat_map(|body| body.motion.screws());
        moving.map(|(velocity, _)| velocity + 1).max().unwrap_or(0)
    }

    /// Where quaternions begin among the coordinates.
    pub fn quaternions(&self) -> impl Iterator<Item = usize> {
        self.bodies
            .iter()
            .filter_map(|body| body.motion.quaternion())
    }

    /// The bodies on the way from one up to the base, itself first.
    pub fn upwards(&self, body: Option<usize>) -> impl Iterator<Item = usize> {
        std::iter::successors(body, |&body| self.bodies[body].parent)
    }
}

struct Reader<'d> {
    description: &'d Description,
    request: &'d Request,
}

impl<'d> Reader<'d> {
    fn base(&self) -> &'d str {
        if let Some(base) = &self.request.base {
            return &base.text;
        }
        let carried = |link: &Name| {
            let mut joints = self.description.joints.iter();
            joints.any(|joint| joint.child.text == link.text)
        };
        let mut links = self.description.links.iter().map(|link| &link.name);
        let root = links.find(|link| !carried(link));
        &root.expect("a tree has a root").text
    }

    fn below(&self, link: &str) -> impl Iterator<Item = &'d Joint> {
        let dropped = |joint: &Joint| {
            let mut drop = self.request.drop.iter();
            drop.any(|link| link.text == joint.child.text)
        };
        let joints = self.description.joints.iter();
        joints.filter(move |joint| joint.parent.text == link && !dropped(joint))
    }

    /// The link that is named, or the only one at an end.
    fn tip(&self, base: &'d str) -> Option<&'d str> {
        if let Some(tip) = &self.request.tip {
            return Some(&tip.text);
        }
        let mut waiting = vec![base];
        let mut ends = Vec::new();
        while let Some(link) = waiting.pop() {
            let before = waiting.len();
            waiting.extend(self.below(link).map(|joint| joint.child.text.as_str()));
            if waiting.len() == before {
                ends.push(link);
            }
        }
        match ends[..] {
            [end] => Some(end),
            _ => None,
        }
    }

    /// The links from one up to the root.
    fn upwards(&self, link: &'d str) -> BTreeSet<&'d str> {
        let above = |link: &&str| {
            let mut joints = self.description.joints.iter();
            let carrier = joints.find(|joint| joint.child.text == **link);
            carrier.map(|joint| joint.parent.text.as_str())
        };
        std::iter::successors(Some(link), above).collect()
    }

    /// Adds what hangs on the base: branch after branch, siblings as described.
    fn hang(&self, base: &'d str, tip: Option<&'d str>, robot: &mut Robot) -> Vec<&'d str> {
        let kept = self.kept(base);
        let moves = self.moves(&kept, tip);
        // The first coordinate and velocity of each joint that has its own, in the order of the bodies.
        let mut places = BTreeMap::new();
        let (mut coordinates, mut velocities) = if self.request.floating {
            Posture::Floating.counts()
        } else {
            (0, 0)
        };
        for joint in &kept {
            let name = joint.name.text.as_str();
            if matches!(moves[name], Moves::Own) {
                places.insert(name, (coordinates, velocities));
                let (more_coordinates, more_velocities) = match posture(joint.kind) {
                    Some(posture) => posture.counts(),
                    None => (screws(joint).len(), screws(joint).len()),
                };
                coordinates += more_coordinates;
                velocities += more_velocities;
            }
        }

        let mut links = Vec::new();
        if self.request.floating {
            links.push(base);
            robot.bodies.push(Body {
                parent: None,
                placement: Matrix::identity(),
                motion: Motion::Posture {
                    posture: Posture::Floating,
                    coordinate: 0,
                    velocity: 0,
                },
                inertia: self.inertia(base),
                link: true,
            });
            // Nothing drives it.
            let nothing = || [(); 3].map(|()| Big::zero());
            let drives = (0..6).map(|velocity| Drive::new(velocity, Big::one(), nothing()));
            robot.drives.extend(drives);
        }
        for joint in kept {
            let on = joint.parent.text.as_str();
            let mut parent = links.iter().position(|&link| link == on);
            let mut placement = self.placement(&joint.origin);
            let parts = parts(joint, &moves[joint.name.text.as_str()], &places);
            let last = parts.len() - 1;
            let moved = parts.iter().any(|(_, motion)| motion.moves());
            for (k, (turn, motion)) in parts.into_iter().enumerate() {
                // What moves by a part of a joint's velocities is no link.
                let child = joint.child.text.as_str();
                links.push(if k == last { child } else { "" });
                let inertia = if k == last {
                    self.inertia(child)
                } else {
                    Matrix::zero()
                };
                let drives = Drive::of(self.request, joint, k, &motion);
                robot.drives.extend(drives);
                robot.bodies.push(Body {
                    parent,
                    placement: &placement * &turn,
                    motion,
                    inertia,
                    link: moved && k == last,
                });
                (parent, placement) = (Some(robot.bodies.len() - 1), Matrix::identity());
            }
        }
        links
    }

    /// The joints that are modelled, branch after branch, siblings as described.
    fn kept(&self, base: &str) -> Vec<&'d Joint> {
        let mut kept = Vec::new();
        let mut waiting: Vec<&Joint> = self.below(base).collect();
        // The last one in is the first one out.
        waiting.reverse();
        while let Some(joint) = waiting.pop() {
            kept.push(joint);
            let before = waiting.len();
            waiting.extend(self.below(&joint.child.text));
            waiting[before..].reverse();
        }
        kept
    }

    /// What moves each of the joints that are modelled.
    fn moves(&self, kept: &[&'d Joint], tip: Option<&'d str>) -> BTreeMap<&'d str, Moves<'d>> {
        let path = tip.map_or_else(BTreeSet::new, |tip| self.upwards(tip));
        // Who moves the tip, or moves who does.
        let mut needed: BTreeSet<&str> = BTreeSet::new();
        for joint in kept {
            if !self.request.path_only || path.contains(joint.child.text.as_str()) {
                let led = |joint: &&'d Joint| Some(self.leader(joint)?.0);
                let chain = std::iter::successors(Some(*joint), led);
                needed.extend(chain.map(|joint| joint.name.text.as_str()));
            }
        }
        let modelled = |joint: &Joint| {
            let mut there = kept.iter();
            there.any(|other| other.name.text == joint.name.text)
        };
        let of = |joint: &&'d Joint| {
            let (mut at, mut factor, mut offset) = (*joint, Big::one(), Big::zero());
            while let Some((leader, multiplier, more)) = self.leader(at) {
                offset = offset + &factor * more;
                factor = factor * multiplier;
                at = leader;
            }
            let stands = match self.locked(at) {
                Some(stands) => Some(stands),
                None if modelled(at) && needed.contains(at.name.text.as_str()) => None,
                None => Some(Big::zero()),
            };
            let moves = match stands {
                Some(stands) if modelled(at) => Moves::Not(factor * stands + offset),
                Some(_) => Moves::Not(offset),
                None if at.name.text == joint.name.text => Moves::Own,
                None if factor == Big::zero() => Moves::Not(offset),
                None => Moves::As {
                    leader: &at.name.text,
                    factor,
                    offset,
                },
            };
            (joint.name.text.as_str(), moves)
        };
        kept.iter().map(of).collect()
    }

    /// What a joint follows, times what and from where on, where it follows one.
    fn leader(&self, joint: &'d Joint) -> Option<(&'d Joint, Big, Big)> {
        let mimic = joint.mimic.as_ref()?;
        if self.locked(joint).is_some() {
            return None;
        }
        let mut joints = self.description.joints.iter();
        let leader = joints.find(|other| other.name.text == mimic.leader.text)?;
        Some((leader, big(&mimic.multiplier), big(&mimic.offset)))
    }

    /// Where a joint is held by what it is or by what was asked.
    fn locked(&self, joint: &Joint) -> Option<Big> {
        if !joint.kind.moves() {
            return Some(Big::zero());
        }
        let mut locks = self.request.lock.iter();
        let (_, at) = locks.find(|(name, _)| name.text == joint.name.text)?;
        Some(at.as_ref().map_or_else(Big::zero, big))
    }

    fn held(&self, described: &description::Loop, seat: impl Fn(&str) -> Option<usize>) -> Loop {
        use Closure::{Fixed, Rod, Spherical, Translation};
        let closure = described.closure;
        let has_axes = !matches!(closure, Fixed | Rod { .. } | Spherical | Translation);
        let axes = has_axes.then(|| described.axes.each_ref().map(axis));
        let frame = |link: &Name, at: &[Step], end: usize| {
            let turn = axes.as_ref().map(|axes| across(&axes[end]));
            let turn = turn.unwrap_or_else(Matrix::identity);
            (seat(&link.text), &self.placement(at) * &turn)
        };
        let products = axes.iter().flat_map(|[one, other]| one.iter().zip(other));
        Loop {
            closure,
            frames: [
                frame(&described.from, &described.at, 0),
                frame(&described.to, &described.to_at, 1),
            ],
            cosine: products.fold(Big::zero(), |sum, (x, y)| sum + x * y),
        }
    }

    fn gravity(&self) -> Matrix {
        let down = [0.0, 0.0, -9.81].map(Big::new);
        let given = self.request.gravity.as_ref();
        let a = given.map_or(down, |entries| entries.each_ref().map(big));
        Matrix::screw(&[(); 3].map(|()| Big::zero()), &a)
    }

    fn placement(&self, steps: &[Step]) -> Matrix {
        steps.iter().fold(Matrix::identity(), |placement, step| {
            &placement
                * &match step {
                    Step::Translate(t) => Matrix::translation(&t.each_ref().map(big)),
                    Step::Rotate(axis, angle) => rotation(*axis, self.sin_cos(angle)),
                }
        })
    }

    /// Sine and cosine: exactly those of a right angle where one rounds to the digits that stand there.
    fn sin_cos(&self, angle: &Number) -> (Big, Big) {
        let quarters = (angle.value * core::f64::consts::FRAC_2_PI).round();
        let written = angle.resolution > 0.0;
        let right = Big::pi() * Big::new(quarters / 2.0);
        let away = (big(angle) - right).abs().to_f64();
        // Half of the last digit, and what reading and printing in binary round.
        let open = angle.resolution / 2.0 * (1.0 + 1e-9) + angle.value.abs() * f64::EPSILON;
        let is_right = quarters != 0.0 && angle.resolution <= 0.01 && away <= open;
        if !is_right || (written && self.request.exact) {
            return big(angle).sin_cos();
        }
        let turn = |quarters: f64| match quarters.rem_euclid(4.0) {
            0.0 => Big::zero(),
            1.0 => Big::one(),
            2.0 => Big::zero(),
            _ => -Big::one(),
        };
        (turn(quarters), turn(quarters + 1.0))
    }

    /// M J Mᵗ of ∫rrᵗdm = ½ Tr(I) − I about the centre of mass (16), (17).
    fn inertia(&self, link: &str) -> Matrix {
        let mut links = self.description.links.iter();
        let link = links.find(|known| known.name.text == link);
        let Some(Inertial {
            origin,
            mass,
            inertia,
            ..
        }) = link.and_then(|link| link.inertial.as_ref())
        else {
            return Matrix::zero();
        };
        let [xx, xy, xz, yy, yz, zz] = inertia.each_ref().map(big);
        let half = (&xx + &yy + &zz) / Big::new(2.0);
        let nothing = Big::zero;
        let central = Matrix([
            [&half - xx, -&xy, -&xz, nothing()],
            [-xy, &half - yy, -&yz, nothing()],
            [-xz, -yz, half - zz, nothing()],
            [nothing(), nothing(), nothing(), big(mass)],
        ]);
        let placement = self.placement(origin);
        &(&placement * &central) * &placement.transposed()
    }
}

fn big(number: &Number) -> Big {
    Big::new(number.value)
}

/// R, 0; 0, 1 of a turn about a coordinate axis.
fn rotation(axis: Axis, (sine, cosine): (Big, Big)) -> Matrix {
    let (j, k) = match axis {
        Axis::X => (1, 2),
        Axis::Y => (2, 0),
        Axis::Z => (0, 1),
    };
    let mut matrix = Matrix::identity();
    matrix.0[j][k] = -&sine;
    matrix.0[k][j] = sine;
    matrix.0[j][j] = cosine.clone();
    matrix.0[k][k] = cosine;
    matrix
}

/// What moves a joint of a description.
enum Moves<'d> {
    /// Its own coordinates.
    Own,
    /// That of another, times a factor and from an offset on.
    As {
        leader: &'d str,
        factor: Big,
        offset: Big,
    },
    /// Nothing: it is held there.
    Not(Big),
}

/// The bodies that a joint moves, one on the other: a turn in front of each, and what moves it.
fn parts(
    joint: &Joint,
    moves: &Moves<'_>,
    places: &BTreeMap<&str, (usize, usize)>,
) -> Vec<(Matrix, Motion)> {
    let place = |name: &str| places[name];
    if let (Some(posture), Moves::Own) = (posture(joint.kind), moves) {
        let (coordinate, velocity) = place(&joint.name.text);
        let motion = Motion::Posture {
            posture,
            coordinate,
            velocity,
        };
        if posture != Posture::Planar {
            return vec![(Matrix::identity(), motion)];
        }
        let turn = across(&axis(&joint.axis));
        let back = turn.inverse();
        return vec![(turn, motion), (back, Motion::none())];
    }
    let along = |screw, (coordinate, velocity), factor: &Big, offset: &Big| Motion::Along {
        screw,
        coordinate,
        velocity,
        factor: factor.clone(),
        offset: offset.clone(),
    };
    let screws = screws(joint).into_iter().enumerate();
    let motions = screws.map(|(k, screw)| match moves {
        Moves::Own => {
            let (coordinate, velocity) = place(&joint.name.text);
            let places = (coordinate + k, velocity + k);
            along(screw, places, &Big::one(), &Big::zero())
        }
        Moves::As {
            leader,
            factor,
            offset,
        } => along(screw, place(leader), factor, offset),
        Moves::Not(at) => Motion::Held {
            screw,
            at: at.clone(),
        },
    });
    motions.map(|motion| (Matrix::identity(), motion)).collect()
}

/// What a joint is whose velocities are seen in the moved frame.
fn posture(kind: JointKind) -> Option<Posture> {
    Some(match kind {
        JointKind::Planar => Posture::Planar,
        JointKind::Spherical => Posture::Spherical,
        JointKind::Floating => Posture::Floating,
        _ => return None,
    })
}

/// A direction with length 1.
fn axis(written: &[Number; 3]) -> [Big; 3] {
    let axis = written.each_ref().map(big);
    let square = axis.iter().fold(Big::zero(), |sum, x| sum + x * x);
    axis.map(|entry| entry / square.sqrt())
}

/// L of each motion of a joint whose motions come one after the other, through the origin of its frame;
/// null of what does not move, or moves in another way.
fn screws(joint: &Joint) -> Vec<Matrix> {
    let nothing = [(); 3].map(|()| Big::zero());
    let turn = |written| Matrix::screw(&axis(written), &nothing);
    let slide = |written| Matrix::screw(&nothing, &axis(written));
    match joint.kind {
        JointKind::Revolute | JointKind::Continuous => vec![turn(&joint.axis)],
        JointKind::Prismatic => vec![slide(&joint.axis)],
        JointKind::Cylindrical => vec![turn(&joint.axis), slide(&joint.axis)],
        JointKind::Screw { pitch } => {
            vec![&turn(&joint.axis) + &slide(&joint.axis).times(&big(&pitch))]
        }
        JointKind::Universal => vec![turn(&joint.axis), turn(&joint.second_axis)],
        JointKind::Translation => (0..3).map(motion::slide).collect(),
        _ => vec![Matrix::zero()],
    }
}
