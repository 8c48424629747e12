//! Groups: the same operation once in each of several equal limbs.
//!
//! In: a [`Program`], and the inputs at the same place of each limb. Out: the group of each step, and its lane: the
//! index of its limb.
//!
//! Steps are visited by depth. Steps of different lanes are a group if they are the same operation on operands that
//! are in the same groups, in their own lanes, or in none, or literals. A sum and a difference are the same operation.
//! Steps that read the same value in no lane are found first: equal limbs have joints at other places, so that a
//! velocity of their common body may be turned for each.

use std::collections::{BTreeMap, HashMap};

use crate::expression::Input;
use crate::schedule::sections::Shared;
use crate::schedule::{Operand, Operation, Program, number};
use crate::space::{Limbs, Variable};

/// One value in each lane.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Index of the set of limbs.
    pub set: usize,
    /// Values, one for each limb.
    pub lanes: Vec<Operand>,
}

/// All groups of a program, operands before their readers.
#[derive(Debug, Default)]
pub struct Groups {
    /// Groups.
    pub all: Vec<Group>,
    /// Length of the longest path of steps to each step.
    pub depths: Vec<u32>,
    /// Group and lane of each value.
    of: HashMap<Shared, (usize, usize)>,
}

/// Property that an operand shares with those of other lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Like {
    /// Its group.
    Group(usize),
    /// Itself.
    Same(Shared),
    /// It is a literal.
    Literal,
    /// It is computed for each lane, from values that are in none.
    Other,
}

impl Like {
    /// The property of operands that are the same for all lanes, or one for each.
    pub const fn loose(self) -> Self {
        match self {
            Self::Same(_) => Self::Other,
            other => other,
        }
    }
}

/// Properties that the steps of one group share.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct GroupKey {
    /// Index of the set of limbs.
    set: usize,
    /// Kind of operation.
    kind: u8,
    /// Operands; those that commute are in order.
    like: [Option<Like>; 3],
}

impl GroupKey {
    /// The properties of steps that read another value in each lane.
    fn loose(self) -> Self {
        let like = self.like.map(|like| like.map(Like::loose));
        Self { like, ..self }
    }
}

/// Step that may be in a group.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    key: GroupKey,
    /// Magnitudes of its literals.
    literals: [u64; 3],
    lane: usize,
    step: u32,
}

impl Groups {
    /// Groups of a program.
    pub fn of(program: &Program, limbs: &[Limbs]) -> Self {
        let mut groups = Self::default();
        for (set, limbs) in limbs.iter().enumerate() {
            for variable in Variable::ALL {
                for row in limbs.entries(variable.space()) {
                    groups.inputs(set, variable, &row);
                }
            }
        }
        let depths = depths(program);
        let (before, after) = depths.split_at(program.before_angles);
        groups.steps(program, limbs, 0, before);
        groups.turns(program);
        groups.steps(program, limbs, before.len(), after);
        groups.depths = depths;
        groups
    }

    /// Group and lane of an operand.
    pub fn find(&self, operand: Operand) -> Option<(usize, usize)> {
        self.of.get(&Shared::of(operand)?).copied()
    }

    /// Property that an operand shares with those of other lanes.
    pub fn like(&self, operand: Operand) -> Like {
        match (Shared::of(operand), self.find(operand)) {
            (None, _) => Like::Literal,
            (Some(_), Some((group, _))) => Like::Group(group),
            (Some(value), None) => Like::Same(value),
        }
    }

    fn push(&mut self, set: usize, lanes: Vec<Operand>) {
        let group = self.all.len();
        for (lane, &operand) in lanes.iter().enumerate() {
            self.of
                .extend(Shared::of(operand).map(|value| (value, (group, lane))));
        }
        self.all.push(Group { set, lanes });
    }

    fn inputs(&mut self, set: usize, variable: Variable, row: &[usize]) {
        let input = |&entry: &usize| {
            let entry = u16::try_from(entry).expect("fewer than 2¹⁶ entries");
            Operand::Input(Input::Variable(variable, entry))
        };
        let lanes: Vec<Operand> = row.iter().map(input).collect();
        // Limbs may share a coordinate that their joints mimic.
        let is_own = |(k, operand): (usize, &Operand)| {
            self.find(*operand).is_none() && !lanes[..k].contains(operand)
        };
        if lanes.iter().enumerate().all(is_own) {
            self.push(set, lanes);
        }
    }

    /// Adds the sines and cosines of angles that are groups.
    fn turns(&mut self, program: &Program) {
        let mut number = HashMap::new();
        for (angle, &operand) in (0_u32..).zip(&program.angles) {
            if let Some(place) = self.find(operand) {
                number.insert(place, angle);
            }
        }
        for group in 0..self.all.len() {
            let Group { set, lanes } = &self.all[group];
            let (set, count) = (*set, lanes.len());
            let angles = (0..count).map(|lane| number.get(&(group, lane)).copied());
            let Some(angles) = angles.collect::<Option<Vec<u32>>>() else {
                continue;
            };
            for turn in [Operand::Sin, Operand::Cos] {
                self.push(set, angles.iter().map(|&angle| turn(angle)).collect());
            }
        }
    }

    /// Groups the steps from `first` on with these depths.
    fn steps(&mut self, program: &Program, limbs: &[Limbs], first: usize, depths: &[u32]) {
        let mut levels: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (at, &depth) in depths.iter().enumerate() {
            levels.entry(depth).or_default().push(number(first + at));
        }
        for steps in levels.values() {
            self.level(program, limbs, steps);
        }
    }

    /// Groups steps that do not read each other: first those with the same magnitudes of literals, then those that read
    /// the same values, then all others.
    fn level(&mut self, program: &Program, limbs: &[Limbs], steps: &[u32]) {
        let all = steps.iter().filter_map(|&step| {
            let operation = &program.steps[step as usize].operation;
            let (key, lane) = self.key(operation)?;
            Some(Candidate {
                key,
                literals: literals(operation),
                lane,
                step,
            })
        });
        let all: Vec<_> = all.collect();
        let all = self.pair(limbs, all, |candidate| (candidate.key, candidate.literals));
        let all = self.pair(limbs, all, |candidate| candidate.key);
        self.pair(limbs, all, |candidate| candidate.key.loose());
    }

    /// Groups steps with equal properties, the first ones of all lanes, then the second ones. Returns the others.
    fn pair<P: Ord>(
        &mut self,
        limbs: &[Limbs],
        mut all: Vec<Candidate>,
        property: impl Fn(&Candidate) -> P,
    ) -> Vec<Candidate> {
        all.sort_by_key(|candidate| (property(candidate), candidate.step));
        let mut rest = Vec::new();
        for alike in all.chunk_by(|one, other| property(one) == property(other)) {
            let set = alike[0].key.set;
            let mut lanes = vec![Vec::new(); limbs[set].count()];
            for &candidate in alike {
                lanes[candidate.lane].push(candidate);
            }
            let least = lanes.iter().map(Vec::len).min().unwrap_or_default();
            for k in 0..least {
                let steps = lanes.iter().map(|lane| Operand::Step(lane[k].step));
                self.push(set, steps.collect());
            }
            rest.extend(lanes.iter().flat_map(|lane| &lane[least..]));
        }
        rest
    }

    /// Key of an operation, and its lane; `None` if it is in no lane or in several.
    fn key(&self, operation: &Operation) -> Option<(GroupKey, usize)> {
        let operands = operation.operands();
        let mut place = None;
        let mut like = [None; 3];
        for (like, &operand) in like.iter_mut().zip(&operands) {
            *like = Some(self.like(operand));
            if let Some((group, lane)) = self.find(operand) {
                let found = (self.all[group].set, lane);
                if place.is_some_and(|place| place != found) {
                    return None;
                }
                place = Some(found);
            }
        }
        let kind = kind(operation);
        let commuting = match operation {
            Operation::Div(..) => 1,
            _ => operands.len().min(2),
        };
        like[..commuting].sort();
        let (set, lane) = place?;
        Some((GroupKey { set, kind, like }, lane))
    }
}

/// Sums and differences are of one kind.
const fn kind(operation: &Operation) -> u8 {
    match operation {
        Operation::Add(..) | Operation::Sub(..) => 0,
        Operation::Mul(..) => 1,
        Operation::Div(..) => 2,
        Operation::Sqrt(..) => 3,
        Operation::Sign(..) => 4,
        Operation::Neg(..) => 5,
        Operation::MulAdd(..) | Operation::MulSub(..) | Operation::NegMulAdd(..) => 6,
    }
}

/// Magnitudes of the literals of an operation.
fn literals(operation: &Operation) -> [u64; 3] {
    let mut found = [0; 3];
    for (found, operand) in found.iter_mut().zip(operation.operands()) {
        if let Operand::Literal(value) = operand {
            *found = value.abs().to_bits();
        }
    }
    found.sort_unstable();
    found
}

/// Length of the longest path of steps to each step.
fn depths(program: &Program) -> Vec<u32> {
    let mut depths: Vec<u32> = Vec::with_capacity(program.steps.len());
    let of_angles = |depths: &[u32]| {
        let angles = program.angles.iter().map(|&angle| match angle {
            Operand::Step(step) => depths[step as usize] + 1,
            _ => 0,
        });
        angles.collect::<Vec<_>>()
    };
    let mut angles = Vec::new();
    for (at, step) in program.steps.iter().enumerate() {
        if at == program.before_angles {
            angles = of_angles(&depths);
        }
        let operands = step.operation.operands().into_iter();
        let depth = operands.map(|operand| match operand {
            Operand::Step(step) => depths[step as usize] + 1,
            Operand::Sin(angle) | Operand::Cos(angle) => angles[angle as usize],
            Operand::Literal(_) | Operand::Input(_) => 0,
        });
        depths.push(depth.max().unwrap_or_default());
    }
    depths
}
