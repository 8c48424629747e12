//! Random robots with closed loops: points and axes of joints in a closed configuration.
//!
//! In: random numbers. Out: a [`Mechanism`] in frame 0 whose loops are closed where all coordinates are zero; planar
//! ones are in the plane z = 0. [`text`](mod@super::text) rounds the numbers when it writes them.

use std::array::from_fn;
use std::f64::consts::TAU;

use super::space::{Vector, across, cross, dot, length, minus, plus, scaled, turned, unit};
use crate::states::Random;

/// The kinds of robots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Four revolute joints in a plane.
    FourBar,
    /// The same, closed by a spherical joint, which makes one residual depend on the others.
    FourBarWithBall,
    /// A crank, a rod and a slider.
    SliderCrank,
    /// Five revolute joints in a plane.
    FiveBar,
    /// A four-bar linkage of equal opposite bars, with a third, redundant rocker.
    Parallelogram,
    /// Four revolute joints whose axes meet in a point.
    SphericalFourBar,
    /// Four skew revolute joints, movable only for special proportions.
    Bennett,
    /// Six legs of universal, prismatic and spherical joints.
    Stewart,
    /// Three arms with forearms that are links.
    Delta,
    /// Three arms with forearms that are massless rods.
    DeltaOfRods,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 10] = [
        Self::FourBar,
        Self::FourBarWithBall,
        Self::SliderCrank,
        Self::FiveBar,
        Self::Parallelogram,
        Self::SphericalFourBar,
        Self::Bennett,
        Self::Stewart,
        Self::Delta,
        Self::DeltaOfRods,
    ];

    /// True if some residuals depend on others where the loops are closed, though none of them is always zero.
    #[must_use]
    pub const fn is_redundant(self) -> bool {
        matches!(
            self,
            Self::FourBarWithBall | Self::Parallelogram | Self::SphericalFourBar | Self::Bennett
        )
    }
}

/// The motion that a joint allows, with its axes in frame 0.
#[derive(Clone, Debug)]
pub enum Motion {
    /// Rotation.
    Revolute(Vector),
    /// Translation \[m\].
    Prismatic(Vector),
    /// Rotation about a fixed axis, and about a second one that the first rotates.
    Universal(Vector, Vector),
    /// Translation along x, y and z.
    Translation,
    /// Any rotation.
    Spherical,
}

/// A joint and the link that it carries, which has the joint's name.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// The joint of the parent link; `None` for the base.
    pub parent: Option<usize>,
    /// The motion that it allows.
    pub motion: Motion,
    /// A point on its axes \[m\].
    pub point: Vector,
    /// The mass of its link \[kg\].
    pub mass: f64,
    /// The centre of mass of its link \[m\].
    pub center: Vector,
    /// Three vectors v whose dyads v vᵗ add up to the second moments of the link about its centre of mass \[√kg m\].
    pub spread: [Vector; 3],
    /// True if it has an actuator.
    pub is_actuated: bool,
}

/// The constraint of a loop.
#[derive(Clone, Copy, Debug)]
pub enum Closure {
    /// A pin joint about an axis.
    Revolute(Vector),
    /// A ball joint.
    Spherical,
    /// A rod from the first link's point to the second link's, which this is \[m\].
    Rod(Vector),
}

/// A closed loop.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Its constraint.
    pub closure: Closure,
    /// The joints of the two links that it connects.
    pub links: [usize; 2],
    /// The point where it connects them \[m\].
    pub point: Vector,
}

/// A robot with closed loops.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Its kind.
    pub kind: Kind,
    /// Its joints, parents before children.
    pub joints: Vec<Joint>,
    /// Its loops.
    pub loops: Vec<Loop>,
    /// Acceleration of gravity [m/s²].
    pub gravity: Vector,
}

const Z: Vector = [0.0, 0.0, 1.0];

/// A random robot of a kind.
pub fn draw(kind: Kind, random: &mut Random) -> Mechanism {
    let mut mechanism = Mechanism {
        kind,
        joints: Vec::new(),
        loops: Vec::new(),
        gravity: scaled(unit(from_fn(|_| random.normal())), 9.81),
    };
    match kind {
        Kind::FourBar | Kind::FourBarWithBall => mechanism.four_bar(random),
        Kind::SliderCrank => mechanism.slider_crank(random),
        Kind::FiveBar => mechanism.five_bar(random),
        Kind::Parallelogram => mechanism.parallelogram(random),
        Kind::SphericalFourBar => mechanism.spherical_four_bar(random),
        Kind::Bennett => mechanism.bennett(random),
        Kind::Stewart => mechanism.stewart(random),
        Kind::Delta | Kind::DeltaOfRods => mechanism.delta(random),
    }
    mechanism
}

impl Mechanism {
    fn joint(
        &mut self,
        (name, parent): (&str, Option<usize>),
        motion: Motion,
        point: Vector,
        random: &mut Random,
    ) -> usize {
        let mass = 0.1 + 0.9 * random.unit().abs();
        self.joints.push(Joint {
            name: name.to_owned(),
            parent,
            motion,
            point,
            mass,
            center: plus(point, from_fn(|_| 0.1 * random.unit())),
            spread: from_fn(|_| from_fn(|_| 0.05 * random.normal() * mass.sqrt())),
            is_actuated: false,
        });
        self.joints.len() - 1
    }

    fn pin(&mut self, links: [usize; 2], closure: Closure, point: Vector) {
        self.loops.push(Loop {
            closure,
            links,
            point,
        });
    }

    /// A revolute joint about z, with its point somewhere on the axis.
    fn hinge(
        &mut self,
        place: (&str, Option<usize>),
        [x, y]: [f64; 2],
        random: &mut Random,
    ) -> usize {
        let point = [x, y, 0.1 * random.unit()];
        self.joint(place, Motion::Revolute(Z), point, random)
    }

    fn four_bar(&mut self, random: &mut Random) {
        let [a, b, c, d] = polygon(random);
        let crank = self.hinge(("a", None), a, random);
        let coupler = self.hinge(("b", Some(crank)), b, random);
        let rocker = self.hinge(("c", None), d, random);
        self.joints[crank].is_actuated = true;
        let closure = match self.kind {
            Kind::FourBarWithBall => Closure::Spherical,
            _ => Closure::Revolute(Z),
        };
        self.pin(
            [coupler, rocker],
            closure,
            [c[0], c[1], 0.1 * random.unit()],
        );
    }

    fn slider_crank(&mut self, random: &mut Random) {
        let [a, b, c, d] = polygon(random);
        let crank = self.hinge(("a", None), a, random);
        let rod = self.hinge(("b", Some(crank)), b, random);
        let along = unit([c[1] - d[1], d[0] - c[0], 0.0]);
        let at = [d[0], d[1], 0.1 * random.unit()];
        let slider = self.joint(("c", None), Motion::Prismatic(along), at, random);
        self.joints[if random.chance(2) { crank } else { slider }].is_actuated = true;
        self.pin(
            [rod, slider],
            Closure::Revolute(Z),
            [c[0], c[1], 0.1 * random.unit()],
        );
    }

    fn five_bar(&mut self, random: &mut Random) {
        let [a, b, c, d] = polygon(random);
        let e = [d[0] + 0.3 * random.odd(), d[1] + 0.3 * random.odd()];
        let one = self.hinge(("a", None), a, random);
        let two = self.hinge(("b", Some(one)), b, random);
        let three = self.hinge(("c", None), e, random);
        let four = self.hinge(("d", Some(three)), d, random);
        for actuated in [one, three] {
            self.joints[actuated].is_actuated = true;
        }
        self.pin(
            [two, four],
            Closure::Revolute(Z),
            [c[0], c[1], 0.1 * random.unit()],
        );
    }

    fn parallelogram(&mut self, random: &mut Random) {
        let [a, b, _, d] = polygon(random);
        let bar = [b[0] - a[0], b[1] - a[1]];
        let e = [a[0] + 0.3 * random.odd(), a[1] + 0.4];
        let over = |[x, y]: [f64; 2]| [x + bar[0], y + bar[1]];
        let crank = self.hinge(("a", None), a, random);
        let coupler = self.hinge(("b", Some(crank)), b, random);
        self.joints[crank].is_actuated = true;
        for (name, foot) in [("c", d), ("d", e)] {
            let rocker = self.hinge((name, None), foot, random);
            let [x, y] = over(foot);
            self.pin(
                [coupler, rocker],
                Closure::Revolute(Z),
                [x, y, 0.1 * random.unit()],
            );
        }
    }

    fn spherical_four_bar(&mut self, random: &mut Random) {
        let corners = polygon(random);
        let [a, b, c, d] = corners.map(|[x, y]| unit([x, y, 0.4]));
        let mut on = |axis: Vector| scaled(axis, 0.2 + 0.1 * random.unit());
        let points = [on(a), on(b), on(d), on(c)];
        let mut hinge =
            |place, axis, point| self.joint(place, Motion::Revolute(axis), point, random);
        let crank = hinge(("a", None), a, points[0]);
        let coupler = hinge(("b", Some(crank)), b, points[1]);
        let rocker = hinge(("c", None), d, points[2]);
        self.joints[crank].is_actuated = true;
        self.pin([coupler, rocker], Closure::Revolute(c), points[3]);
    }

    /// Bennett's linkage: bars of lengths a, b, a, b and twists α, β, α, β with a sin β = b sin α.
    fn bennett(&mut self, random: &mut Random) {
        let [alpha, beta] = [0.7 + 0.2 * random.unit(), 1.3 + 0.1 * random.unit()];
        let a = 0.25 + 0.05 * random.unit();
        let b = a * beta.sin() / alpha.sin();
        let first = 1.2 + 0.4 * random.unit();
        let ratio = (0.5 * (beta + alpha)).sin() / (0.5 * (beta - alpha)).sin();
        // The proportion whose loop closes.
        let second = [ratio, ratio.recip(), -ratio, -ratio.recip()]
            .map(|ratio| 2.0 * ratio.atan2((0.5 * first).tan()));
        let bars = [(alpha, a), (beta, b), (alpha, a), (beta, b)];
        let frames =
            second.map(|second| denavit_hartenberg([first, second, -first, -second], bars));
        let open = |frames: &[(Vector, Vector); 5]| {
            length(minus(frames[4].0, frames[0].0)) + length(minus(frames[4].1, frames[0].1))
        };
        let frames = frames
            .iter()
            .min_by(|one, other| open(one).total_cmp(&open(other)));
        let frames = frames.expect("there are four");
        assert!(open(frames) < 1e-12, "a Bennett linkage closes");
        let mut hinge = |place, k: usize| {
            let (point, axis) = frames[k];
            self.joint(place, Motion::Revolute(axis), point, random)
        };
        let crank = hinge(("a", None), 0);
        let coupler = hinge(("b", Some(crank)), 1);
        let rocker = hinge(("c", None), 3);
        self.joints[crank].is_actuated = true;
        let (point, axis) = frames[2];
        self.pin([coupler, rocker], Closure::Revolute(axis), point);
    }

    fn stewart(&mut self, random: &mut Random) {
        let mut ring = |radius: f64, height: f64, shift: f64| -> [Vector; 6] {
            from_fn(|k| {
                let pair = f64::from(u8::try_from(k / 2).expect("three")) * TAU / 3.0 + shift;
                let side = if k % 2 == 0 { -0.25 } else { 0.25 };
                let (sine, cosine) = (pair + side * (1.0 + 0.2 * random.unit())).sin_cos();
                let height = height + 0.02 * random.unit();
                [radius * cosine, radius * sine, height]
            })
        };
        let (feet, mut balls) = (ring(0.5, 0.0, 0.0), ring(0.3, 0.6, TAU / 6.0));
        // The legs connect different pairs.
        balls.rotate_right(1);
        let mut platform = None;
        for (k, (foot, ball)) in feet.into_iter().zip(balls).enumerate() {
            let along = unit(minus(ball, foot));
            let first = across(along);
            let motion = Motion::Universal(first, cross(along, first));
            let lower = self.joint((&format!("u{k}"), None), motion, foot, random);
            let middle = plus(foot, scaled(minus(ball, foot), 0.5));
            let place = (&*format!("p{k}"), Some(lower));
            let upper = self.joint(place, Motion::Prismatic(along), middle, random);
            self.joints[upper].is_actuated = true;
            match platform {
                None => {
                    let place = ("platform", Some(upper));
                    platform = Some(self.joint(place, Motion::Spherical, ball, random));
                }
                Some(platform) => self.pin([upper, platform], Closure::Spherical, ball),
            }
        }
    }

    fn delta(&mut self, random: &mut Random) {
        let mut arms = Vec::new();
        for k in 0..3_u8 {
            let angle = f64::from(k) * TAU / 3.0 + 0.2 * random.unit();
            let (sine, cosine) = angle.sin_cos();
            let (out, around) = ([cosine, sine, 0.0], [-sine, cosine, 0.0]);
            let shoulder = scaled(out, 0.1 + 0.02 * random.unit());
            let raised = 0.4 * random.unit();
            let reach = plus(scaled(out, raised.cos()), scaled(Z, raised.sin()));
            let elbow = plus(shoulder, scaled(reach, 0.2 + 0.05 * random.unit()));
            let arm = self.joint(
                (&format!("arm{k}"), None),
                Motion::Revolute(around),
                shoulder,
                random,
            );
            self.joints[arm].is_actuated = true;
            arms.push((arm, out, around, elbow));
        }
        let forearms: Vec<usize> = match self.kind {
            Kind::Delta => arms
                .iter()
                .enumerate()
                .map(|(k, &(arm, out, around, elbow))| {
                    let ball = plus(scaled(out, 0.05), [0.0, 0.0, -0.4]);
                    let along = unit(minus(ball, elbow));
                    let motion = Motion::Universal(around, unit(cross(around, along)));
                    self.joint((&format!("forearm{k}"), Some(arm)), motion, elbow, random)
                })
                .collect(),
            _ => Vec::new(),
        };
        let center = [0.03 * random.unit(), 0.03 * random.unit(), -0.4];
        let platform = self.joint(("platform", None), Motion::Translation, center, random);
        for (k, &(arm, out, _, elbow)) in arms.iter().enumerate() {
            let ball = plus(scaled(out, 0.05), [0.0, 0.0, -0.4]);
            match forearms.get(k) {
                Some(&forearm) => self.pin([forearm, platform], Closure::Spherical, ball),
                None => self.pin([arm, platform], Closure::Rod(ball), elbow),
            }
        }
    }

    /// The points on both links at which a loop connects them.
    #[must_use]
    pub fn ends(closed: &Loop) -> [Vector; 2] {
        match closed.closure {
            Closure::Rod(other) => [closed.point, other],
            Closure::Revolute(_) | Closure::Spherical => [closed.point; 2],
        }
    }

    /// Inertia tensor of a link about its centre of mass, as rows in frame 0 [kg m²].
    #[must_use]
    pub fn inertia(joint: &Joint) -> [Vector; 3] {
        let squares: f64 = joint.spread.iter().map(|axis| dot(*axis, *axis)).sum();
        from_fn(|i| {
            from_fn(|k| {
                let products = joint.spread.iter().map(|axis| axis[i] * axis[k]);
                let whole = if i == k { squares } else { 0.0 };
                whole - products.sum::<f64>()
            })
        })
    }
}

/// Origins and z axes of five Denavit–Hartenberg frames, the first of which is frame 0.
fn denavit_hartenberg(angles: [f64; 4], bars: [(f64, f64); 4]) -> [(Vector, Vector); 5] {
    let (mut origin, mut axes) = ([0.0; 3], super::space::IDENTITY);
    let mut frames = [(origin, Z); 5];
    for (k, (angle, (twist, bar))) in angles.into_iter().zip(bars).enumerate() {
        let ((s, c), (st, ct)) = (angle.sin_cos(), twist.sin_cos());
        let rotation = [[c, -s * ct, s * st], [s, c * ct, -c * st], [0.0, st, ct]];
        origin = plus(origin, turned(&axes, [bar * c, bar * s, 0.0]));
        axes = super::space::product(&axes, &rotation);
        frames[k + 1] = (origin, turned(&axes, Z));
    }
    frames
}

/// Four points in a plane; neighbouring bars between them are not nearly parallel.
fn polygon(random: &mut Random) -> [[f64; 2]; 4] {
    loop {
        let mut around = |x: f64, y: f64| [x + 0.08 * random.odd(), y + 0.08 * random.odd()];
        let points = [
            around(0.0, 0.0),
            around(0.1, 0.2),
            around(0.45, 0.3),
            around(0.4, 0.0),
        ];
        let bars: [Vector; 3] = from_fn(|k| {
            let [from, to] = [points[k], points[k + 1]];
            unit([to[0] - from[0], to[1] - from[1], 0.0])
        });
        let is_far = |k: usize| length(cross(bars[k], bars[k + 1])) > 0.4;
        if is_far(0) && is_far(1) {
            return points;
        }
    }
}
