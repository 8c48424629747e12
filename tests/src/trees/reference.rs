//! A description as the runtime's chain, joint by joint.
//!
//! In: a description whose joint k carries link k + 1, in any order, and a request. Out: a chain
//! with all its joints. One that is fixed, or not modelled, has no screw; one that is not modelled
//! carries no mass either. It merges nothing, so that it shares no step with the generator.

use std::array::from_fn;

use homogen::rotation;
use homogen::{Chain, Inertia, Joint, Pose, Screw};
use homogen_codegen::description::{
    self, Axis, Description, Inertial, JointKind, Link, Name, Number, Step,
};
use homogen_codegen::request::{Request, Target};

use super::JOINTS;

#[derive(Clone, Debug)]
pub(super) struct Reference {
    pub(super) chain: Chain<JOINTS, 0>,
    /// Where a joint is held; none where it moves.
    pub(super) held: [Option<f64>; JOINTS],
    base: usize,
}

/// The number at the end of `joint3` or `link3`.
pub(super) fn index(name: &str) -> usize {
    let digits = name.trim_start_matches(char::is_alphabetic);
    digits.parse().expect("names end in their number")
}

impl Reference {
    pub(super) fn of(description: &Description, request: &Request, fields: &[[f64; 3]]) -> Self {
        let robot = Robot {
            description,
            request,
            fields,
        };
        let base = request.base.as_ref().map_or(0, |name| index(&name.text));
        let bodies = from_fn(|k| robot.body(k, base));
        let given = request.gravity.map(|entries| entries.map(value));
        let gravity = robot.field(|target| matches!(target, Target::Gravity));
        let gravity = gravity.or(given).unwrap_or([0.0, 0.0, -9.81]);
        Self {
            chain: Chain::new(bodies, [], gravity),
            held: from_fn(|k| robot.held(k, base)),
            base,
        }
    }

    /// Whether a joint that carries a link moves.
    pub(super) fn moves(&self, link: usize) -> bool {
        let parent = |k: &usize| self.chain.joints[*k].parent;
        let mut carriers = std::iter::successors(self.body(link), parent);
        carriers.any(|k| self.held[k].is_none())
    }

    /// The joint whose body a link is; none for the base.
    pub(super) fn body(&self, link: usize) -> Option<usize> {
        body(link, self.base)
    }
}

fn body(link: usize, base: usize) -> Option<usize> {
    link.checked_sub(1).filter(|_| link != base)
}

struct Robot<'d> {
    description: &'d Description,
    request: &'d Request,
    fields: &'d [[f64; 3]],
}

impl Robot<'_> {
    fn joint(&self, k: usize) -> &description::Joint {
        let mut joints = self.description.joints.iter();
        joints
            .find(|joint| index(&joint.name.text) == k)
            .expect("every joint is described")
    }

    fn link(&self, k: usize) -> &Link {
        let mut links = self.description.links.iter();
        links
            .find(|link| index(&link.name.text) == k)
            .expect("every link is described")
    }

    /// The links from one up to the root.
    fn upwards(&self, link: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(link), |link| {
            let joint = link.checked_sub(1)?;
            Some(index(&self.joint(joint).parent.text))
        })
    }

    /// Whether the base carries link k + 1 by joint k, without a dropped link between them.
    fn models(&self, k: usize, base: usize) -> bool {
        let mut below = self.upwards(k + 1).take_while(|&link| link != base);
        let reaches = self.upwards(k + 1).skip(1).any(|link| link == base);
        let drop = &self.request.drop;
        reaches && below.all(|link| drop.iter().all(|dropped| index(&dropped.text) != link))
    }

    fn held(&self, k: usize, base: usize) -> Option<f64> {
        if matches!(self.joint(k).kind, JointKind::Fixed) || !self.models(k, base) {
            return Some(0.0);
        }
        let mut locks = self.request.lock.iter();
        if let Some((_, at)) = locks.find(|(name, _)| index(&name.text) == k) {
            return Some(at.map_or(0.0, value));
        }
        let tip = self.request.tip.as_ref().map(|name| index(&name.text));
        let tip = tip.filter(|_| self.request.path_only)?;
        let off_path = !self.upwards(tip).any(|link| link == k + 1);
        off_path.then_some(0.0)
    }

    /// The value of the field that stands for a target.
    fn field(&self, is: impl Fn(&Target) -> bool) -> Option<[f64; 3]> {
        let mut parameters = self.request.parameters.iter();
        let field = parameters.position(|parameter| is(&parameter.target))?;
        Some(self.fields[field])
    }

    fn body(&self, k: usize, base: usize) -> Joint {
        if !self.models(k, base) {
            let nothing = Screw::new([0.0; 3], [0.0; 3]);
            return Joint::new("", None, Pose::identity(), nothing, Inertia::zero());
        }
        let joint = self.joint(k);
        let origin =
            self.field(|target| matches!(target, Target::OriginOf(of) if is(of, &joint.name)));
        let mut placement = pose(&joint.origin);
        if let Some(origin) = origin {
            placement = Pose::new(*placement.rotation(), origin);
        }
        let parent = body(index(&joint.parent.text), base);
        Joint::new("", parent, placement, screw(joint), self.inertia(k + 1))
    }

    fn inertia(&self, link: usize) -> Inertia<f64> {
        let link = self.link(link);
        let mass = self.field(|target| matches!(target, Target::MassOf(of) if is(of, &link.name)));
        let center =
            self.field(|target| matches!(target, Target::CenterOfMassOf(of) if is(of, &link.name)));
        let nothing = Inertial {
            origin: Vec::new(),
            mass: Number::default(),
            inertia: [Number::default(); 6],
            place: link.name.place,
        };
        let inertial = link.inertial.as_ref().unwrap_or(&nothing);
        let [xx, xy, xz, yy, yz, zz] = inertial.inertia.map(value);
        let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let mass = mass.map_or(inertial.mass.value, |[mass, ..]| mass);
        let mut placement = pose(&inertial.origin);
        if let Some(center) = center {
            placement = Pose::new(*placement.rotation(), center);
        }
        placement.change_frame(&Inertia::from_tensor_at_origin(mass, [0.0; 3], &tensor))
    }
}

fn is(one: &Name, other: &Name) -> bool {
    one.text == other.text
}

fn value(number: Number) -> f64 {
    number.value
}

fn screw(joint: &description::Joint) -> Screw<f64> {
    let axis = joint.axis.map(value);
    match joint.kind {
        JointKind::Revolute | JointKind::Continuous => Screw::revolute(axis, [0.0; 3]),
        JointKind::Prismatic => Screw::prismatic(axis),
        JointKind::Screw { pitch } => Screw::helical(axis, [0.0; 3], pitch.value),
        JointKind::Fixed => Screw::new([0.0; 3], [0.0; 3]),
    }
}

fn pose(steps: &[Step]) -> Pose<f64> {
    steps.iter().fold(Pose::identity(), |pose, step| {
        pose * match step {
            Step::Translate(offset) => Pose::from_translation(offset.map(value)),
            Step::Rotate(axis, angle) => {
                let u = match axis {
                    Axis::X => [1.0, 0.0, 0.0],
                    Axis::Y => [0.0, 1.0, 0.0],
                    Axis::Z => [0.0, 0.0, 1.0],
                };
                Pose::new(rotation::from_axis_angle(u, angle.value), [0.0; 3])
            }
        }
    })
}
