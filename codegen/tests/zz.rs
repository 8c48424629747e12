//! Counts.
use homogen_codegen::Function;
use homogen_codegen::chain;
use homogen_codegen::description;
use homogen_codegen::error::Errors;
use homogen_codegen::plan::{Programs, plan};
use homogen_codegen::request::Request;
use homogen_codegen::space::FrameId;
use std::path::Path;
#[test]
fn counts() {
    for (file, floating) in [
        ("two_link.urdf", false),
        ("ur5_class.urdf", false),
        ("panda_class.urdf", false),
        ("quadruped.urdf", true),
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../robots")
            .join(file);
        let mut errors = Errors::new();
        let d =
            description::read_file(&path, None, &mut errors).unwrap_or_else(|| panic!("{errors}"));
        let chain = chain::build(
            &d,
            &Request {
                floating,
                ..Request::default()
            },
        )
        .unwrap_or_else(|e| panic!("{e}"));
        let programs = Programs::of(&chain);
        for f in [
            Function::InverseDynamics,
            Function::InverseDynamicsDerivatives,
            Function::InverseDynamicsHessian,
        ] {
            let p = plan(&programs, vec![f], FrameId::FIRST).unwrap_or_else(|e| panic!("{e}"));
            println!("{file} {} {:?}", f.name(), p.operation_count);
        }
    }
}
use homogen_codegen::expression::{Expr, Input, Term, along, gradient};
use homogen_codegen::layout::Layout;
use homogen_codegen::list::Id;
use homogen_codegen::model::{Algorithm, coordinate_rates};
use homogen_codegen::plan::expressions_by;
use homogen_codegen::schedule::{OperationCount, schedule};
use homogen_codegen::simplify::simplify;
use homogen_codegen::space::Variable;
#[test]
fn differentiated() {
    for file in ["ur5_class.urdf", "panda_class.urdf"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../robots")
            .join(file);
        let mut errors = Errors::new();
        let d =
            description::read_file(&path, None, &mut errors).unwrap_or_else(|| panic!("{errors}"));
        let chain = chain::build(&d, &Request::default()).unwrap_or_else(|e| panic!("{e}"));
        let mut least = [usize::MAX; 2];
        for layout in Layout::for_dynamics(&chain) {
            for way in 0..2 {
                let f = [
                    Function::InverseDynamics,
                    Function::InverseDynamicsDerivatives,
                ][way];
                let (graph, results) =
                    expressions_by(&chain, &[f], FrameId::FIRST, layout, Algorithm::PLAIN);
                let n = chain.spaces().velocities.len();
                let input = |v: Variable, k: usize| Input::Variable(v, k as u16);
                let mut out: Vec<Expr> = Vec::new();
                let zero = graph.constant(0.0);
                let dir = |results: &[Expr], of: Vec<(Input, Term<'_>)>| -> Vec<Expr> {
                    let m: std::collections::BTreeMap<Input, Expr> =
                        of.into_iter().map(|(i, t)| (i, t.expr())).collect();
                    along(&graph, results, |i| m.get(&i).map(|&e| graph.term(e)))
                        .iter()
                        .map(|t| t.expr())
                        .collect()
                };
                let (gq, gv, ga): (Vec<Expr>, Vec<Expr>, Vec<Expr>);
                if way == 0 {
                    let contraction: Vec<(Expr, Term<'_>)> = results
                        .iter()
                        .enumerate()
                        .map(|(k, &r)| (r, graph.input(input(Variable::Lambda, k))))
                        .collect();
                    let g = gradient(&graph, &contraction);
                    let get = |v: Variable| -> Vec<Expr> {
                        (0..n)
                            .map(|k| g.get(&input(v, k)).copied().unwrap_or(zero).expr())
                            .collect()
                    };
                    (gq, gv, ga) = (get(Variable::Q), get(Variable::Qd), get(Variable::Qdd));
                } else {
                    let sum = |block: usize, col: usize| {
                        let mut s = zero;
                        for i in 0..n {
                            s = s + graph.input(input(Variable::Lambda, i))
                                * graph.term(results[block * n * n + i * n + col]);
                        }
                        s.expr()
                    };
                    gq = (0..n).map(|c| sum(0, c)).collect();
                    gv = (0..n).map(|c| sum(1, c)).collect();
                    ga = vec![];
                }
                // reverse of each gradient entry, or forward: both for way 0
                for v in chain.spaces().velocities.ids() {
                    let rates = coordinate_rates(&graph, &chain, v);
                    let rates: Vec<(Input, Term<'_>)> = rates.into_iter().collect();
                    let all: Vec<Expr> = gq.iter().chain(&gv).chain(&ga).copied().collect();
                    out.extend(dir(&all, rates));
                    out.extend(dir(
                        &gv,
                        vec![(input(Variable::Qd, v.index()), graph.constant(1.0))],
                    ));
                    if way == 1 {
                        out.extend(dir(
                            &gq,
                            vec![(input(Variable::Qdd, v.index()), graph.constant(1.0))],
                        ));
                    }
                }
                let (graph, out) = simplify(&graph, &out);
                let c = OperationCount::of(&schedule(&graph, &out));
                if c.mul + c.add < least[way] {
                    least[way] = c.mul + c.add;
                    println!("{file} way {way} {} {}", c.mul, c.add);
                }
            }
        }
    }
}
