//! What is broken, and which test must notice.
//!
//! Each mutation replaces a text that its file has exactly once; a test of this file holds the list
//! to that.

use std::fmt;

/// One thing broken.
pub struct Mutation {
    /// What it is.
    pub name: &'static str,
    /// The file, from the root of the repository.
    pub file: &'static str,
    from: &'static str,
    to: &'static str,
    /// The test that must fail.
    pub noticed_by: Test,
}

/// A test by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Test {
    /// The package that it is in.
    pub package: &'static str,
    /// Which target of the package, as arguments of cargo.
    pub target: &'static [&'static str],
    /// Its path.
    pub name: &'static str,
}

const ENGINE: &[&str] = &["--lib"];
const GEOMETRY: &[&str] = &["--test", "hard_cases_geometry"];

/// All of them, grouped by the crate that is built again.
pub const MUTATIONS: [Mutation; 12] = [
    Mutation {
        name: "Newton-Euler: ω × u q̇ with the other sign",
        file: "codegen/src/model/newton_euler.rs",
        from: "u * second + carried.omega.cross(u * rate)",
        to: "u * second - carried.omega.cross(u * rate)",
        noticed_by: engine(OBLIQUE),
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
        name: "regrouping: what passes the joint is kept as well",
        file: "codegen/src/chain/regroup.rs",
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
        from: "0..=refinements",
        to: "0..refinements.max(1)",
        noticed_by: engine(
            "expand::forward::tests::a_refinement_brings_back_the_digits_that_the_mass_matrix_lost",
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
        name: "sine: the last digits of a coefficient",
        file: "runtime/src/trigonometry/double.rs",
        from: "-0.166_666_666_666_666_3",
        to: "-0.166_666_666_666_664",
        noticed_by: Test {
            package: "homogen-tests",
            target: &["--test", "trigonometry"],
            name: "double_precision_at_random",
        },
    },
    Mutation {
        name: "exponential: 1 − cos φ by subtraction",
        file: "runtime/src/screw.rs",
        from: "let versine = T::constant(2.0) * half_sine * half_sine;",
        to: "let versine = one - phi.sin_cos().1 + (half_sine - half_sine);",
        noticed_by: geometry("exponential::versine_small"),
    },
    Mutation {
        name: "logarithm: the angle by the arc cosine",
        file: "runtime/src/rotation.rs",
        from: "T::constant(2.0) * self.sine.atan2(self.cosine)",
        // acos w is the angle of the point (w, √(1 − w²)).
        to: "{
            let w = self.cosine / norm([self.sine, self.cosine]);
            T::constant(2.0) * (T::constant(1.0) - w * w).abs().sqrt().atan2(w)
        }",
        noticed_by: geometry("logarithm::log_tiny"),
    },
    Mutation {
        name: "logarithm: near π as near 0",
        file: "runtime/src/rotation.rs",
        from: "if trace >= xx && trace >= yy && trace >= zz {",
        to: "if trace >= -one {",
        noticed_by: geometry("logarithm::log_near_pi"),
    },
];

const OBLIQUE: &str =
    "chain::tests::torques::a_tree_of_oblique_axes_has_the_same_torques_in_every_layout";

const fn engine(name: &'static str) -> Test {
    Test {
        package: "homogen-codegen",
        target: ENGINE,
        name,
    }
}

const fn geometry(name: &'static str) -> Test {
    Test {
        package: "homogen-tests",
        target: GEOMETRY,
        name,
    }
}

impl Mutation {
    /// The text of the file, broken.
    ///
    /// # Errors
    /// Where it has not exactly one place to break.
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
    use super::MUTATIONS;
    use std::path::Path;

    /// So that the list cannot fall behind the sources.
    #[test]
    fn every_mutation_has_its_place() {
        for mutation in &MUTATIONS {
            let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
            let text = std::fs::read_to_string(root.join(mutation.file)).expect("a source");
            let broken = mutation
                .apply(&text)
                .unwrap_or_else(|message| panic!("{message}"));
            assert_ne!(broken, text, "{}", mutation.name);
        }
    }
}
