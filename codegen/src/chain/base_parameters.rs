//! Base parameters: what torques can tell of the inertial parameters, and of which others each is told together with.
//!
//! In: a [`Chain`]. Out: [`BaseParameters`]. Whatever of a link's mass has a kinetic and a potential energy that its own
//! joint does not change is, to all other joints, mass of the link that it hangs on: so each link's ten columns of the
//! regressor depend on each other and on those of that link, or not at all (Mayeda, Yoshida and Osuka, "Base
//! parameters of manipulator dynamic models", 1990); and so do those of what its joint feels of a drive. That is found
//! numerically, in dense matrices at a few states, link by link (Gautier, "Numerical calculation of the base inertial
//! parameters of robots", 1991).
//!
//! Fields are what is described in their place.

mod columns;
mod span;

use super::Chain;
use crate::list::List;
use crate::random::Random;
use crate::request::Parameter;
use crate::space::ParameterId;
use columns::{Column, Columns};
use span::{ROUNDED, Span};

/// What torques can tell of a robot's inertial parameters.
#[derive(Clone, Debug, Default)]
pub struct BaseParameters {
    /// In the order of the parameters that lead them.
    pub groups: Vec<Group>,
    /// How far a column of the regressor that was taken for a combination of others is from one at most, beside its
    /// length; or beside that of the longest, where it was taken for nothing.
    pub nearest: f64,
}

impl BaseParameters {
    /// Whether a column may be a combination of others or not: it is nearer than a description's numbers tell, and farther
    /// than rounding makes it.
    #[must_use]
    pub fn is_uncertain(&self) -> bool {
        self.nearest > ROUNDED
    }

    /// The columns of the regressor that torques are made of by them.
    pub fn columns(&self) -> impl Iterator<Item = ParameterId> {
        self.groups.iter().map(Group::leader)
    }
}

/// Parameters that are told as one number: the first, and so much of each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The parameters with their factors; the first has 1.
    pub members: Vec<(ParameterId, f64)>,
    /// What they are described as, together.
    pub value: f64,
    /// What that is a sum of: the magnitudes of its terms.
    pub size: f64,
}

impl Group {
    /// The parameter whose column of the regressor is that of the group.
    #[must_use]
    pub fn leader(&self) -> ParameterId {
        self.members[0].0
    }
}

/// So much of each parameter, where there is any of it, in the order of the parameters.
type Form = Vec<(ParameterId, f64)>;

/// Of chains of more joints no function is generated, and nothing is looked for.
const MOST: usize = 1000;

/// Finds them.
pub(super) fn base_parameters(chain: &Chain) -> BaseParameters {
    if chain.joints.len() > MOST {
        return BaseParameters::default();
    }
    let columns = Columns::of(chain);
    let described = columns.described();
    let unit = |parameter: ParameterId| vec![(parameter, 1.0)];
    // What torques see in the place of each parameter: it, and what outboard links hand on.
    let mut seen: List<ParameterId, Form> = described.ids().map(unit).collect();
    let mut nearest: f64 = 0.0;
    if chain.all_lead() {
        for link in columns.links.ids().rev() {
            let own = columns.own(link);
            let parent = columns.links[link].parent;
            let inboard = parent.map(|parent| columns.of_link(parent, link));
            let inboard: Vec<Column> = inboard.into_iter().flatten().collect();
            let mut span = Span::among(own.iter().chain(&inboard).map(|(_, column)| column));
            for (parameter, column) in &inboard {
                span.take(*parameter, column);
            }
            hand_on(&own, &mut span, &mut seen);
            nearest = nearest.max(span.nearest());
        }
    } else {
        // What one coordinate moves in several places may be told apart or not: all columns are looked at together.
        let links = columns.links.ids();
        let all: Vec<Column> = links.flat_map(|link| columns.own(link)).collect();
        let mut span = Span::among(all.iter().map(|(_, column)| column));
        hand_on(&all, &mut span, &mut seen);
        nearest = span.nearest();
    }
    let kept = seen.numbered().filter(|(_, form)| !form.is_empty());
    let groups = kept.map(|(leader, form)| group(leader, form, &described));
    BaseParameters {
        groups: groups.collect(),
        nearest,
    }
}

/// The fields for which torques can tell more, or others, where they are not what is described.
///
/// All of them are looked at together, near what is described: where joints stand askew and gravity has no
/// axis, nothing is hidden that can be seen anywhere.
#[must_use]
pub fn revealing(chain: &Chain) -> Vec<&Parameter> {
    let fields = chain.parameters.iter();
    let fields: Vec<_> = fields
        .filter(|field| field.target.enters_regressors())
        .collect();
    if fields.is_empty() {
        return fields;
    }
    let mut random = Random(0);
    let both = chain.parameters.iter().zip(&chain.nominal);
    let elsewhere = Chain {
        nominal: both
            .map(|(field, nominal)| field.near(nominal, || random.unit()))
            .collect(),
        ..chain.clone()
    };
    let found = base_parameters(&elsewhere);
    if found.columns().eq(chain.base_parameters.columns()) {
        return Vec::new();
    }
    fields
}

/// Takes columns; where one is a combination of others, its parameter is handed on to theirs.
fn hand_on<'c>(own: &'c [Column], span: &mut Span<'c>, seen: &mut List<ParameterId, Form>) {
    for (parameter, column) in own {
        let Some(combination) = span.take(*parameter, column) else {
            continue;
        };
        let handed_on = std::mem::take(&mut seen[*parameter]);
        for (other, factor) in combination {
            add(&mut seen[other], &handed_on, factor);
        }
    }
}

/// Adds so much of another form: forms of long chains are long, and are gone through once.
fn add(sum: &mut Form, other: &Form, factor: f64) {
    let mut others = other.iter().map(|&(k, x)| (k, factor * x)).peekable();
    let mut all = Form::with_capacity(sum.len() + other.len());
    for &(parameter, x) in sum.iter() {
        all.extend(std::iter::from_fn(|| {
            others.next_if(|&(k, _)| k < parameter)
        }));
        let same = others.next_if(|&(k, _)| k == parameter);
        all.push((parameter, same.map_or(x, |(_, y)| x + y)));
    }
    all.extend(others);
    *sum = all;
}

fn group(leader: ParameterId, form: &Form, described: &List<ParameterId, f64>) -> Group {
    let others =
        (form.iter().copied()).filter(|&(parameter, factor)| parameter != leader && factor != 0.0);
    let members: Vec<(ParameterId, f64)> = [(leader, 1.0)].into_iter().chain(others).collect();
    let terms = members.iter().map(|&(k, factor)| factor * described[k]);
    Group {
        value: terms.clone().sum(),
        size: terms.map(f64::abs).sum(),
        members,
    }
}
