//! A description as dense matrices of 256 bits, joint by joint.
//!
//! In: a description and a request. Out: a placement, a screw L and an inertia J for every joint that
//! hangs on the base, fixed and locked ones too: nothing is merged, turned or regrouped. It shares with
//! the generator the reading of the text and nothing after it. Where that is to be contradicted too,
//! [`trees::dense`](crate::trees::dense) makes the same matrices of numbers as they were drawn.

use std::collections::BTreeSet;

use homogen_codegen::description::{Axis, Description, Inertial, Joint, Name, Number, Step};
use homogen_codegen::joint::JointKind;
use homogen_codegen::request::Request;

use super::matrix::Matrix;
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
}

/// A joint and the link that it carries.
#[derive(Clone, Debug)]
pub struct Body {
    /// The body it hangs on; none for the base.
    pub parent: Option<usize>,
    /// M_parent,i at q = 0.
    pub placement: Matrix,
    /// L in frame (i); null for a fixed joint.
    pub screw: Matrix,
    /// J in frame (i).
    pub inertia: Matrix,
    /// What moves it.
    pub coordinate: Coordinate,
    /// Whether it is a link, and not what moves by a part of a joint's coordinates.
    pub link: bool,
}

/// What moves a joint.
#[derive(Clone, Debug)]
pub enum Coordinate {
    /// The entry of q of that index.
    Free(usize),
    /// Nothing: it is held there.
    Held(Big),
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
        let path = tip.map(|tip| reader.upwards(tip));
        let mut robot = Self {
            bodies: Vec::new(),
            frames: Vec::new(),
            gravity: reader.gravity(),
        };
        let links = reader.hang(base, path.as_ref(), &mut robot);
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
        robot
    }

    /// How many joints move.
    #[must_use]
    pub fn joints(&self) -> usize {
        let free = |body: &&Body| matches!(body.coordinate, Coordinate::Free(_));
        self.bodies.iter().filter(free).count()
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
    fn hang(
        &self,
        base: &'d str,
        path: Option<&BTreeSet<&str>>,
        robot: &mut Robot,
    ) -> Vec<&'d str> {
        let mut links = Vec::new();
        let mut waiting: Vec<(Option<usize>, &Joint)> = Vec::new();
        let below = |parent, link: &str, waiting: &mut Vec<_>| {
            let before = waiting.len();
            waiting.extend(self.below(link).map(|joint| (parent, joint)));
            // The last one in is the first one out.
            waiting[before..].reverse();
        };
        below(None, base, &mut waiting);
        while let Some((parent, joint)) = waiting.pop() {
            let child = joint.child.text.as_str();
            let off_path = path.is_some_and(|path| !path.contains(child));
            let held = self.held(joint, off_path);
            let (mut parent, mut placement) = (parent, self.placement(&joint.origin));
            let screws = screws(joint);
            let last = screws.len() - 1;
            for (k, screw) in screws.into_iter().enumerate() {
                // What moves by a part of a joint's coordinates is no link.
                links.push(if k == last { child } else { "" });
                let inertia = if k == last {
                    self.inertia(child)
                } else {
                    Matrix::zero()
                };
                let coordinate = match &held {
                    Some(at) => Coordinate::Held(at.clone()),
                    None => Coordinate::Free(robot.joints()),
                };
                robot.bodies.push(Body {
                    parent,
                    placement,
                    screw,
                    inertia,
                    coordinate,
                    link: k == last,
                });
                (parent, placement) = (Some(robot.bodies.len() - 1), Matrix::identity());
            }
            below(Some(robot.bodies.len() - 1), child, &mut waiting);
        }
        links
    }

    /// Where a joint is held; none where it moves.
    fn held(&self, joint: &Joint, off_path: bool) -> Option<Big> {
        if !joint.kind.moves() {
            return Some(Big::zero());
        }
        let mut locks = self.request.lock.iter();
        if let Some((_, at)) = locks.find(|(name, _)| name.text == joint.name.text) {
            return Some(at.as_ref().map_or_else(Big::zero, big));
        }
        (self.request.path_only && off_path).then(Big::zero)
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

/// L of each coordinate of a joint, through the origin of its frame, about or along an axis of length 1;
/// null of a fixed one.
fn screws(joint: &Joint) -> Vec<Matrix> {
    let nothing = [(); 3].map(|()| Big::zero());
    if !joint.kind.moves() {
        return vec![Matrix::zero()];
    }
    let axis = joint.axis.each_ref().map(big);
    let square = axis.iter().fold(Big::zero(), |sum, x| sum + x * x);
    let axis = axis.map(|entry| entry / square.sqrt());
    let (turn, slide) = (
        Matrix::screw(&axis, &nothing),
        Matrix::screw(&nothing, &axis),
    );
    match joint.kind {
        JointKind::Prismatic => vec![slide],
        JointKind::Cylindrical => vec![turn, slide],
        JointKind::Screw { pitch } => vec![&turn + &slide.times(&big(&pitch))],
        _ => vec![turn],
    }
}
