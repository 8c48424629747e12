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
use crate::dense::{Approximate, Body, Matrix, Moved, Robot};
use crate::description::{Axis, Description, Inertial, Joint, Link, Name, Number, Step};
use crate::expression::Arithmetic;
use crate::joint::Freedom;
use crate::request::{Request, Target};

type Scalar = Approximate;

/// What a robot cannot be made of.
#[derive(Debug)]
pub(super) struct Contradiction(pub(super) String);

/// The robot whose fields have these values.
pub(super) fn robot(
    description: &Description,
    request: &Request,
    chain: &Chain,
    fields: &[Vec<f64>],
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
    let links = by_name(description.links.iter().map(|link| &link.name));
    let coordinates = chain.joints.iter().enumerate();
    let coordinates: HashMap<&str, usize> = coordinates
        .map(|(k, joint)| (joint.name.as_str(), k))
        .collect();
    let base = match &request.base {
        Some(base) => base.text.as_str(),
        None => &chain.report.base,
    };
    let kept = reader.kept(base, &links);
    let tip = chain.frames.first().filter(|_| chain.has_tip);
    let path = reader.path(tip.map(|tip| tip.name.as_str()));

    let mut bodies: Vec<Body> = Vec::new();
    let mut seats: HashMap<&str, usize> = HashMap::new();
    let mut moving = 0;
    for joint in kept {
        let name = &joint.name.text;
        let mut parent = seats.get(joint.parent.text.as_str()).copied();
        let mut placement = reader.origin(joint)?;
        let held = reader.held(joint, &path);
        for (coordinate, freedom) in joint.kind.coordinates(name) {
            let moved = match (held, coordinates.get(coordinate.as_str())) {
                (Some(at), None) => Moved::Held(at),
                (None, Some(&k)) => {
                    moving += 1;
                    Moved::By(k)
                }
                _ => return Err(Contradiction(format!("whether joint {name} moves"))),
            };
            bodies.push(Body {
                parent,
                placement,
                screw: reader.screw(joint, freedom)?,
                moved,
                inertia: Matrix::zero(),
            });
            (parent, placement) = (Some(bodies.len() - 1), Matrix::identity());
        }
        if !joint.kind.moves() {
            bodies.push(Body {
                parent,
                placement,
                screw: [[Scalar::literal(0.0); 3]; 2],
                moved: Moved::Held(0.0),
                inertia: Matrix::zero(),
            });
        }
        // What the last coordinate moves is the link; what others move has no mass.
        let link = bodies.len() - 1;
        let child = joint.child.text.as_str();
        bodies[link].inertia = reader.inertia(&description.links[links[child]])?;
        seats.insert(child, link);
    }
    if moving != chain.joints.len() {
        return Err(Contradiction("how many joints move".to_owned()));
    }
    let frames = chain.frames.iter();
    Ok(Robot {
        bodies,
        gravity: reader.gravity(),
        frames: frames
            .map(|frame| seats.get(frame.name.as_str()).copied())
            .collect(),
    })
}

fn by_name<'d>(names: impl Iterator<Item = &'d Name>) -> HashMap<&'d str, usize> {
    names
        .enumerate()
        .map(|(k, name)| (name.text.as_str(), k))
        .collect()
}

struct Reader<'d> {
    description: &'d Description,
    request: &'d Request,
    /// The values of the struct's fields.
    fields: &'d [Vec<f64>],
    /// What was taken for quarter turns or zero, by item and bits.
    snapped: HashMap<(&'d str, u64), i64>,
}

impl<'d> Reader<'d> {
    /// The joints that carry what is modelled, parents before children.
    fn kept(&self, base: &'d str, links: &HashMap<&'d str, usize>) -> Vec<&'d Joint> {
        let mut carried: Vec<Vec<&Joint>> = links.iter().map(|_| Vec::new()).collect();
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

    fn held(&self, joint: &Joint, path: &[&str]) -> Option<f64> {
        let name = joint.name.text.as_str();
        if !joint.kind.moves() {
            return Some(0.0);
        }
        let mut locks = self.request.lock.iter();
        if let Some((_, at)) = locks.find(|(lock, _)| lock.text == name) {
            return Some(at.map_or(0.0, |at| at.value));
        }
        (self.request.path_only && !path.contains(&name)).then_some(0.0)
    }

    /// The value of the field that stands for a target.
    fn field<const N: usize>(&self, is: impl Fn(&Target) -> bool) -> Option<[Scalar; N]> {
        let mut parameters = self.request.parameters.iter();
        let field = parameters.position(|parameter| is(&parameter.target))?;
        Some(std::array::from_fn(|k| {
            Scalar::exact(self.fields[field][k])
        }))
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
        Ok(placement)
    }

    fn screw(&self, joint: &Joint, freedom: Freedom) -> Result<[[Scalar; 3]; 2], Contradiction> {
        let nothing = [Scalar::literal(0.0); 3];
        let axis = self.components(&joint.name.text, &joint.axis)?;
        let largest = axis
            .iter()
            .fold(0.0_f64, |most, entry| most.max(entry.size()));
        let axis = axis.map(|entry| entry / Scalar::exact(largest));
        let [x, y, z] = axis;
        let length = (x * x + y * y + z * z).sqrt();
        let axis = axis.map(|entry| entry / length);
        Ok(match freedom {
            Freedom::Turn => [axis, nothing],
            Freedom::Slide => [nothing, axis],
            Freedom::Helix => {
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
        let [xx, xy, xz, yy, yz, zz] = inertial.inertia.map(|entry| Scalar::literal(entry.value));
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
        Ok(origin.times(&central).times(&origin.transposed()))
    }
}
