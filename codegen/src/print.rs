//! The last stage: what is printed for a robot.
//!
//! In: the programs of a robot and what is to be said about them, as a [`Listing`]. Out: text in a
//! language, which has a room of its own below and finds here what every language shares. It never
//! computes a number, changes an operation or chooses an order.

#[cfg(feature = "pretty")]
pub(crate) mod ascii;
pub mod c;
mod documentation;
mod large;
pub mod llvm;
#[cfg(feature = "pretty")]
pub mod python;
mod review;
pub mod rust;
mod sines;
mod steps;
mod walk;

use crate::accuracy::Accuracy;
use crate::closure::Row;
use crate::formulation::Sines;
use crate::function::Function;
use crate::joint::Posture;
use crate::layout::Layout;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::Parameter;
use crate::schedule::{Length, Price, Program, part};
use crate::space::{Space, Spaces, Variable};

/// Everything that is printed for one robot.
#[derive(Clone, Debug)]
pub struct Listing {
    /// What the comments say.
    pub about: About,
    /// What arguments and results are over.
    pub spaces: Spaces,
    /// The functions, in the order of the request.
    pub functions: Vec<Listed>,
    /// The robot as data.
    pub data: ChainData,
    /// What base parameters are described as \[kg, kg m, kg m²\].
    pub base_values: Vec<f64>,
    /// Whether functions take slices of states besides.
    pub batch: bool,
    /// How long a function is that compilers see.
    pub length: Length,
    /// The type of number.
    pub scalar: Real,
    /// Where sines and cosines come from.
    pub sines: Sines,
    /// The fields that programs read, in the order in which
    /// [`Input::Parameter`](crate::expression::Input) counts them.
    pub parameters: Vec<Parameter>,
    /// The same functions with what depends on fields alone computed once, where that is asked for.
    pub prepared: Option<Prepared>,
    /// What the reviewer of a file reads, where it becomes one.
    pub review: Option<Review>,
}

/// What the reviewer of a file wants to see beside its code.
#[derive(Clone, Debug, Default)]
pub struct Review {
    /// The greatest torque or force of each velocity \[N m or N\], infinite where none is described.
    pub efforts: Vec<f64>,
    /// What functions should return.
    pub vectors: Vec<Vector>,
    /// Where inertial numbers come from, for each layout of the frames.
    pub origins: Vec<Origins>,
    /// The links that became part of the body of another, and that other.
    pub merged: Vec<(String, String)>,
}

/// What a function should return at a state, found without its program.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Its place in the listing.
    pub function: usize,
    /// Its arguments, in the type of number.
    pub arguments: Vec<(Variable, Vec<f64>)>,
    /// The fields, in the order of the listing.
    pub fields: Vec<Vec<f64>>,
    /// The numbers of its results.
    pub expected: Vec<f64>,
    /// How far each may be off.
    pub tolerances: Vec<f64>,
}

/// Where the inertial numbers of bodies come from whose frames stand in one way.
#[derive(Clone, Debug)]
pub struct Origins {
    /// The functions that have them, by name.
    pub functions: Vec<String>,
    /// The bodies that have any: the link that each is, and its numbers.
    pub bodies: Vec<(String, Vec<Sum>)>,
}

/// An entry of a J as a sum of parameters of links.
#[derive(Clone, Debug)]
pub struct Sum {
    /// The entry: `J_xx`, `q_x`, `m`.
    pub entry: &'static str,
    /// What it is described as [kg, kg m, kg m²].
    pub value: f64,
    /// The parameters, each with its factor; none where they are not told apart.
    pub terms: Vec<(f64, String)>,
}

/// A robot in two parts: what its fields make of it, and what is left of its functions.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// What depends on fields alone.
    pub once: Program,
    /// What that costs.
    pub price: Price,
    /// What its results would like to be called, none twice.
    pub names: Vec<String>,
    /// The functions, in the order of the listing, which read those results as the only field.
    pub functions: Vec<Listed>,
}

/// What programs read of a struct.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Fields<'l> {
    /// What the user puts into it.
    Own(&'l [Parameter]),
    /// What has been computed of that: one field, whose entries would like these names.
    Computed(&'l [String]),
}

impl Fields<'_> {
    /// The names that the entries of each would like.
    pub(crate) fn entries(self) -> Vec<Vec<String>> {
        match self {
            Self::Own(parameters) => parameters.iter().map(Parameter::entries).collect(),
            Self::Computed(names) => vec![names.to_vec()],
        }
    }
}

impl Listing {
    /// Parts the functions of a listing into what depends on fields alone and what is left.
    #[must_use]
    pub fn prepare(mut self, processor: Processor) -> Self {
        let programs = self.functions.iter().map(|listed| &listed.program);
        let parts = part(
            &programs.collect::<Vec<_>>(),
            &Fields::Own(&self.parameters).entries(),
        );
        let on = |price: Price| price.on(processor, self.scalar);
        let functions = self.functions.iter().zip(parts.each);
        let functions = functions.map(|(listed, program)| {
            let Price {
                naive_mul,
                naive_add,
                ..
            } = listed.price;
            let price = Price::of(&program).beside_dense(naive_mul, naive_add);
            Listed {
                price: on(price),
                program,
                ..listed.clone()
            }
        });
        self.prepared = Some(Prepared {
            functions: functions.collect(),
            price: on(Price::of(&parts.once)),
            once: parts.once,
            names: parts.names,
        });
        self
    }

    /// The values of the base parameters, where a function asks for them.
    pub(crate) fn base_parameters(&self) -> Option<&[f64]> {
        let mut functions = self.functions.iter().flat_map(|listed| &listed.functions);
        let asked = functions.any(|function| {
            let mut parts = function.result().parts();
            parts.any(|(_, part)| part.over.contains(&Space::BaseParameters))
        });
        asked.then_some(&self.base_values)
    }
}

/// What comments say about a robot.
#[derive(Clone, Debug, Default)]
pub struct About {
    /// The robot's name.
    pub robot: String,
    /// The name of the file it was read from, without folders, and the hash of its bytes.
    pub source: Option<(String, u64)>,
    /// The link whose frame is frame 0.
    pub base: String,
    /// The link whose frame poses and Jacobians are of.
    pub tip: String,
    /// What is modelled and what is not: `2 links merged`, `gravity only along −z`.
    pub facts: Vec<String>,
    /// Whether joints feel more than their bodies: an armature or friction.
    pub driven: bool,
    /// The words of the formulation that was asked for, where it is not the default.
    pub formulation: Vec<String>,
    /// Doubts about the description, each a sentence with its place.
    pub warnings: Vec<String>,
    /// Functions that the robot cannot have, where all that it can have were asked for.
    pub left_out: Vec<LeftOut>,
}

/// Functions that a robot cannot have, for one reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Their names.
    pub functions: Vec<String>,
    /// Why, a sentence with its place.
    pub reason: String,
    /// What to do about it.
    pub hint: Option<String>,
    /// Whether the engine is at fault, and not the robot.
    pub is_fault: bool,
}

/// One generated function, a method of the robot's type where the language has such.
#[derive(Clone, Debug)]
pub struct Listed {
    /// What it computes; several functions share their work and are returned as a tuple.
    pub functions: Vec<Function>,
    /// The link whose frame it is about, where that is not the tip.
    pub frame: Option<String>,
    /// Where the frames stand that its matrices are in.
    pub layout: Layout,
    /// The operations.
    pub program: Program,
    /// What they cost.
    pub price: Price,
    /// How far rounding can take their results: those that are evaluated, and each that solves
    /// something.
    pub accuracy: Vec<Accuracy>,
}

impl Listed {
    /// Its name, as far as nothing else is called so.
    #[must_use]
    pub fn name(&self) -> String {
        name(&self.functions, self.frame.as_deref())
    }

    /// What its functions together are functions of.
    pub(crate) fn arguments(&self, spaces: &Spaces) -> Vec<Variable> {
        arguments(&self.functions, spaces.actions() > 0)
    }
}

/// What several functions together are functions of, where actions from outside are among it or not.
fn arguments(functions: &[Function], actions: bool) -> Vec<Variable> {
    let each = functions.iter();
    Variable::together(each.map(|function| function.arguments_with(actions)))
}

/// `mass_matrix_and_bias`, `forward_kinematics_of_camera`.
fn name(functions: &[Function], frame: Option<&str>) -> String {
    let names: Vec<_> = functions.iter().map(|function| function.name()).collect();
    let name = names.join("_and_");
    match frame {
        Some(frame) => format!("{name}_of_{frame}"),
        None => name,
    }
}

/// A robot as data for the generic recursions of the runtime.
#[derive(Clone, Debug)]
pub struct ChainData {
    /// The joints' names, parents before children.
    pub names: Vec<String>,
    /// The joint that carries the link on which each joint hangs; none where that is the base.
    pub parents: Vec<Option<u16>>,
    /// What moves each joint.
    pub motions: Vec<DataMotion>,
    /// Further frames, the tip's first: name, and the joint that carries it.
    pub frames: Vec<(String, Option<u16>)>,
    /// How many of the last frames are acted on from outside, and whether that is in frame 0.
    pub external: (usize, bool),
    /// The drives of which something is modelled: each the joint, and which of its velocities.
    pub driven: Vec<(u16, u16)>,
    /// The numbers, of parameters only. A joint has 28: placement at q = 0 in its parent's frame
    /// (rows of the upper 3×4 block), screw (u, b), pseudo-inertia (xx, yy, zz, xy, xz, yz, the
    /// first moments qx, qy, qz, and m). A frame has 12, its placement. Gravity has 3, and each drive
    /// has 3: armature, damping, friction.
    pub program: Program,
    /// What its loops hold together.
    pub loops: LoopsData,
}

/// What closes the loops of a robot, as data.
#[derive(Clone, Debug)]
pub struct LoopsData {
    /// The loops.
    pub loops: Vec<LoopData>,
    /// Which velocities are driven.
    pub driven: Vec<bool>,
    /// The numbers, of parameters only. A loop has 25: the placements of its two frames, and the length of
    /// a rod, or the cosine of the angle of two axes.
    pub program: Program,
}

/// What closes a loop, as data.
#[derive(Clone, Debug)]
pub struct LoopData {
    /// Its name.
    pub name: String,
    /// The frames that it holds together: name, and the joint that carries it.
    pub frames: [(String, Option<u16>); 2],
    /// What it closes.
    pub rows: Vec<Row>,
}

/// What moves a joint of a [`ChainData`], whose coordinates and velocities follow those of the joints before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DataMotion {
    /// A coordinate of its own, along the screw.
    Along,
    /// That of another joint, times a number, along the screw.
    Follows {
        /// The joint.
        leader: u16,
        /// The number.
        multiplier: f64,
    },
    /// A posture; the screw is that of its first velocity.
    Posture(Posture),
}

impl DataMotion {
    /// How many coordinates and velocities it has.
    #[must_use]
    pub const fn counts(self) -> (usize, usize) {
        match self {
            Self::Along => (1, 1),
            Self::Follows { .. } => (0, 0),
            Self::Posture(posture) => (posture.coordinates().len(), posture.velocities()),
        }
    }
}
