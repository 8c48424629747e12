//! Conversion of numbers to scalars.
//!
//! In: numbers of the description and of the request. Out: terms: the number as written, the input of a struct field
//! that replaces it, or exactly 0 and right angles if those are meant. Corrections, merged links and locked joints are
//! recorded in the report.

use super::TermReader;
use crate::chain::axis_rotation::roll_pitch_yaw;
use crate::chain::tree::{Branch, MimicLaw};
use crate::chain::{MimicJoint, Plane, Snapped, Turned, angle};
use crate::description::{Axis, Description, Joint, JointId, Number, Step};
use crate::expression::{Double, Input, Term};
use crate::joint::{DegreeOfFreedom, JointKind, Motion};
use crate::list::Id;
use crate::matrix::{Pose, Rotation, Vector};
use crate::request::Target;
use crate::space::FieldId;

/// Standard gravity as robot software has it, in a base whose z points up [m/s²].
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

impl<'g> TermReader<'g, '_> {
    pub(super) fn number(&self, number: &Number) -> Term<'g> {
        self.graph.number(number.exact())
    }

    /// The inputs of the struct field with a target, or the described values if there is no such field.
    pub(super) fn free<const N: usize>(
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

    pub(super) fn gravity(&mut self) -> Vector<Term<'g>> {
        let described = match &self.request.gravity {
            Some(gravity) => gravity.map(|entry| self.number(&entry)),
            None => Vector::constant(self.graph, GRAVITY).0,
        };
        Vector(self.free(|target| matches!(target, Target::Gravity), described))
    }

    /// The pose of the base in frame 0: the identity, unless a struct field sets it.
    pub(super) fn base(&mut self) -> Pose<Term<'g>> {
        let there = Vector::zero(self.graph).0;
        let position = self.free(|target| matches!(target, Target::BasePosition), there);
        let there = Pose::translation(Vector(position));
        self.placed(|target| matches!(target, Target::BasePlacement), there)
    }

    /// A placement from the struct field for it, or else from the description.
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

    pub(super) fn motion(&self, kind: JointKind, degree_of_freedom: DegreeOfFreedom) -> Motion {
        Motion::of(degree_of_freedom.movement, || {
            let pitch = kind.pitch().unwrap_or_default();
            self.number(&pitch).expr()
        })
    }

    /// The placement of a joint; it or its translation may come from a struct field.
    pub(super) fn origin(&mut self, description: &Description, branch: &Branch) -> Pose<Term<'g>> {
        let joint = &description[branch.joint];
        let mut placement = self.placement(&joint.name.text, &joint.origin);
        let is = |target: &Target| matches!(target, Target::OriginOf(name) if name.text == joint.name.text);
        placement.translation = Vector(self.free(is, placement.translation.0));
        let is = |target: &Target| matches!(target, Target::PlacementOf(name) if name.text == joint.name.text);
        self.placed(is, placement)
    }

    pub(super) fn placement(&mut self, item: &str, steps: &[Step]) -> Pose<Term<'g>> {
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
                Step::Quaternion(entries) => pose * Pose::rotation(self.turned(item, entries)),
            })
    }

    /// The rotation by a quaternion, exact for right angles.
    fn turned(&mut self, item: &str, entries: &[Number; 4]) -> Rotation<Term<'g>> {
        let written = angle::right_angles(entries).filter(|_| !self.request.exact);
        if let Some(squares) = written.or_else(|| angle::exact_right_angles(entries)) {
            let mut pairs = entries.iter().zip(squares);
            if written.is_some() && pairs.any(|(entry, square)| angle::is_rounded(entry, square)) {
                self.report.turned.push(Turned {
                    item: item.to_owned(),
                    written: entries.map(|entry| entry.value),
                    squares,
                    place: entries[0].place,
                });
            }
            let rotation = angle::rotation(squares);
            return Rotation(rotation.map(|row| row.map(|entry| self.graph.constant(entry))));
        }
        // Beside entries that are all small, a small one is no residue.
        let is_large = entries.iter().any(|entry| entry.value.abs() >= 0.5);
        let entries = entries.map(|entry| {
            if is_large {
                self.component(item, &entry)
            } else {
                self.number(&entry)
            }
        });
        Rotation::of_quaternion(entries).expect("a quaternion of zeros is refused")
    }

    /// An entry of an offset \[m\] or of a direction; 0 for a residue.
    pub(super) fn component(&mut self, item: &str, entry: &Number) -> Term<'g> {
        if self.request.exact || !angle::is_residue(entry) {
            return self.number(entry);
        }
        self.snap(item, entry, 0);
        self.graph.constant(0.0)
    }

    /// The directions of a joint's axes, of length 1 to all digits; zero for axes that it does not have.
    pub(super) fn axes(&mut self, joint: &Joint) -> [Vector<Term<'g>>; 2] {
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

    /// Sine and cosine of an angle, exact for right angles.
    fn sin_cos(&mut self, item: &str, angle: &Number) -> (Term<'g>, Term<'g>) {
        // A number without digits, such as `pi/2`, is exact.
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

    /// Records the directions of a planar joint's x and y, unless they are those of its frame.
    pub(super) fn note_plane(&mut self, joint: &str, rotation: &Rotation<Term<'g>>) {
        let numbers = rotation.map(|entry| entry.value().map_or(0.0, Double::to_f64));
        let [x, y, z] = [0, 1, 2].map(|k| numbers.column(k).0);
        if z[2] < 1.0 {
            let joint = joint.to_owned();
            self.report.planes.push(Plane { joint, x, y });
        }
    }

    pub(super) fn note_mimic(&mut self, description: &Description, joint: JointId, law: MimicLaw) {
        let name = |joint: JointId| description[joint].name.text.clone();
        self.report.mimicked.push(MimicJoint {
            joint: name(joint),
            mimicked: name(law.mimicked),
            multiplier: law.multiplier.to_f64(),
            offset: law.offset.to_f64(),
        });
    }

    pub(super) fn note(&mut self, description: &Description, branch: &Branch) {
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
