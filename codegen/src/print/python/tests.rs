//! Packages of hand-made modules, as users of the command see them.

use quote::format_ident;

use super::{Package, PackageOptions, print};
use crate::function::Function;
use crate::module::Module;
use crate::print::rust::Item;
use crate::print::rust::tests::{generated, literal, module, revolute, with_payload};
use crate::real::Real;
use crate::schedule::Program;

const WRITING: PackageOptions<'_> = PackageOptions {
    module: "arm_py",
    asked: "f64",
};

fn written(module: &Module) -> Package {
    print(module, &Item::named_after(&module.about.robot), &WRITING)
}

fn file<'p>(package: &'p Package, path: &str) -> &'p str {
    let mut files = package.files.iter();
    let found = files.find(|(other, _)| other == path);
    &found.unwrap_or_else(|| panic!("{path} is written")).1
}

/// A program whose results are all zero.
fn zeros(functions: &[Function], count: usize) -> Program {
    let mut program = generated(functions, module(Real::F64).functions.remove(0).program).program;
    program.results = vec![literal(0.0); count];
    program
}

#[test]
fn a_class_with_a_function() {
    let package = written(&module(Real::F64));
    assert_eq!(package.class, "DoublePendulum");
    let class = file(&package, "src/lib.rs");
    let method = "    #[pyo3(signature = (q, *, out = None))]
    fn gravity<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let states = States::of(py, [(\"q\", q, &[2])])?;
        let mut gravity = states.room(py, &[2], out)?;
        let work = functions::gravity {
            robot: &self.robot,
            states: states.count(),
            q: states.argument(0)?,
            gravity: gravity.numbers()?,
        };
        run(py, work);
        gravity.into_python()
    }
";
    assert!(class.contains(method), "{class}");
    let functions = file(&package, "src/functions.rs");
    assert!(
        functions.ends_with(
            "    crate::robot::DoublePendulum:\n    gravity(q: 2) -> (gravity: 2);\n}\n"
        ),
        "{functions}"
    );
    let robot = file(&package, "src/robot.rs");
    let computed = "    #[inline(always)]
    pub fn gravity<T: crate::number::Number>(&self, q: &[T; 2]) -> ([T; 2],) {
        let k = |number| crate::number::Number::like(q[0], number);
        let [q_1, q_2] = *q;
        let q_1_2 = q_1 + q_2;
        let ([_, _], [c_1, c_1_2]) = crate::number::Number::sin_cos_all([q_1, q_1_2]);
        let d_2 = k(0.5) * k(2.4525) * c_1_2;
        let d_1 = k(9.81) * c_1 + d_2;
        ([d_1, d_2],)
    }
";
    assert!(robot.contains(computed), "{robot}");
}

#[test]
fn a_stub_documents_shapes_and_units() {
    let package = written(&module(Real::F32));
    let stub = file(&package, "python/arm_py/__init__.pyi");
    let method = "    def gravity(self, q: _ArrayLike, *, out: _NDArray[_np.float32] | None = None) -> _NDArray[_np.float32]:
        \"\"\"Joint torques and forces τ that hold the robot at rest against gravity; N m, N.

        Shapes: q (..., 2).
        Returns (..., 2).

        q in rad or m.
";
    assert!(stub.contains(method), "{stub}");
    assert!(file(&package, "src/real.rs").contains("pub type Real = f32;"));
    assert!(file(&package, "src/real.rs").contains("pub fn sin_cos(angle: f32)"));
}

#[test]
fn fields_are_arguments_of_the_class() {
    let package = written(&with_payload(module(Real::F64)));
    let class = file(&package, "src/lib.rs");
    assert!(
        class.contains(
            "    #[pyo3(signature = (payload))]
    fn new(payload: f64) -> Self {
        Self {
            robot: robot::DoublePendulum {
                payload: payload,
            },
        }
    }
"
        ),
        "{class}"
    );
    let robot = file(&package, "src/robot.rs");
    assert!(robot.contains("pub payload: f64,"), "{robot}");
    assert!(robot.contains("let payload = k(self.payload);"), "{robot}");
    let stub = file(&package, "python/arm_py/__init__.pyi");
    assert!(
        stub.contains("def __init__(self, payload: float) -> None: ..."),
        "{stub}"
    );
}

#[test]
fn a_field_with_the_name_of_a_method_is_renamed() {
    let mut module = with_payload(module(Real::F64));
    module.parameters[0].field = format_ident!("gravity");
    let stub = written(&module);
    let stub = file(&stub, "python/arm_py/__init__.pyi");
    assert!(
        stub.contains("def __init__(self, gravity_: float)"),
        "{stub}"
    );
}

#[test]
fn several_results_are_a_named_tuple() {
    let functions = [Function::InverseDynamicsDerivatives, Function::MassMatrix];
    let alone = [Function::InverseDynamicsDerivatives];
    let mut module = module(Real::F64);
    module.about.robot = "inverse dynamics derivatives".to_owned();
    module.functions = vec![
        generated(&alone, zeros(&alone, 8)),
        generated(&functions, zeros(&functions, 12)),
    ];
    let package = written(&module);
    assert_eq!(package.class, "InverseDynamicsDerivatives");
    let stub = file(&package, "python/arm_py/__init__.pyi");
    for part in [
        "class InverseDynamicsDerivatives_(_NamedTuple):",
        "    dqd: _NDArray[_np.float64]\n",
        "class InverseDynamicsDerivativesAndMassMatrix(_NamedTuple):",
        "    inverse_dynamics_derivatives_dqd: _NDArray[_np.float64]\n    mass_matrix: ",
        "(self, q: _ArrayLike, qd: _ArrayLike, qdd: _ArrayLike) -> InverseDynamicsDerivatives_:",
    ] {
        assert!(stub.contains(part), "{part}: {stub}");
    }
    let class = file(&package, "src/lib.rs");
    assert!(
        class.contains(".import(py, \"arm_py\", \"InverseDynamicsDerivativesAndMassMatrix\")"),
        "{class}"
    );
}

#[test]
fn a_pose_has_four_rows() {
    let functions = [Function::ForwardKinematics];
    let mut module = module(Real::F64);
    module.functions = vec![generated(&functions, zeros(&functions, 12))];
    let package = written(&module);
    let functions = file(&package, "src/functions.rs");
    assert!(
        functions.contains("(forward_kinematics: 16);"),
        "{functions}"
    );
    let robot = file(&package, "src/robot.rs");
    assert!(
        robot.contains("crate::number::Number::like(q[0], 1.0),\n            ],\n"),
        "{robot}"
    );
}

#[test]
fn nothing_of_a_description_is_code() {
    let mut module = module(Real::F64);
    module.about.robot = "None".to_owned();
    module.about.tip = "\"\"\"\nimport os #\u{202e}\\".to_owned();
    module.about.facts = vec!["\"\"\" + evil() + r\"\"\"\\".to_owned()];
    module.spaces = revolute(["\"\"\"; import os #", "'''\\\n\u{202e}{}"].map(str::to_owned));
    let package = written(&module);
    assert_eq!(package.class, "None_");
    for (path, text) in &package.files {
        assert!(!text.contains('\u{202e}'), "{path}");
        if path.starts_with("python/") {
            // All quotes of the description are escaped, and so are backslashes.
            let without = text.replace("\\\\", "").replace("\\\"", "");
            assert_eq!(without.matches("\"\"\"").count() % 2, 0, "{text}");
            assert!(!without.contains('\\'), "{text}");
            assert!(!text.contains("\nimport os"), "{text}");
        }
    }
}
