//! Results of all functions of a robot as lists of numbers.
//!
//! In: a robot and a state. Out: every result, cut into blocks of one meaning and one unit (rotations, translations,
//! angular and linear parts), so that the entries of a block can share one measure of error.

use homogen::{
    Acceleration, Action, Chain, Momentum, Point, Pose, Scalar, Screw, TorqueDerivatives, Velocity,
    robot,
};

use crate::states::State;

/// Defines, from the list of every function, a trait of those that are compared and a function that evaluates them.
/// Solutions, whose errors depend on conditioning, functions with weights, a direction or a wrench, and results as wide as the robot has
/// parameters have tests of their own.
macro_rules! evaluated {
    (@[] [$($name:ident $method:ident($($argument:ident),*) $as_blocks:ident;)*]) => {
        /// A robot with all functions but solutions and those of parameters: a generated one, or a chain read at run
        /// time.
        pub trait EveryFunction<const N: usize, T, const Q: usize = N>:
            $(robot::$name<N, T, Q> +)*
        {
        }

        impl<R, const N: usize, T, const Q: usize> EveryFunction<N, T, Q> for R
        where
            R: $(robot::$name<N, T, Q> +)*
        {
        }

        /// Every function at one state.
        pub fn evaluate<R, T, const N: usize, const Q: usize>(
            robot: &R,
            state: &State<T, N, Q>,
        ) -> Vec<Block<T>>
        where
            R: EveryFunction<N, T, Q> + ?Sized,
            T: Scalar,
        {
            let mut blocks = Vec::new();
            $({
                let result = robot.$method($(&state.$argument),*);
                blocks.extend($as_blocks(stringify!($method), &result));
            })*
            blocks
        }
    };
    (@[$(#[doc = $about:literal])+ solution $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] $found:tt) => {
        evaluated!(@[$($rest)*] $found);
    };
    (@[$(#[doc = $about:literal])+ weighted $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] $found:tt) => {
        evaluated!(@[$($rest)*] $found);
    };
    (@[$(#[doc = $about:literal])+ directed $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] $found:tt) => {
        evaluated!(@[$($rest)*] $found);
    };
    (@[$(#[doc = $about:literal])+ tip_weighted $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] $found:tt) => {
        evaluated!(@[$($rest)*] $found);
    };
    (@[$(#[doc = $about:literal])+ chosen $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] $found:tt) => {
        evaluated!(@[$($rest)*] $found);
    };
    (@[$(#[doc = $about:literal])+ sized $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] $found:tt) => {
        evaluated!(@[$($rest)*] $found);
    };
    (@[$(#[doc = $about:literal])+ $kind:ident $name:ident $method:ident $arguments:tt -> T; $($rest:tt)*] [$($found:tt)*]) => {
        evaluated!(@[$($rest)*] [$($found)* $name $method $arguments number;]);
    };
    (@[$(#[doc = $about:literal])+ $kind:ident $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] [$($found:tt)*]) => {
        evaluated!(@[$($rest)*] [$($found)* $name $method $arguments blocks;]);
    };
    ($($all:tt)*) => { evaluated!(@[$($all)*] []); };
}
homogen::every_function!(evaluated);

/// The recursions of a chain with one joint. With them, what does not depend on the number of joints is compiled here,
/// where it is optimised, and programs that evaluate other chains share it.
#[must_use]
pub fn of_one_joint(chain: &Chain<1, 1>, state: &State<f64, 1>) -> Vec<Block<f64>> {
    evaluate(chain, state)
}

/// A result, or a part of it with one meaning.
#[derive(Clone, Debug)]
pub struct Block<T> {
    /// The function and the part: `velocity ω`.
    pub name: String,
    /// The entries, row by row.
    pub entries: Vec<T>,
}

impl<T: Copy> Block<T> {
    /// A block of some entries.
    pub fn new(name: &str, entries: impl IntoIterator<Item = T>) -> Self {
        Self {
            name: name.to_owned(),
            entries: entries.into_iter().collect(),
        }
    }

    /// The same block in another type of number.
    #[must_use]
    pub fn map<U>(&self, convert: impl Fn(T) -> U) -> Block<U> {
        Block {
            name: self.name.clone(),
            entries: self.entries.iter().copied().map(convert).collect(),
        }
    }
}

/// A pose and a geometric Jacobian, in blocks with the names of [`evaluate`].
#[must_use]
pub fn of_the_tip<T: Scalar>(m: &Pose<T>, geometric: &[Screw<T>]) -> Vec<Block<T>> {
    [
        m.blocks("forward_kinematics"),
        screws("geometric_jacobian", geometric),
    ]
    .concat()
}

/// A mass matrix and a bias, in blocks with the names of [`evaluate`].
#[must_use]
pub fn of_the_whole<T: Scalar, const N: usize>(mass: &[[T; N]; N], bias: &[T; N]) -> Vec<Block<T>> {
    [bias.blocks("bias"), mass.blocks("mass_matrix")].concat()
}

/// A result that can be cut into blocks.
trait Blocks<T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>>;
}

/// The blocks of a result with several numbers.
fn blocks<T>(function: &str, result: &impl Blocks<T>) -> Vec<Block<T>> {
    result.blocks(function)
}

/// The block of one number.
fn number<T: Scalar>(function: &str, result: &T) -> Vec<Block<T>> {
    vec![Block::new(function, [*result])]
}

/// The blocks of two parts of a function's result.
fn parts<T: Scalar>(function: &str, names: [&str; 2], entries: [Vec<T>; 2]) -> Vec<Block<T>> {
    let named = names.into_iter().zip(entries);
    named
        .map(|(name, entries)| Block::new(&format!("{function} {name}"), entries))
        .collect()
}

fn screws<T: Scalar>(function: &str, columns: &[Screw<T>]) -> Vec<Block<T>> {
    let (u, b) = (
        columns.iter().flat_map(Screw::u),
        columns.iter().flat_map(Screw::b),
    );
    parts(function, ["u", "b"], [u.collect(), b.collect()])
}

impl<T: Scalar> Blocks<T> for Pose<T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        let rotation = self.rotation().as_flattened().to_vec();
        parts(
            function,
            ["R", "t"],
            [rotation, self.translation().to_vec()],
        )
    }
}

impl<T: Scalar> Blocks<T> for Velocity<T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        parts(
            function,
            ["ω", "v"],
            [self.omega().to_vec(), self.v().to_vec()],
        )
    }
}

impl<T: Scalar> Blocks<T> for Acceleration<T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        let g = self.g().as_flattened().to_vec();
        parts(function, ["G", "a"], [g, self.a().to_vec()])
    }
}

impl<T: Scalar> Blocks<T> for Point<T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        vec![Block::new(function, self.0)]
    }
}

impl<T: Scalar> Blocks<T> for Momentum<T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        [*self].blocks(function)
    }
}

impl<T: Scalar, const N: usize> Blocks<T> for [Momentum<T>; N] {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        let gamma = self.iter().flat_map(Momentum::gamma).collect();
        let rho = self.iter().flat_map(Momentum::rho).collect();
        parts(function, ["γ", "ρ"], [gamma, rho])
    }
}

impl<T: Scalar> Blocks<T> for Action<T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        parts(function, ["c", "f"], [self.c().to_vec(), self.f().to_vec()])
    }
}

/// One block of all rates: with parallel axes, or rotation about the end effector alone, some parts are pure rounding
/// error.
impl<T: Scalar, const N: usize> Blocks<T> for [Screw<T>; N] {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        if function.ends_with("_jacobian_rate") {
            let entries = self.iter().flat_map(|one| [one.u(), one.b()]).flatten();
            vec![Block::new("jacobian_rates", entries)]
        } else {
            screws(function, self)
        }
    }
}

/// One block with the rates, since these are those at unit velocities: where no joint carries another along, all of them
/// are pure rounding errors.
impl<T: Scalar, const N: usize, const M: usize> Blocks<T> for [[Screw<T>; M]; N] {
    fn blocks(&self, _: &str) -> Vec<Block<T>> {
        let entries = self.as_flattened().iter();
        let entries = entries.flat_map(|one| [one.u(), one.b()]).flatten();
        vec![Block::new("jacobian_rates", entries)]
    }
}

impl<T: Scalar, const N: usize> Blocks<T> for [T; N] {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        vec![Block::new(function, *self)]
    }
}

impl<T: Scalar, const N: usize, const M: usize> Blocks<T> for [[T; M]; N] {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        vec![Block::new(function, self.as_flattened().to_vec())]
    }
}

/// One block: without gravity, ∂τ/∂q of a single body is the rounding error of terms as large as those of ∂τ/∂q̇.
impl<T: Scalar, const N: usize> Blocks<T> for TorqueDerivatives<N, T> {
    fn blocks(&self, function: &str) -> Vec<Block<T>> {
        let entries = [self.dq, self.dqd];
        let entries = entries.as_flattened().as_flattened();
        vec![Block::new(function, entries.to_vec())]
    }
}
