//! Wrong edits, and the test that must notice each.
//!
//! A mutation replaces a text that occurs exactly once in its file; a test of this file checks that.

mod names;
mod paper;

use std::fmt;

/// A wrong edit.
pub struct Mutation {
    /// A description of the edit.
    pub name: &'static str,
    /// The file, from the root of the repository.
    pub file: &'static str,
    from: &'static str,
    to: &'static str,
    /// The test that must fail.
    pub noticed_by: Test,
}

/// A test of a package.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Test {
    /// Its package.
    pub package: &'static str,
    /// Its target in the package, as arguments of cargo.
    pub target: &'static [&'static str],
    /// Its path.
    pub name: &'static str,
}

const ENGINE: &[&str] = &["--lib"];
const ACCURACY: &[&str] = &["--test", "accuracy"];

/// All mutations.
pub fn all() -> impl Iterator<Item = &'static Mutation> {
    let others = names::NAMES.iter().chain(paper::EQUATIONS);
    MUTATIONS.iter().chain(others)
}

/// Mutations of the engine and of the runtime's geometry, grouped by the crate that is built again.
const MUTATIONS: [Mutation; 48] = [
    Mutation {
        name: "Newton-Euler: ω × u q̇ with the other sign",
        file: "codegen/src/model/newton_euler.rs",
        from: "u * second + base.cross(angular)",
        to: "u * second - base.cross(angular)",
        noticed_by: engine(OBLIQUE),
    },
    Mutation {
        name: "Newton-Euler: ω × v left out, on a joint with several velocities",
        file: "codegen/src/model/newton_euler.rs",
        from: "let coriolis = angular.cross(outer.relative) + before.cross(linear);",
        to: "let coriolis = before.cross(linear);",
        noticed_by: engine(KINDS),
    },
    Mutation {
        name: "mimic joints: a torque without its factor",
        file: "codegen/src/model/velocities.rs",
        from: "let term = state.times_factor(k, term);",
        to: "",
        noticed_by: engine(KINDS),
    },
    Mutation {
        name: "mimic joints: the fill-in of the mass matrix's factors left out",
        file: "codegen/src/model/velocities.rs",
        from: "before[parent].extend(row);",
        to: "",
        noticed_by: engine(FOLLOWERS),
    },
    Mutation {
        name: "quaternions: the inverse rotation",
        file: "codegen/src/joint/manifold.rs",
        from: "let (wx, wy, wz) = (twice_x * w, twice_y * w, twice_z * w);",
        to: "let (wx, wy, wz) = (-twice_x * w, -twice_y * w, -twice_z * w);",
        noticed_by: engine(KINDS),
    },
    Mutation {
        name: "Newton-Euler: gravity with the other sign",
        file: "codegen/src/model/newton_euler.rs",
        from: "Acceleration::linear(-gravity)",
        to: "Acceleration::linear(gravity)",
        noticed_by: engine(OBLIQUE),
    },
    Mutation {
        name: "frames: a vector carried inboard by the transpose",
        file: "codegen/src/model/carry.rs",
        from: "self.placement.rotation * (self.turn() * vector)",
        to: "self.placement.rotation.transposed() * (self.turn() * vector)",
        noticed_by: engine(OBLIQUE),
    },
    Mutation {
        name: "inertia: the term of parallel axes dropped",
        file: "codegen/src/matrix/inertia.rs",
        from: "Symmetric::product(t, self.q + shifted * half)",
        to: "Symmetric::product(t, self.q + shifted * (half - half))",
        noticed_by: engine(OBLIQUE),
    },
    Mutation {
        name: "regrouping: the regrouped inertia added to its body, not subtracted",
        file: "codegen/src/layout/regroup.rs",
        from: "body.inertia - passes",
        to: "body.inertia + passes",
        noticed_by: engine(OBLIQUE),
    },
    Mutation {
        name: "factors: an entry of the diagonal not reduced",
        file: "codegen/src/model/factor.rs",
        from: "&inboard[k][nearest..]",
        to: "&inboard[k][nearest + 1..]",
        noticed_by: engine(OBLIQUE),
    },
    Mutation {
        name: "forward dynamics: a refinement left out",
        file: "codegen/src/model/forward_dynamics.rs",
        from: "for _ in 0..=refinements {\n        let needed",
        to: "for _ in 0..refinements.max(1) {\n        let needed",
        noticed_by: engine(
            "plan::forward::tests::a_refinement_restores_the_digits_that_the_mass_matrix_lost",
        ),
    },
    Mutation {
        name: "fusing: a cross product fused on one side",
        file: "codegen/src/schedule/fuse.rs",
        from: "free(a) && free(b)",
        to: "free(a) && free(b) && a == b",
        noticed_by: engine(
            "schedule::fuse::tests::a_difference_of_products_that_can_cancel_is_not_fused",
        ),
    },
    Mutation {
        name: "layout: a child's placement moved the wrong way",
        file: "codegen/src/layout/bodies.rs",
        from: "child.placement = from * child.placement",
        to: "child.placement = to * child.placement",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "layout: an offset of the angle added to the placement, not subtracted",
        file: "codegen/src/layout/frames.rs",
        from: "rotation * Rotation::about_z((-sine, cosine))",
        to: "rotation * Rotation::about_z((sine, cosine))",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "layout: the axis of a joint reversed",
        file: "codegen/src/matrix/pose.rs",
        from: "let last = if size(k) > 0.0 { last } else { -last };",
        to: "let last = if size(k) > 0.0 { -last } else { last };",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "layout: a body's inertia moved the wrong way",
        file: "codegen/src/layout/bodies.rs",
        from: "body.inertia = body.inertia.change_frame(from);",
        to: "body.inertia = body.inertia.change_frame(to);",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "body Jacobian: the pose of the end effector not inverted",
        file: "codegen/src/model/jacobian.rs",
        from: "let mut pose = path.end.inverse();",
        to: "let mut pose = path.end;",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "pose: the third column with the other sign",
        file: "codegen/src/model/pose.rs",
        from: "columns[(k + 1) % 3].cross(columns[(k + 2) % 3])",
        to: "columns[(k + 2) % 3].cross(columns[(k + 1) % 3])",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "regrouping: mass beside the axis moved inboard",
        file: "codegen/src/joint/motion.rs",
        from: "Symmetric([zero, zero, zz, zero, zero, zero])",
        to: "Symmetric([zz, zero, zero, zero, zero, zero])",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "merging: a locked joint without its displacement",
        file: "codegen/src/chain/merge/links.rs",
        from: "pose: pose * held_at(graph, joint.kind, axes, reader.number(&held)),",
        to: "pose,",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "merging: the inertia of a fixed link not moved to its parent's frame",
        file: "codegen/src/chain/merge/links.rs",
        from: "bodies[body].inertia + inertia.change_frame(attachment.pose)",
        to: "bodies[body].inertia + inertia",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "gravity: the moment with the other sign",
        file: "codegen/src/model/gravity.rs",
        from: "moments[k].cross(a)",
        to: "a.cross(moments[k])",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "jacobian: the reference point on the other side",
        file: "codegen/src/model/carry.rs",
        from: "pose.translation = -between;",
        to: "pose.translation = between;",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "mass matrix: an entry left out of the lower half",
        file: "codegen/src/model/composite.rs",
        from: "entries.set_both((at, column), entry);",
        to: "entries[(at, column)] = entry;",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "inertia: a planar rotation with a wrong sign",
        file: "codegen/src/matrix/inertia.rs",
        from: "cosine * w - xy,",
        to: "cosine * w + xy,",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "rule pythagoras: cos² x − sin² x = 1",
        file: "codegen/src/simplify/rules.rs",
        from: "if x == y && !sum.minus",
        to: "if x == y && sum.minus",
        noticed_by: engine("simplify::rules::tests::pythagoras"),
    },
    Mutation {
        name: "rule cancel: the sign of what is left",
        file: "codegen/src/simplify/rules.rs",
        from: "if minus == y_minus { y } else { -y }",
        to: "if minus == y_minus { -y } else { y }",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "rule gather_constants: k − (l + x) = (k − l) + x",
        file: "codegen/src/simplify/rules.rs",
        from: "(true, true) => (constant - number) - signed",
        to: "(true, true) => (constant - number) + signed",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "rule common_factor: a b − a c = a (c − b)",
        file: "codegen/src/simplify/rules.rs",
        from: "common * sum.of(left, right)",
        to: "common * sum.of(right, left)",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "multiples: k x − l x = (l − k) x",
        file: "codegen/src/expression/graph.rs",
        from: "let factor = self.difference(k, l);",
        to: "let factor = self.difference(l, k);",
        noticed_by: engine(
            "expression::graph::tests::multiples_of_one_expression_are_collected_whatever_else_uses_them",
        ),
    },
    Mutation {
        name: "fusing: a product subtracted on the wrong side",
        file: "codegen/src/schedule/fuse.rs",
        from: "[FusedForm::Minus, FusedForm::From]",
        to: "[FusedForm::From, FusedForm::Minus]",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "signs: a sum of two negated terms not negated",
        file: "codegen/src/schedule/signs.rs",
        from: "if a == b => Some(a)",
        to: "if a == b => Some(!a)",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "schedule: the operands of a difference exchanged",
        file: "codegen/src/schedule/order.rs",
        from: "(true, _) => Operation::Sub(b, a)",
        to: "(true, _) => Operation::Sub(a, b)",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "schedule: a fused difference as a sum",
        file: "codegen/src/schedule/order.rs",
        from: "(false, true) => Operation::MulSub(x, y, rest)",
        to: "(false, true) => Operation::MulAdd(x, y, rest)",
        noticed_by: engine(CHECKED),
    },
    Mutation {
        name: "columns: a value taken without its sign",
        file: "codegen/src/schedule/order.rs",
        from: "Node::Taken(a, _) => return self.positive(a)",
        to: "Node::Taken(a, _) => return self.at(a)",
        noticed_by: engine("model::alike::tests::other_columns_are_unchanged"),
    },
    Mutation {
        name: "columns: an iteration that reads another",
        file: "codegen/src/schedule/repeats.rs",
        from: "own(one).map(|step| step + behind) == own(other)",
        to: "own(one).is_some() == own(other).is_some()",
        noticed_by: engine("schedule::repeats::tests::an_iteration_that_reads_another_is_rejected"),
    },
    Mutation {
        name: "columns: a result read from the row of another",
        file: "codegen/src/schedule/routine/loops.rs",
        from: "let row = row.unwrap_or_default();",
        to: "let row = row.map_or(0, |row| row ^ 1);",
        noticed_by: engine(
            "schedule::routine::loops::tests::loops_over_columns_compute_the_same_as_all_steps",
        ),
    },
    Mutation {
        name: "sine: the last digits of a coefficient",
        file: "runtime/src/scalar/trigonometry/double.rs",
        from: "-0.166_666_666_666_666_3",
        to: "-0.166_666_666_666_664",
        noticed_by: Test {
            package: "homogen-tests",
            target: ACCURACY,
            name: "trigonometry::double_precision_is_within_its_limit_at_random_angles",
        },
    },
    Mutation {
        name: "C: the operands of a fused difference exchanged",
        file: "codegen/src/print/expression.rs",
        from: "c.infix(Infix::Sub, &product)",
        to: "product.infix(Infix::Sub, &c)",
        noticed_by: c99("c99::scara"),
    },
    Mutation {
        name: "expressions: no parentheses around what is subtracted",
        file: "codegen/src/print/expression.rs",
        from: "[operand(a, Binding::Sum), operand(b, Binding::Product)]",
        to: "[operand(a, Binding::Sum), operand(b, Binding::Sum)]",
        noticed_by: engine("print::expression::tests::an_expression_is_read_as_it_was_written"),
    },
    Mutation {
        name: "expressions: a value computed behind a later statement",
        file: "codegen/src/schedule/inlined.rs",
        from: "if waiting.iter().any(is_part) {",
        to: "if waiting.is_empty() {",
        noticed_by: engine("schedule::inlined::tests::statements_hold_consecutive_steps"),
    },
    Mutation {
        name: "C: the last digit of a coefficient of the sine",
        file: "codegen/src/print/sines.rs",
        from: "-0.166_666_666_666_666_3,",
        to: "-0.166_666_666_666_666_2,",
        noticed_by: c99("c99::two_link"),
    },
    Mutation {
        name: "exponential: 1 − cos φ by subtraction",
        file: "runtime/src/matrix/screw.rs",
        from: "let versine = T::constant(2.0) * half_sine * half_sine;",
        to: "let versine = one - phi.sin_cos().1 + (half_sine - half_sine);",
        noticed_by: geometry("hard_cases_geometry::exponential::versine_small"),
    },
    Mutation {
        name: "logarithm: the angle by the arc cosine",
        file: "runtime/src/matrix/rotation.rs",
        from: "T::constant(2.0) * self.sine.atan2(self.cosine)",
        // acos w is the angle of the point (w, √(1 − w²)).
        to: "{
            let w = self.cosine / norm([self.sine, self.cosine]);
            T::constant(2.0) * (T::constant(1.0) - w * w).abs().sqrt().atan2(w)
        }",
        noticed_by: geometry("hard_cases_geometry::logarithm::log_tiny"),
    },
    Mutation {
        name: "logarithm: the formula near 0 used near π",
        file: "runtime/src/matrix/rotation.rs",
        from: "if trace >= xx && trace >= yy && trace >= zz {",
        to: "if trace >= -one {",
        noticed_by: geometry("hard_cases_geometry::logarithm::log_near_pi"),
    },
    Mutation {
        name: "loops: residuals that are rounding errors are kept",
        file: "codegen/src/expand/closure.rs",
        from: "const LEAST: f64 = 1.0 / 1024.0;",
        to: "const LEAST: f64 = 0.0;",
        noticed_by: engine(
            "expand::closure::tests::singular::a_four_bar_mounted_askew_keeps_the_residuals_of_its_plane",
        ),
    },
    Mutation {
        name: "loops: a residual not compared with the motion of its body",
        file: "codegen/src/expand/closure/measured.rs",
        from: "rate.abs() / motion.max(LEAST_MOTION * size)",
        to: "rate.abs()",
        noticed_by: engine("expand::closure::tests::singular::small_loops_keep_their_residuals"),
    },
    Mutation {
        name: "loops: γ with the other sign",
        file: "codegen/src/model/constrained.rs",
        from: "-(dot(row, &free) + bias)",
        to: "-(dot(row, &free) - bias)",
        noticed_by: Test {
            package: "homogen-generated",
            target: &["--test", "values"],
            name: "mechanisms::robots_written_with_all_digits_move_as_drawn",
        },
    },
];

/// The test by which the check of an expansion fails, whichever other tests would notice too.
const CHECKED: &str = "check::tests::every_function_of_many_robots_agrees_with_the_description";

const KINDS: &str = "chain::tests::joints::every_type_has_every_function";

const FOLLOWERS: &str =
    "chain::tests::joints::branches_connected_only_by_a_mimic_joint_are_coupled";

const OBLIQUE: &str = "layout::tests::a_tree_of_oblique_axes_has_the_same_torques_in_every_layout";

const fn engine(name: &'static str) -> Test {
    Test {
        package: "homogen-codegen",
        target: ENGINE,
        name,
    }
}

const fn c99(name: &'static str) -> Test {
    Test {
        package: "homogen-generated",
        target: &["--test", "variants"],
        name,
    }
}

const fn geometry(name: &'static str) -> Test {
    Test {
        package: "homogen-tests",
        target: ACCURACY,
        name,
    }
}

impl Mutation {
    /// The text of the file after the edit.
    ///
    /// # Errors
    /// If the text to replace does not occur exactly once.
    pub fn apply(&self, text: &str) -> Result<String, String> {
        match text.matches(self.from).count() {
            1 => Ok(text.replace(self.from, self.to)),
            found => Err(format!(
                "{}: {} has {found} times `{}`",
                self.name, self.file, self.from
            )),
        }
    }
}

impl fmt::Display for Test {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let target = self.target.last().unwrap_or(&"");
        let target = target.trim_start_matches("--");
        write!(out, "{} {target} {}", self.package, self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::all;
    use std::path::Path;

    /// The list cannot fall behind the sources.
    #[test]
    fn every_mutation_applies_to_its_file() {
        for mutation in all() {
            let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
            let text = std::fs::read_to_string(root.join(mutation.file)).expect("a source");
            let broken = mutation
                .apply(&text)
                .unwrap_or_else(|message| panic!("{message}"));
            assert_ne!(broken, text, "{}", mutation.name);
        }
    }
}
