//! Base parameters: the combinations of inertial parameters that torques determine.
//!
//! In: a [`Chain`]. Out: [`BaseParameters`]. A combination of parameters causes no torque if its kinetic energy is
//! zero and its potential energy constant in every state. A part of a link's mass whose energies do not change with
//! the link's own joint acts on all other joints like mass of the parent link. So each link's ten columns of the
//! regressor depend on each other and on those of the parent link, or not at all (Mayeda, Yoshida and Osuka, "Base
//! parameters of manipulator dynamic models", 1990); links that one coordinate moves form one block. The dependences
//! are found numerically, by energies at random states in 106 bits, block by block (Gautier, "Numerical calculation
//! of the base inertial parameters of robots", 1991). Damping and friction depend only on those of joints with the
//! same velocity.
//!
//! Fields have their values in the description. The check compares the result with torques.

mod blocks;
mod energies;
mod links;
mod numbers;
mod span;

use super::{BodyId, Chain};
use crate::expression::Double;
use crate::list::List;
use crate::random::Random;
use crate::request::Parameter;
use crate::space::{ParameterId, VelocityId};
use energies::Energies;
use links::{Links, Together};
use numbers::{MOMENTS, Numbers};
use span::{Combination, Residuals, Span};

/// The combinations of a robot's inertial parameters that torques determine.
#[derive(Clone, Debug, Default)]
pub struct BaseParameters {
    /// In the order of their leading parameters.
    pub groups: Vec<BaseParameter>,
    /// Blocks of links, outermost first.
    pub blocks: Vec<LinkBlock>,
    /// Residuals of the columns that were taken for combinations of others, and of those that were not.
    left: Residuals,
}

/// Links whose columns may depend on each other.
#[derive(Clone, Debug, Default)]
pub struct LinkBlock {
    /// The velocities that move them relative to their parent links, and move no other link.
    pub velocities: Vec<VelocityId>,
    /// The leading parameters, in the order in which they were found.
    pub leading: Vec<ParameterId>,
}

impl BaseParameters {
    /// True if rounding may have decided which parameters lead a group.
    #[must_use]
    pub fn is_uncertain(&self) -> bool {
        self.left.is_uncertain()
    }

    /// The columns of the regressor that multiply the base parameters.
    pub fn columns(&self) -> impl Iterator<Item = ParameterId> {
        self.groups.iter().map(BaseParameter::leading)
    }
}

/// A base parameter: a linear combination of inertial parameters, its leading one with factor 1.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseParameter {
    /// The parameters with their factors; the first has 1.
    pub members: Vec<(ParameterId, f64)>,
    /// Its value in the description.
    pub value: f64,
    /// The sum of the magnitudes of the terms of that value.
    pub size: f64,
}

impl BaseParameter {
    /// The parameter whose column of the regressor is that of the group.
    #[must_use]
    pub fn leading(&self) -> ParameterId {
        self.members[0].0
    }
}

/// A parameter in a combination: its factor, and the size of the terms of that factor.
#[derive(Clone, Copy)]
struct Member {
    parameter: ParameterId,
    factor: Double,
    size: f64,
}

/// A combination, in the order of the parameters.
type ParameterSum = Vec<Member>;

/// Ratio to the size of its terms below which a factor is zero, from rounding in 106 bits.
const NOTHING: f64 = 1e-24;

/// The order in which columns of a link are tried, if not all are independent: entries off the diagonal first, the mass
/// last.
const ORDER: [usize; MOMENTS] = [5, 6, 8, 4, 7, 9, 1, 2, 3, 0];

/// Finds base parameters.
pub(super) fn base_parameters(chain: &Chain) -> BaseParameters {
    let links = Links::of(chain);
    let numbers = Numbers::of(chain);
    let together = links.together();
    let energies = Energies::of(chain, &numbers, &links.bodies, &links.often(&together));
    let described = links.described(&numbers);
    let unit = |parameter: ParameterId| {
        let factor = Double::from(1.0);
        vec![Member {
            parameter,
            factor,
            size: 1.0,
        }]
    };
    let mut regrouping = Regrouping {
        links: &links,
        numbers: &numbers,
        energies: &energies,
        sums: described.ids().map(unit).collect(),
        left: Residuals::default(),
    };
    let blocks = together.iter().map(|together| regrouping.block(together));
    let blocks = blocks.collect();
    let kept = regrouping
        .sums
        .numbered()
        .filter(|(_, sum)| !sum.is_empty());
    let groups = kept.map(|(leading, sum)| group(leading, sum, &described));
    BaseParameters {
        groups: groups.collect(),
        blocks,
        left: regrouping.left,
    }
}

/// The fields for which torques determine more base parameters, or others, if their values differ from the description.
///
/// All fields are varied together, near the described values. Generic axes and a generic direction of gravity show
/// every dependence there that shows anywhere.
#[must_use]
pub fn revealing<'c>(chain: &'c Chain, found: &BaseParameters) -> Vec<&'c Parameter> {
    let fields = chain.request.parameters.iter();
    let fields: Vec<_> = fields
        .filter(|field| field.target.enters_regressors())
        .collect();
    if fields.is_empty() {
        return fields;
    }
    let mut random = Random(0);
    let both = chain.request.parameters.iter().zip(&chain.nominal);
    let elsewhere = Chain {
        nominal: both
            .map(|(field, nominal)| field.near(nominal, || random.unit()))
            .collect(),
        ..chain.clone()
    };
    if base_parameters(&elsewhere).columns().eq(found.columns()) {
        return Vec::new();
    }
    fields
}

/// The result so far, block by block.
struct Regrouping<'f> {
    links: &'f Links<'f>,
    numbers: &'f Numbers,
    energies: &'f Energies,
    /// For each parameter the combination that it leads: itself, and the parameters of outboard links that depend on
    /// it.
    sums: List<ParameterId, ParameterSum>,
    left: Residuals,
}

impl Regrouping<'_> {
    /// Finds the leading parameters of a block of links, and adds the others to the sums that they depend on.
    fn block(&mut self, together: &Together) -> LinkBlock {
        let Together {
            outer,
            links,
            rows,
            bound,
        } = together;
        let no_armature = || std::iter::repeat_n((Double::ZERO, 0.0), bound.len());
        let [kinetic, potential] = *rows;
        let constant = [(0.0, kinetic), (1.0, potential)].into_iter();
        let constant = constant
            .flat_map(|(entry, count)| std::iter::repeat_n((Double::from(entry), entry), count));
        let mut span = Span::default();
        span.take(None, constant.chain(no_armature()));
        let outer = outer
            .iter()
            .flat_map(|&link| (0..MOMENTS).map(move |moment| (link, moment)));
        span.take_some(outer.map(|(link, moment)| {
            let column = self.energies.of_moment(link, moment, *rows);
            (Links::moment(link, moment), column.chain(no_armature()))
        }));
        let mut block = LinkBlock::default();
        // The first joint of each velocity.
        let mut movers: Vec<(VelocityId, BodyId)> = Vec::new();
        for &link in links {
            for moment in ORDER {
                let parameter = Links::moment(link, moment);
                let column = self.energies.of_moment(link, moment, *rows);
                let combination = span.take(Some(parameter), column.chain(no_armature()));
                self.settle(&mut block, parameter, combination);
            }
            for &joint in &self.links.own[link] {
                let velocity = self.links.chain.joints[joint].velocity;
                let mover = movers.iter().find(|(of, _)| *of == velocity);
                let mover = mover.map(|(_, mover)| *mover);
                if mover.is_none() {
                    movers.push((velocity, joint));
                }
                if let Some([armature, damping, friction]) = self.links.actuator(joint) {
                    let of_bound = bound.iter().map(|&(first, second)| match joint {
                        _ if joint == first => (Double::from(1.0), 1.0),
                        _ if Some(joint) == second => (Double::from(-1.0), 1.0),
                        _ => (Double::ZERO, 0.0),
                    });
                    let column = self.energies.of_armature(joint, *rows).chain(of_bound);
                    let combination = span.take(Some(armature), column);
                    self.settle(&mut block, armature, combination);
                    let [damped, rubbed] = self.beside(joint, mover);
                    self.settle(&mut block, damping, damped);
                    self.settle(&mut block, friction, rubbed);
                }
            }
        }
        block.velocities = movers.into_iter().map(|(velocity, _)| velocity).collect();
        self.left = self.left.and(span.left);
        block
    }

    /// The damping and the friction of a joint as multiples of those of another joint with its velocity: a torque f d
    /// (f q̇) and one f c sign(f q̇), where f is a joint's multiplier.
    fn beside(&self, joint: BodyId, mover: Option<BodyId>) -> [Option<Combination>; 2] {
        let Some((mover, parts)) =
            mover.and_then(|mover| Some((mover, self.links.actuator(mover)?)))
        else {
            return [None, None];
        };
        let [_, damping, friction] = parts;
        let ratio = self.numbers.factors[joint] / self.numbers.factors[mover];
        let size = if ratio.to_f64() < 0.0 { -ratio } else { ratio };
        [(damping, ratio * ratio), (friction, size)].map(|part| Some(vec![part]))
    }

    /// Records a parameter that leads a group, or adds its sum to those of the parameters that it depends on.
    fn settle(
        &mut self,
        block: &mut LinkBlock,
        parameter: ParameterId,
        combination: Option<Combination>,
    ) {
        let Some(combination) = combination else {
            block.leading.push(parameter);
            return;
        };
        let handed_on = std::mem::take(&mut self.sums[parameter]);
        for (other, factor) in combination {
            add(&mut self.sums[other], &handed_on, factor);
        }
    }
}

/// Adds a multiple of another sum, in one pass over both.
fn add(sum: &mut ParameterSum, other: &ParameterSum, factor: Double) {
    let size = factor.to_f64().abs();
    let mut others = other.iter().map(|member| Member {
        factor: factor * member.factor,
        size: size * member.size,
        ..*member
    });
    let mut others = others.by_ref().peekable();
    let mut all = ParameterSum::with_capacity(sum.len() + other.len());
    for member in sum.iter() {
        let before = |other: &Member| other.parameter < member.parameter;
        all.extend(std::iter::from_fn(|| others.next_if(before)));
        let same = others.next_if(|other| other.parameter == member.parameter);
        all.push(same.map_or(*member, |same| Member {
            factor: member.factor + same.factor,
            size: member.size + same.size,
            ..*member
        }));
    }
    all.extend(others);
    *sum = all;
}

fn group(
    leading: ParameterId,
    sum: &ParameterSum,
    described: &List<ParameterId, Double>,
) -> BaseParameter {
    // Factors that are rounding errors are left out.
    let is_there = |member: &&Member| member.factor.to_f64().abs() > NOTHING * member.size;
    let others = sum.iter().filter(|member| member.parameter != leading);
    let others = others.filter(is_there);
    let first = (leading, Double::from(1.0));
    let others = others.map(|member| (member.parameter, member.factor));
    let members: Vec<(ParameterId, Double)> = [first].into_iter().chain(others).collect();
    let terms = members.iter().map(|&(k, factor)| factor * described[k]);
    let value = terms.clone().fold(Double::ZERO, |sum, term| sum + term);
    BaseParameter {
        value: value.to_f64(),
        size: terms.map(|term| term.to_f64().abs()).sum(),
        members: (members.into_iter())
            .map(|(parameter, factor)| (parameter, factor.to_f64()))
            .collect(),
    }
}
