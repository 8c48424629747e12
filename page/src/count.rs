//! Operation counts and error bounds of functions, and functions that a robot cannot have.

use serde_json::{Map, Value, json};

use homogen_codegen::accuracy::{Accuracy, Bound, Perturbed};
use homogen_codegen::module::{GeneratedFunction, LeftOut, Module};
use homogen_codegen::schedule::OperationCount;

/// The numbers of an operation count in the order of the table; signs only if requested. A name of two words is a group
/// and a key.
#[must_use]
pub fn columns(operation_count: &OperationCount, signs: bool) -> Vec<(&'static str, usize)> {
    let mut columns = vec![
        ("mul", operation_count.mul),
        ("add", operation_count.add),
        ("div", operation_count.div),
        ("sqrt", operation_count.sqrt),
        ("sin", operation_count.sin),
        ("cos", operation_count.cos),
        ("neg", operation_count.neg),
        ("fused", operation_count.fused),
        ("depth", operation_count.depth),
        ("literals", operation_count.literals),
        ("naive mul", operation_count.naive_mul),
        ("naive add", operation_count.naive_add),
    ];
    if signs {
        columns.push(("sign", operation_count.sign));
    }
    columns
}

/// True if any of the functions computes a sign, as those with Coulomb friction do.
#[must_use]
pub fn have_signs(functions: &[GeneratedFunction]) -> bool {
    functions
        .iter()
        .any(|generated| generated.operation_count.sign > 0)
}

/// Operation count and error bounds of a function; signs only if requested.
#[must_use]
pub fn operation_count(generated: &GeneratedFunction, signs: bool) -> Value {
    let mut operation_count = json!({});
    for (name, number) in columns(&generated.operation_count, signs) {
        match name.split_once(' ') {
            Some((group, name)) => operation_count[group][name] = json!(number),
            None => operation_count[name] = json!(number),
        }
    }
    if let Some((_, cycles)) = generated.operation_count.cycles {
        operation_count["cycles"] = json!(cycles);
    }
    operation_count["errors"] = generated.accuracy.iter().map(error).collect();
    if let Some(found) = &generated.found {
        operation_count["found"] = json!({
            "of": "largest result",
            found.scalar.name(): found.relative,
            "random": found.random,
            "uphill": found.uphill,
        });
    }
    operation_count
}

/// Functions that the robot cannot have, with the reasons.
#[must_use]
pub fn left_out(module: &Module) -> Value {
    let left_out = module.about.left_out.iter();
    let left_out = left_out.map(
        |LeftOut {
             functions,
             reason,
             hint,
             is_fault,
         }| {
            json!({ "functions": functions, "reason": reason, "hint": hint, "fault": is_fault })
        },
    );
    left_out.collect()
}

/// An error bound: the maximum for each unit and type of number, and the bound of each joint, with the range where it
/// holds; or the reason why there is none.
fn error(accuracy: &Accuracy) -> Value {
    let (of, bounds) = match accuracy {
        Accuracy::Unknown(reason) => return json!({ "unknown": reason }),
        Accuracy::Within(bounds) => ("results", bounds),
        Accuracy::BesideDiagonal(bounds) => ("diagonal", bounds),
        Accuracy::Backward(Perturbed::Torques, bounds) => ("tau", bounds),
        Accuracy::Backward(Perturbed::MassMatrix, bounds) => ("M", bounds),
        Accuracy::Backward(Perturbed::UnitForces, bounds) => ("unit forces", bounds),
        Accuracy::Backward(Perturbed::TorqueDerivatives, bounds) => ("tau derivatives", bounds),
    };
    let by_unit = |of: fn(&Bound) -> Option<f64>| {
        let mut worst: Map<String, Value> = Map::new();
        for bound in &bounds.bounds {
            let found = of(bound);
            let before = worst.get(bound.unit).and_then(Value::as_f64);
            let most = found.map(|found| before.map_or(found, |before| before.max(found)));
            worst.insert(bound.unit.to_owned(), json!(most));
        }
        worst
    };
    let of_joint = |bound: &Bound| {
        let (joint, unit) = (&bound.joint, bound.unit);
        json!({ "joint": joint, "unit": unit, "f64": bound.double, "f32": bound.single })
    };
    json!({
        "of": of,
        "f64": by_unit(|bound| bound.double),
        "f32": by_unit(|bound| bound.single),
        "joints": bounds.bounds.iter().map(of_joint).collect::<Vec<_>>(),
        "range": bounds.range,
        "lacks": bounds.lacks,
    })
}
