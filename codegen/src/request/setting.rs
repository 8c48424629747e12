//! Settings: each key with which something is asked for, one row a key.
//!
//! In: nothing; a shared noun. A row has the part of a [`Request`] that it sets, the key in attributes, whose values the
//! description reads, the flag of the command line, whose values [`text`] reads and says again, and the words of help
//! and guide.

#[cfg(feature = "files")]
pub mod text;

use crate::joint::drive::Part;
use crate::name::Name;
use crate::number::Number;
use crate::request::Request;

/// A key, and all that follows from it.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The key in attributes.
    pub key: &'static str,
    /// What it sets, and how values are written.
    pub form: SettingForm,
    /// How it is written in attributes; nothing where they have no such key.
    pub example: &'static str,
    /// The name on the command line, where that is not the key.
    name: Option<&'static str>,
    /// The group of flags, one of the bits below; none where a command reads the flag by itself, or has none.
    pub group: u8,
    /// What stands for the value in help; it ends with … where a flag takes several, with commas between them.
    pub value: &'static str,
    /// What help says.
    pub help: &'static str,
    /// The key of the flag that has to stand beside it.
    pub needs: Option<&'static str>,
}

/// The part of a request that a setting sets.
type Of<T> = fn(&mut Request) -> &mut T;

/// What a setting sets, and how values are written.
#[derive(Clone, Copy, Debug)]
pub enum SettingForm {
    /// The file that describes the robot.
    File,
    /// The key alone.
    Switch(Of<bool>),
    /// A link.
    Name(Of<Option<Name>>),
    /// Links or joints.
    Names(Of<Vec<Name>>),
    /// Joints, each with or without a coordinate.
    Positions(Of<Vec<(Name, Option<Number>)>>),
    /// Joints, each with a number or one for each velocity; or the key alone, where that is a switch.
    Drive(Part, Option<Of<bool>>),
    /// Links on which external forces act, and the frame of these.
    External,
    /// Three numbers, or none.
    Gravity,
    /// A positive number, in these words.
    Count(Of<Option<usize>>, &'static str),
    /// Functions, alone or together.
    Functions,
    /// Words of a formulation.
    Formulation,
    /// The name of a processor.
    Processor,
    /// A type of number.
    Scalar,
    /// The path of the runtime.
    Runtime,
    /// Loops, each as attributes have it behind the word `loop`.
    Loops,
}

/// Flags that say which part of a robot moves.
pub const SCOPE: u8 = 1;
/// Flags that say which robot it is and how it is computed.
pub const ROBOT: u8 = 1 << 1;
/// Flags that name functions.
pub const FUNCTIONS: u8 = 1 << 2;
/// Flags that name further frames.
pub const FRAMES: u8 = 1 << 3;
/// Flags beside the fields of a struct.
pub const FIELDS: u8 = 1 << 4;
/// Flags of a file in Rust, C or LLVM IR.
pub const FILE: u8 = 1 << 5;

/// All of them, in the order in which help, the heads of files and messages list them.
#[rustfmt::skip]
pub const SETTINGS: [Setting; 30] = [
    key("urdf", SettingForm::File, r#"urdf = "arm.urdf""#),
    key("dh", SettingForm::File, r#"dh = "arm.dh""#),
    key("base", SettingForm::Name(|asked| &mut asked.base), r#"base = "link""#)
        .flag(SCOPE, "LINK", "The link taken as fixed [default: the root]"),
    key("floating", SettingForm::Switch(|asked| &mut asked.floating), "floating")
        .flag(SCOPE, "", "Free the base: it moves anyhow, as the joint `root` with seven coordinates (x, y, z, and a quaternion x, y, z, w) and six velocities in its own frame, linear first"),
    key("tip", SettingForm::Name(|asked| &mut asked.tip), r#"tip = "link""#)
        .flag(SCOPE, "LINK", "The link whose frame poses and Jacobians are of [default: the last link, where there is only one]"),
    key("path_only", SettingForm::Switch(|asked| &mut asked.path_only), "path_only")
        .flag(SCOPE, "", "Lock every joint that does not move the tip; the bodies stay as mass"),
    key("lock", SettingForm::Positions(|asked| &mut asked.lock), "lock(joint, other = 0.3)")
        .flag(SCOPE, "JOINT[=q]", "Hold a joint still, at 0 or at a given coordinate (rad or m); its body stays as mass"),
    key("drop", SettingForm::Names(|asked| &mut asked.drop), "drop(link)")
        .flag(ROBOT, "LINK", "Take a link off with all that it carries, and with their mass"),
    key("loop", SettingForm::Loops, "")
        .flag(ROBOT, "NAME: TYPE {…}", "Close a loop by a joint between two links, as attributes have it: 'pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0), to_at: xyz(0.2, 0, 0) }'"),
    key("actuated", SettingForm::Names(|asked| &mut asked.actuated), "actuated(joint, other)")
        .flag(ROBOT, "JOINT", "A joint that is driven, where loops move the others"),
    key("gravity", SettingForm::Gravity, "gravity = [0.0, 0.0, -9.81], or gravity = none")
        .flag(ROBOT, "x,y,z", "Acceleration of gravity in the base frame (m/s²), or none [default: 0,0,-9.81]"),
    key("external", SettingForm::External, "external(gripper)")
        .flag(ROBOT, "LINK,…", "A link on which the surroundings act: inverse and forward dynamics and their derivatives take an action for each, in its own frame"),
    key("external_in_frame_0", SettingForm::Switch(|asked| &mut asked.external_in_frame_0), "")
        .flag(ROBOT, "", "These actions are in frame 0").needs("external"),
    key("friction", SettingForm::Drive(Part::Friction, Some(|asked| &mut asked.friction)), "friction(joint = 0.1)")
        .flag(ROBOT, "JOINT=f", "Model the friction that the file has, and that of a joint where one is given (N m or N)"),
    key("damping", SettingForm::Drive(Part::Damping, None), "damping(joint = 0.1)")
        .flag(ROBOT, "JOINT=d", "Viscous friction of a joint (N m s/rad or N s/m), and all friction that the file has"),
    key("rotors", SettingForm::Switch(|asked| &mut asked.rotors), "rotors")
        .flag(ROBOT, "", "Model the rotors that the file has, with their gears"),
    key("armature", SettingForm::Drive(Part::Armature, None), "armature(joint = 0.1)")
        .flag(ROBOT, "JOINT=a", "Inertia that a joint feels beside that of the bodies (kg m² or kg), and all rotors that the file has"),
    key("rotor", SettingForm::Drive(Part::Rotor, None), "rotor(joint = 0.1)")
        .flag(ROBOT, "JOINT=j", "Inertia of a joint's rotor (kg m²), which counts times the square of the ratio"),
    key("ratio", SettingForm::Drive(Part::Ratio, None), "ratio(joint = 0.1)")
        .flag(ROBOT, "JOINT=n", "Turns of a rotor for each of its joint [default: what the file says, or 1]"),
    key("exact", SettingForm::Switch(|asked| &mut asked.exact), "exact")
        .flag(ROBOT, "", "Keep an angle such as 1.5708 as written instead of taking it for a right angle"),
    key("strict", SettingForm::Switch(|asked| &mut asked.strict), "strict")
        .flag(ROBOT, "", "Refuse what is doubtful, such as inertias that no body can have, instead of warning"),
    key("processor", SettingForm::Processor, r#"processor = "cortex-m4""#)
        .flag(ROBOT, "NAME", "The processor that the functions run on: cortex-m4, cortex-m7, x86-64, x86-64-v3 or aarch64 [default: portable]"),
    key("formulation", SettingForm::Formulation, "formulation(raw, refined = 1)")
        .flag(ROBOT, "WORD,…", "How functions are computed: frame-0, raw, refined=1 (or 0, 2), articulated, merged, unfused, platform-sines [default: what the engine chooses]"),
    key("generate", SettingForm::Functions, "generate(inverse_dynamics)").called("functions")
        .flag(FUNCTIONS, "NAME,…", "The functions; several with + between them share their work and count as one [default: all]"),
    key("frames", SettingForm::Names(|asked| &mut asked.frames), "frames(link, other)")
        .flag(FRAMES, "LINK,…", "Further links whose poses and Jacobians are wanted"),
    key("scalar", SettingForm::Scalar, "scalar = f32"),
    key("prepare", SettingForm::Switch(|asked| &mut asked.prepare), "prepare")
        .flag(FIELDS, "", "Compute once what depends on fields alone"),
    key("batch", SettingForm::Switch(|asked| &mut asked.batch), "batch")
        .flag(FILE, "", "Functions of slices of states besides").needs("runtime"),
    key("section", SettingForm::Count(|asked| &mut asked.section, "the most statements of one compiled function"), "section = 2000")
        .flag(FILE, "COUNT", "The most statements of one compiled function: longer ones are cut into sections that are called one after the other [default: 2000, of functions with more than 8000]"),
    key("crate", SettingForm::Runtime, r#"crate = "::homogen""#).called("runtime"),
];

/// The keys of attributes.
pub fn of_attributes() -> impl Iterator<Item = &'static Setting> {
    SETTINGS
        .iter()
        .filter(|setting| !setting.example.is_empty())
}

const fn key(key: &'static str, form: SettingForm, example: &'static str) -> Setting {
    Setting {
        key,
        form,
        example,
        name: None,
        group: 0,
        value: "",
        help: "",
        needs: None,
    }
}

impl Setting {
    const fn called(self, name: &'static str) -> Self {
        Self {
            name: Some(name),
            ..self
        }
    }

    const fn flag(self, group: u8, value: &'static str, help: &'static str) -> Self {
        Self {
            group,
            value,
            help,
            ..self
        }
    }

    const fn needs(self, key: &'static str) -> Self {
        Self {
            needs: Some(key),
            ..self
        }
    }

    /// The flag of the command line, without the dashes before it.
    #[must_use]
    pub fn flag_name(&self) -> String {
        self.name.unwrap_or(self.key).replace('_', "-")
    }
}
