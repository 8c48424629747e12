//! The largest cost of each function.
//!
//! In: a file of lines `arm function instructions text stack`. Out: an error if a board needs more, and lower lines if all
//! need less. The numbers never go up.

use std::collections::BTreeMap;

/// The cost of a function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Instructions of a call.
    pub instructions: u32,
    /// Bytes of code and constants.
    pub text: u32,
    /// Bytes of stack.
    pub stack: u32,
}

impl Cost {
    /// The larger of each.
    pub fn max(self, other: Self) -> Self {
        self.each(other, u32::max)
    }

    /// The smaller of each.
    fn min(self, other: Self) -> Self {
        self.each(other, u32::min)
    }

    /// The budget for this cost: 3 % more, for other versions of the compiler.
    fn with_margin(self) -> Self {
        self.each(self, |cost, _| (cost * 103).div_ceil(400) * 4)
    }

    fn each(self, other: Self, choose: fn(u32, u32) -> u32) -> Self {
        Self {
            instructions: choose(self.instructions, other.instructions),
            text: choose(self.text, other.text),
            stack: choose(self.stack, other.stack),
        }
    }
}

/// The budget of one arm, by function.
pub struct Budget(BTreeMap<String, Cost>);

impl Budget {
    /// The lines of one arm.
    ///
    /// # Errors
    /// A line of another form.
    pub fn read(text: &str, arm: &str) -> Result<Self, String> {
        let mut budget = BTreeMap::new();
        let lines = text
            .lines()
            .filter(|line| !line.starts_with('#') && !line.trim().is_empty());
        for line in lines {
            let mut words = line.split_whitespace();
            let of = words.next();
            let function = words.next().unwrap_or_default();
            let numbers: Vec<u32> = words.filter_map(|word| word.parse().ok()).collect();
            let &[instructions, text, stack] = &*numbers else {
                return Err(format!(
                    "budget: `{line}` is not `arm function instructions text stack`"
                ));
            };
            if of == Some(arm) {
                let cost = Cost {
                    instructions,
                    text,
                    stack,
                };
                budget.insert(function.to_owned(), cost);
            }
        }
        Ok(Self(budget))
    }

    /// The line of a function that needs at most `cost`: no number is larger than before.
    pub fn lowered(&self, arm: &str, function: &str, cost: Cost) -> String {
        let budget = cost.with_margin();
        let Cost {
            instructions,
            text,
            stack,
        } = self.0.get(function).map_or(budget, |old| old.min(budget));
        format!("{arm} {function} {instructions} {text} {stack}\n")
    }

    /// Adds an error if `cost` is larger than the budget.
    pub fn check(&self, board: &str, function: &str, cost: Cost, wrong: &mut Vec<String>) {
        let Some(allowed) = self.0.get(function) else {
            wrong.push(format!(
                "budget: there is no line for `{function}`, which costs {cost:?}"
            ));
            return;
        };
        for (what, cost, allowed) in [
            ("instructions", cost.instructions, allowed.instructions),
            ("bytes of text", cost.text, allowed.text),
            ("bytes of stack", cost.stack, allowed.stack),
        ] {
            if cost > allowed {
                wrong.push(format!(
                    "budget: {function} on {board}: {cost} {what}, allowed {allowed}"
                ));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Budget, Cost};

    #[test]
    fn numbers_only_go_down() {
        let budget = Budget::read("puma gravity 100 200 300\n", "puma").expect("a line");
        let cost = Cost {
            instructions: 90,
            text: 199,
            stack: 400,
        };
        let line = budget.lowered("puma", "gravity", cost);
        assert_eq!(line, "puma gravity 96 200 300\n");
        let line = budget.lowered("puma", "bias", cost);
        assert_eq!(line, "puma bias 96 208 412\n");
    }

    #[test]
    fn costs_above_the_budget_are_errors() {
        let budget = Budget::read("# arm …\npuma gravity 10 20 30\n", "puma").expect("a line");
        let mut wrong = Vec::new();
        let mut cost = Cost {
            instructions: 10,
            text: 20,
            stack: 30,
        };
        budget.check("M4F", "gravity", cost, &mut wrong);
        assert!(wrong.is_empty());
        cost.text += 1;
        budget.check("M4F", "gravity", cost, &mut wrong);
        budget.check("M4F", "bias", cost, &mut wrong);
        assert_eq!(wrong.len(), 2, "{wrong:?}");
    }
}
