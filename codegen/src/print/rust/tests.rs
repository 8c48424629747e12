//! Text of hand-made modules, as users of the crate see it.

use proc_macro2::TokenStream;
use quote::format_ident;

use super::{Declaration, FormattedSource, Item, Library, print, stub};
use crate::accuracy::{Accuracy, Bound, ErrorBounds};
use crate::description::Name;
use crate::expression::{Block, Component, Input, LabelledBodies, Numeral};
use crate::formulation::Sines;
use crate::function::Function;
use crate::layout::Layout;
use crate::module::{About, ChainData, DataMotion, GeneratedFunction, LoopsData, Module};
use crate::real::Real;
use crate::request::{Parameter, Request, Target};
use crate::schedule::{Length, Operand, Operation, OperationCount, Program, Step};
use crate::space::{Entry, Kind, Spaces, Variable};

mod batch;
mod core;
mod long;

const Q: [Operand; 2] = [
    Operand::Input(Input::Variable(Variable::Q, 0)),
    Operand::Input(Input::Variable(Variable::Q, 1)),
];

/// A step, labelled as the pivot with this number if there is one.
pub(crate) fn step(pivot: Option<usize>, operation: Operation) -> Step {
    let label = pivot.map(|k| {
        Block::Pivot
            .of(LabelledBodies::Body(Numeral(k)))
            .entry(Component::Scalar)
    });
    Step { label, operation }
}

pub(crate) fn literal(value: f64) -> Operand {
    Operand::Literal(value)
}

fn name(text: &str) -> Name {
    Name {
        text: text.to_owned(),
        ..Name::default()
    }
}

/// Two links in a vertical plane; the mass of the second one, or of its payload, is `mass`.
fn gravity(mass: Operand) -> Program {
    Program {
        angles: vec![Q[0], Operand::Step(0)],
        before_angles: 1,
        steps: vec![
            step(None, Operation::Add(Q[0], Q[1])),
            step(None, Operation::Mul(mass, literal(2.4525))),
            step(Some(2), Operation::Mul(Operand::Step(1), Operand::Cos(1))),
            step(
                Some(1),
                Operation::MulAdd(literal(9.81), Operand::Cos(0), Operand::Step(2)),
            ),
        ],
        results: vec![Operand::Step(3), Operand::Step(2)],
        ..Program::default()
    }
}

pub(crate) fn generated(functions: &[Function], program: Program) -> GeneratedFunction {
    let operation_count = OperationCount::of(&program).beside_dense(384, 288);
    GeneratedFunction {
        functions: functions.to_vec(),
        frame: None,
        layout: Layout::DESCRIBED,
        program,
        operation_count,
        accuracy: vec![Accuracy::Within(ErrorBounds {
            bounds: vec![Bound {
                joint: None,
                unit: "N m",
                double: Some(3.4e-15),
                single: Some(1.8e-6),
            }],
            range: "q within its limits".to_owned(),
            lacks: None,
        })],
        found: None,
    }
}

fn constant(results: &[f64]) -> Program {
    Program {
        angles: Vec::new(),
        before_angles: 0,
        steps: Vec::new(),
        results: results.iter().map(|value| literal(*value)).collect(),
        ..Program::default()
    }
}

/// Spaces of revolute joints with these names.
pub(crate) fn revolute(names: impl IntoIterator<Item = String>) -> Spaces {
    let entry = |name| Entry {
        name,
        kind: Kind::Rotation,
        range: None,
    };
    let entries: Vec<Entry> = names.into_iter().map(entry).collect();
    Spaces {
        actions: Vec::new(),
        coordinates: entries.clone().into(),
        constraints: Vec::new(),
        velocities: entries.into(),
        ..Spaces::default()
    }
}

/// The arm, its gravity torques, and its data.
pub(crate) fn module(scalar: Real) -> Module {
    let identity = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let axis = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let inertia = [0.0833, 0.0, 0.0, 0.0, 0.0, 0.0, 0.25, 0.0, 0.0, 0.5];
    let joint = [&identity[..], &axis[..], &inertia[..]].concat();
    let data = [
        &joint[..],
        &joint[..],
        &identity[..],
        &[0.0, -9.81, 0.0][..],
    ]
    .concat();
    Module {
        spaces: revolute(["shoulder", "elbow"].map(str::to_owned)),
        about: About {
            actuated: false,
            robot: "double pendulum".to_owned(),
            source: crate::description::Source {
                file: Some("pendulum.urdf".to_owned()),
                hash: 0x00c0_ffee,
                ..crate::description::Source::default()
            },
            base: "world".to_owned(),
            tip: "rod-2".to_owned(),
            facts: vec![
                "1 link merged".to_owned(),
                "gravity only along −y".to_owned(),
            ],
            formulation: Vec::new(),
            ..About::default()
        },
        functions: vec![generated(&[Function::Gravity], gravity(literal(0.5)))],
        efforts: vec![f64::INFINITY; 2],
        radii: Vec::new(),
        configurations: Vec::new(),
        data: ChainData {
            names: vec!["shoulder".to_owned(), "elbow".to_owned()],
            parents: vec![None, Some(0)],
            motions: vec![DataMotion::Along; 2],
            frames: vec![("rod-2".to_owned(), Some(1))],
            external: (0, false),
            actuated: Vec::new(),
            program: constant(&data),
            loops: LoopsData {
                loops: Vec::new(),
                actuated: Vec::new(),
                program: constant(&[]),
            },
        },
        base_values: Vec::new(),
        batch: false,
        length: Length::default(),
        scalar,
        reproducible: false,
        sines: Sines::default(),
        parameters: Vec::new(),
        prepared: None,
        review: None,
    }
}

fn pendulum() -> Item {
    Item {
        declaration: Declaration::Exists,
        ..made()
    }
}

fn made() -> Item {
    Item::made(format_ident!("Pendulum"))
}

/// Output for a crate with the runtime.
fn with_runtime(module: &Module) -> String {
    pretty(&print(module, &pendulum(), &Library::default()))
}

fn pretty(tokens: &TokenStream) -> String {
    FormattedSource::new("", tokens).to_string()
}

/// The module with the mass of the second rod as a field.
pub(crate) fn with_payload(mut module: Module) -> Module {
    let payload = Operand::Input(Input::Parameter(0, 0));
    module.functions = vec![generated(&[Function::Gravity], gravity(payload))];
    module.parameters = vec![Parameter {
        field: format_ident!("payload"),
        target: Target::MassOf(name("rod-2")),
        range: None,
    }];
    module
}

/// Text of the method or function `name`, without its doc comment and attributes.
fn function<'a>(text: &'a str, name: &str) -> &'a str {
    let start = text
        .find(&format!("fn {name}"))
        .expect("the function is there");
    let length = text[start..].find("\n    }\n").expect("it ends");
    &text[start..start + length]
}

#[test]
fn the_methods_of_a_struct_that_exists() {
    let text = with_runtime(&module(Real::Generic));
    let start = r#"#[allow(
    clippy::approx_constant,
    clippy::inline_always,
    clippy::large_stack_arrays,
    clippy::possible_missing_comma,
    clippy::similar_names,
    clippy::too_many_arguments,
    clippy::too_many_lines,
    clippy::trivially_copy_pass_by_ref,
    clippy::unreadable_literal,
    clippy::unused_self,
    reason = "generated code has one form for every robot"
)]
impl Pendulum {
    /// Joint torques and forces τ that hold the robot at rest against gravity; N m, N.
    ///
    /// q in rad or m.
    /// Robot `double pendulum` from `pendulum.urdf` (FNV-1a 0000000000c0ffee); q: `shoulder`, `elbow`.
    /// Modelled: 1 link merged; gravity only along −y.
    ///
    /// 3 mul, 2 add, 0 div, 2 sin and cos; depth 4; dense 4×4 products: 384 mul, 288 add.
    /// Error: at most 3.4e-15 N m in f64, 1.8e-6 N m in f32; q within its limits.
    #[must_use]
    pub fn gravity<T: ::homogen::Scalar>(&self, q: &[T; 2]) -> [T; 2] {
        /// Compiled for several kinds of processor, one of which is chosen at run time.
        struct Equations<A>(A);
        impl<T: ::homogen::Scalar> ::homogen::dispatch::Work<T> for Equations<&[T; 2]> {
            type Output = [T; 2];
            #[inline(always)]
            fn run<R: ::homogen::rounding::Rounding>(self) -> [T; 2] {
                let Self(q) = self;
                let k = <T as ::homogen::Scalar>::constant;
                let mul_add = R::mul_add::<T>;
                let [q_1, q_2] = *q;
                let q_1_2 = q_1 + q_2;
                let ([_, _], [c_1, c_1_2]) = R::sin_cos_all([q_1, q_1_2]);
                let d_2 = k(0.5) * k(2.4525) * c_1_2;
                let d_1 = mul_add(k(9.81), c_1, d_2);
                [d_1, d_2]
            }
        }
        <T as ::homogen::Scalar>::dispatch(Equations(q))
    }
"#;
    assert!(text.contains(start), "{text}");
    let end = r"
#[automatically_derived]
impl<T: ::homogen::Scalar> ::homogen::robot::Gravity<2, T> for Pendulum {
    #[inline]
    fn gravity(&self, q: &[T; 2]) -> [T; 2] {
        Self::gravity(self, q)
    }
}

#[automatically_derived]
impl ::homogen::robot::Batched for Pendulum {}
";
    assert!(text.ends_with(end), "{text}");
}

#[test]
fn the_robot_as_data() {
    let text = with_runtime(&module(Real::F32));
    let chain = function(&text, "chain");
    assert!(
        chain.starts_with("fn chain() -> ::homogen::Chain<2, 1> {"),
        "{chain}"
    );
    let elbow = r#"
                ::homogen::Joint::new(
                    "elbow",
                    ::core::option::Option::Some(0),
                    ::homogen::Pose::new(
                        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                        [0.0, 0.0, 0.0],
                    ),
                    ::homogen::Screw::new([0.0, 0.0, 1.0], [0.0, 0.0, 0.0]),
                    ::homogen::Inertia::new(
                        [0.0833, 0.0, 0.0, 0.0, 0.0, 0.0],
                        [0.25, 0.0, 0.0],
                        0.5,
                    ),
                ),
            ],"#;
    assert!(chain.contains(elbow), "{chain}");
    assert!(chain.ends_with("[0.0, -9.81, 0.0],\n        )"), "{chain}");
}

#[test]
fn a_field_is_converted_whatever_its_type() {
    let load = |real| {
        let text = with_runtime(&with_payload(module(real)));
        let statements = function(&text, "gravity").to_owned();
        let start = statements.find("let payload").expect("the field is read");
        let end = statements
            .find("let q_1_2")
            .expect("the sum comes after it");
        let statement = statements[start..end].split_whitespace();
        statement
            .collect::<String>()
            .replace(",)", ")")
            .replace(",>", ">")
    };
    let double = "<::core::primitive::f64as::core::convert::From<_>>::from(robot.payload)";
    assert_eq!(load(Real::Generic), format!("letpayload=k({double});"));
    assert_eq!(load(Real::F64), format!("letpayload={double};"));
    let single = "<::core::primitive::f32as::homogen::Scalar>::constant";
    assert_eq!(load(Real::F32), format!("letpayload={single}({double});"));
}

#[test]
fn reproducible_equations_are_so_by_a_constant() {
    let reproducible = "const REPRODUCIBLE: ::core::primitive::bool = true;";
    let plain = with_runtime(&module(Real::Generic));
    assert!(!plain.contains(reproducible), "{plain}");
    let text = with_runtime(&Module {
        reproducible: true,
        ..module(Real::Generic)
    });
    let line = format!("            {reproducible}\n");
    assert!(text.contains(&line), "{text}");
    assert_eq!(text.replace(&line, ""), plain);
}

#[test]
fn several_functions_are_a_tuple_and_have_no_trait() {
    let mut module = module(Real::F64);
    let together = [Function::MassMatrix, Function::Gravity];
    module.functions = vec![generated(
        &together,
        constant(&[1.0, 0.5, 0.5, 0.25, 0.0, 0.0]),
    )];
    let text = with_runtime(&module);
    let body = function(&text, "mass_matrix_and_gravity");
    // Constant results gain nothing by a choice of the processor.
    let end = "let _ = q;\n        ([[1.0_f64, 0.5_f64], [0.5_f64, 0.25_f64]], [0.0_f64, 0.0_f64])";
    assert!(body.ends_with(end), "{body}");
    let traits: Vec<_> = text.split("::homogen::robot::").skip(1).collect();
    let is_of_batches = |of: &&str| of.starts_with("Batched for");
    assert!(traits.iter().all(is_of_batches), "{text}");
}

#[test]
fn further_frames_have_methods() {
    let mut module = module(Real::F64);
    module.functions = ["hand-eye", "hand eye"]
        .map(|frame| GeneratedFunction {
            frame: Some(frame.to_owned()),
            ..generated(&[Function::TipVelocity], constant(&[0.0; 6]))
        })
        .to_vec();
    let text = with_runtime(&module);
    let body = function(&text, "velocity_of_hand_eye(");
    assert!(body.contains("::homogen::Velocity::new("), "{body}");
    function(&text, "velocity_of_hand_eye_(");
    let traits: Vec<_> = text.split("::homogen::robot::").skip(1).collect();
    let is_of_batches = |of: &&str| of.starts_with("Batched for");
    assert!(traits.iter().all(is_of_batches), "{text}");
}

#[test]
fn a_stub_has_the_requested_signatures() {
    let item = pendulum();
    let request = Request {
        functions: vec![
            vec![Function::Gravity],
            vec![Function::MassMatrix, Function::Bias],
        ],
        frames: vec![name("eye")],
        ..Request::default()
    };
    let text = |spaces: Option<&Spaces>| {
        let text = pretty(&stub(&item, &request, spaces));
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let unknown = text(None);
    for signature in [
        "pub fn gravity<T: ::homogen::Scalar, const N: ::core::primitive::usize>",
        "( &self, q: &[T; N], qd: &[T; N], ) -> ([[T; N]; N], [T; N]) { ::core::unreachable!() }",
        "pub const fn chain<const N: ::core::primitive::usize>() -> ::homogen::Chain<N, 2> {",
        "::homogen::robot::Gravity<N, T> for Pendulum {",
    ] {
        assert!(unknown.contains(signature), "{unknown}");
    }
    let two = revolute(["one", "other"].map(str::to_owned));
    let known = text(Some(&two));
    assert!(
        known.contains("const fn chain() -> ::homogen::Chain<2, 2>"),
        "{known}"
    );
}
