//! Programs that call every function of a robot.
//!
//! In: a robot, a scalar type. Out: `main` in both languages, which reads states from its input and writes the numbers
//! of all results, in the machine's bytes.

use std::fmt::Write;

use homogen_codegen::space::Variable;
use homogen_codegen::{Function, Real};

use crate::c99::robot::{Call, Robot};

/// The program in Rust, beside `arm.rs`.
pub fn rust(robot: &Robot, real: Real) -> String {
    let number = match real {
        Real::F32 => "f32",
        Real::F64 | Real::Generic => "f64",
    };
    let mut text = format!(
        r#"mod arm {{ include!("arm.rs"); }}
        use std::io::{{Read, Write}};
        trait Numbers {{ fn write(&self, bytes: &mut Vec<u8>); }}
        impl Numbers for {number} {{
            fn write(&self, bytes: &mut Vec<u8>) {{ bytes.extend(self.to_ne_bytes()) }}
        }}
        impl<T: Numbers, const N: usize> Numbers for [T; N] {{
            fn write(&self, bytes: &mut Vec<u8>) {{ self.iter().for_each(|one| one.write(bytes)) }}
        }}
        fn main() {{
            let mut input = Vec::new();
            std::io::stdin().read_to_end(&mut input).unwrap();
            let mut output = Vec::new();
            let numbers = input.chunks_exact(std::mem::size_of::<{number}>());
            let numbers = numbers.map(|one| {number}::from_ne_bytes(one.try_into().unwrap()));
            let numbers: Vec<{number}> = numbers.collect();
            for state in numbers.chunks_exact({}) {{
                let mut rest = state.iter().copied();
                let mut next = || rest.next().unwrap();
"#,
        robot.inputs()
    );
    for variable in Variable::ALL {
        let (name, length) = (variable.name(), robot.spaces.len(variable.space()));
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "let {name}: [{number}; {length}] = std::array::from_fn(|_| next());"
        );
    }
    text.push_str("let arm = arm::Arm {");
    for (field, size) in &robot.fields {
        let _ = match size {
            1 => write!(text, "{field}: next(),"),
            _ => write!(text, "{field}: std::array::from_fn(|_| next()),"),
        };
    }
    text.push_str("};\n");
    if robot.calls.iter().any(|call| call.prepared) {
        text.push_str("let prepared = arm.prepare();\n");
    }
    for Call {
        functions,
        name,
        prepared,
    } in &robot.calls
    {
        let arguments = Variable::together(
            functions
                .iter()
                .map(|function| function.arguments().to_vec()),
        );
        let arguments: Vec<_> = arguments
            .iter()
            .map(|of| format!("&{}", of.name()))
            .collect();
        let of = if *prepared { "prepared" } else { "arm" };
        let _ = writeln!(text, "let found = {of}.{name}({});", arguments.join(", "));
        for (place, function) in functions.iter().enumerate() {
            let among = match &**functions {
                [_] => String::new(),
                _ => format!(".{place}"),
            };
            for (part, _) in function.result().parts() {
                let part = part.map_or_else(String::new, |part| format!(".{part}"));
                let _ = writeln!(text, "found{among}{part}.write(&mut output);");
            }
        }
    }
    if robot.has_steps() {
        text.push_str(
            "let moved = arm.integrate(&q, &qd);
            moved.write(&mut output);
            arm.difference(&q, &moved).write(&mut output);
            arm.normalize(&q).write(&mut output);
            arm.neutral().write(&mut output);\n",
        );
    }
    text.push_str("}\nstd::io::stdout().write_all(&output).unwrap();\n}\n");
    text
}

/// The program in C, beside `arm.h` and `arm.c`.
pub fn c(robot: &Robot, real: Real) -> String {
    let number = match real {
        Real::F32 => "float",
        Real::F64 | Real::Generic => "double",
    };
    let mut text = format!(
        "#include <stdio.h>\n#include <string.h>\n#include \"arm.h\"\n\
         int main(void)\n{{\n    {number} state[{}];\n\
         while (fread(state, sizeof state, 1, stdin) == 1) {{\n",
        robot.inputs()
    );
    let mut place = 0;
    for variable in Variable::ALL {
        let name = variable.name();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "const {number} *{name} = state + {place}; (void){name};"
        );
        place += robot.spaces.len(variable.space());
    }
    if !robot.fields.is_empty() {
        // Its members are numbers, in the order of the fields.
        let _ = writeln!(
            text,
            "arm_robot robot; memcpy(&robot, state + {place}, sizeof robot);"
        );
    }
    if robot.calls.iter().any(|call| call.prepared) {
        text.push_str("arm_prepared prepared; arm_prepare(&robot, &prepared);\n");
    }
    for Call {
        functions,
        name,
        prepared,
    } in &robot.calls
    {
        text.push_str("{\n");
        let [first, own] = if *prepared {
            ["&prepared", "prepared_"]
        } else {
            ["&robot", ""]
        };
        let robot_first = (!robot.fields.is_empty()).then(|| first.to_owned());
        let mut passed: Vec<String> = robot_first.into_iter().collect();
        let arguments = Variable::together(
            functions
                .iter()
                .map(|function| function.arguments().to_vec()),
        );
        passed.extend(arguments.iter().map(|of| of.name().to_owned()));
        let results: Vec<(String, String)> = functions
            .iter()
            .flat_map(|function| results(*function, robot))
            .collect();
        for (result, lengths) in &results {
            let _ = writeln!(text, "{number} {result}{lengths};");
            let address = if lengths.is_empty() { "&" } else { "" };
            passed.push(format!("{address}{result}"));
        }
        let _ = writeln!(text, "arm_{own}{name}({});", passed.join(", "));
        for (result, _) in &results {
            let _ = writeln!(text, "fwrite(&{result}, sizeof {result}, 1, stdout);");
        }
        text.push_str("}\n");
    }
    if robot.has_steps() {
        let [coordinates, velocities] =
            [Variable::Q, Variable::Qd].map(|of| robot.spaces.len(of.space()));
        let steps = [
            ("moved", coordinates, "integrate(q, qd, moved)"),
            ("apart", velocities, "difference(q, moved, apart)"),
            ("mended", coordinates, "normalize(q, mended)"),
            ("neutral", coordinates, "neutral(neutral)"),
        ];
        for (result, length, call) in steps {
            let _ = writeln!(
                text,
                "{number} {result}[{length}]; arm_{call}; fwrite({result}, sizeof {result}, 1, stdout);"
            );
        }
    }
    text.push_str("}\nreturn ferror(stdin) || fflush(stdout) != 0;\n}\n");
    text
}

/// The results of a function, each with its lengths: `[2][6]`, or empty for a number.
fn results(function: Function, robot: &Robot) -> Vec<(String, String)> {
    let parts = function.result().parts().map(|(part, quantity)| {
        let lengths = quantity.lengths(&robot.spaces).into_iter();
        let lengths = lengths.chain(quantity.entity.dimensions().iter().copied());
        let name = match part {
            Some(part) => format!("{}_{part}", function.name()),
            None => function.name().to_owned(),
        };
        (
            name,
            lengths.fold(String::new(), |all, length| format!("{all}[{length}]")),
        )
    });
    parts.collect()
}
