//! Settings: each key with which something is asked for, one row a key.
//!
//! In: nothing; a shared noun. A row has the part of a [`Request`] that it sets, the key in attributes, whose values the
//! description reads, the flag of the command line, whose values [`text`] reads and says again, and the words of help
//! and guide.

#[cfg(feature = "files")]
pub mod text;

use std::fmt::Write;

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
    External(Of<Vec<Name>>),
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
    row("urdf", SettingForm::File, r#"urdf = "arm.urdf""#, 0, "", ""),
    row("dh", SettingForm::File, r#"dh = "arm.dh""#, 0, "", ""),
    row("base", SettingForm::Name(|asked| &mut asked.base), r#"base = "link""#,
        SCOPE, "LINK", "The link taken as fixed [default: the root]"),
    row("floating", SettingForm::Switch(|asked| &mut asked.floating), "floating",
        SCOPE, "", "Free the base: it moves anyhow, as the joint `root` with seven coordinates (x, y, z, and a quaternion x, y, z, w) and six velocities in its own frame, linear first"),
    row("tip", SettingForm::Name(|asked| &mut asked.tip), r#"tip = "link""#,
        SCOPE, "LINK", "The link whose frame poses and Jacobians are of [default: the last link, where there is only one]"),
    row("path_only", SettingForm::Switch(|asked| &mut asked.path_only), "path_only",
        SCOPE, "", "Lock every joint that does not move the tip; the bodies stay as mass"),
    row("lock", SettingForm::Positions(|asked| &mut asked.lock), "lock(joint, other = 0.3)",
        SCOPE, "JOINT[=q]", "Hold a joint still, at 0 or at a given coordinate (rad or m); its body stays as mass"),
    row("drop", SettingForm::Names(|asked| &mut asked.drop), "drop(link)",
        ROBOT, "LINK", "Take a link off with all that it carries, and with their mass"),
    row("loop", SettingForm::Loops, "",
        ROBOT, "NAME: TYPE {…}", "Close a loop by a joint between two links, as attributes have it: 'pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0), to_at: xyz(0.2, 0, 0) }'"),
    row("actuated", SettingForm::Names(|asked| &mut asked.actuated), "actuated(joint, other)",
        ROBOT, "JOINT", "A joint that is driven, where loops move the others"),
    row("gravity", SettingForm::Gravity, "gravity = [0.0, 0.0, -9.81], or gravity = none",
        ROBOT, "x,y,z", "Acceleration of gravity in the base frame (m/s²), or none [default: 0,0,-9.81]"),
    row("external", SettingForm::External(|asked| &mut asked.external), "external(gripper)",
        ROBOT, "LINK,…", "A link on which the surroundings act: inverse and forward dynamics and their derivatives take an action for each, in its own frame"),
    row("external_in_frame_0", SettingForm::Switch(|asked| &mut asked.external_in_frame_0), "",
        ROBOT, "", "These actions are in frame 0").needs("external"),
    row("friction", SettingForm::Drive(Part::Friction, Some(|asked| &mut asked.friction)), "friction(joint = 0.1)",
        ROBOT, "JOINT=f", "Model the friction that the file has, and that of a joint where one is given (N m or N)"),
    row("damping", SettingForm::Drive(Part::Damping, None), "damping(joint = 0.1)",
        ROBOT, "JOINT=d", "Viscous friction of a joint (N m s/rad or N s/m), and all friction that the file has"),
    row("rotors", SettingForm::Switch(|asked| &mut asked.rotors), "rotors",
        ROBOT, "", "Model the rotors that the file has, with their gears"),
    row("armature", SettingForm::Drive(Part::Armature, None), "armature(joint = 0.1)",
        ROBOT, "JOINT=a", "Inertia that a joint feels beside that of the bodies (kg m² or kg), and all rotors that the file has"),
    row("rotor", SettingForm::Drive(Part::Rotor, None), "rotor(joint = 0.1)",
        ROBOT, "JOINT=j", "Inertia of a joint's rotor (kg m²), which counts times the square of the ratio"),
    row("ratio", SettingForm::Drive(Part::Ratio, None), "ratio(joint = 0.1)",
        ROBOT, "JOINT=n", "Turns of a rotor for each of its joint [default: what the file says, or 1]"),
    row("exact", SettingForm::Switch(|asked| &mut asked.exact), "exact",
        ROBOT, "", "Keep an angle such as 1.5708 as written instead of taking it for a right angle"),
    row("strict", SettingForm::Switch(|asked| &mut asked.strict), "strict",
        ROBOT, "", "Refuse what is doubtful, such as inertias that no body can have, instead of warning"),
    row("processor", SettingForm::Processor, r#"processor = "cortex-m4""#,
        ROBOT, "NAME", "The processor that the functions run on: cortex-m4, cortex-m7, x86-64, x86-64-v3 or aarch64 [default: portable]"),
    row("formulation", SettingForm::Formulation, "formulation(raw, refined = 1)",
        ROBOT, "WORD,…", "How functions are computed: frame-0, raw, refined=1 (or 0, 2), articulated, merged, unfused, platform-sines [default: what the engine chooses]"),
    row("generate", SettingForm::Functions, "generate(inverse_dynamics)",
        FUNCTIONS, "NAME,…", "The functions; several with + between them share their work and count as one [default: all]").called("functions"),
    row("frames", SettingForm::Names(|asked| &mut asked.frames), "frames(link, other)",
        FRAMES, "LINK,…", "Further links whose poses and Jacobians are wanted"),
    row("scalar", SettingForm::Scalar, "scalar = f32", 0, "", ""),
    row("prepare", SettingForm::Switch(|asked| &mut asked.prepare), "prepare",
        FIELDS, "", "Compute once what depends on fields alone"),
    row("batch", SettingForm::Switch(|asked| &mut asked.batch), "batch",
        FILE, "", "Functions of slices of states besides").needs("runtime"),
    row("section", SettingForm::Count(|asked| &mut asked.section, "the most statements of one compiled function"), "section = 2000",
        FILE, "COUNT", "The most statements of one compiled function: longer ones are cut into sections that are called one after the other [default: 2000, of functions with more than 8000]"),
    row("crate", SettingForm::Runtime, r#"crate = "::homogen""#, 0, "", "").called("runtime"),
];

/// The keys of attributes.
pub fn of_attributes() -> impl Iterator<Item = &'static Setting> {
    SETTINGS
        .iter()
        .filter(|setting| !setting.example.is_empty())
}

/// The table of the guide: each flag, and the key of attributes that says the same.
#[must_use]
pub fn page() -> String {
    let mut page = "| option | in attributes | |\n|---|---|---|\n".to_owned();
    for setting in SETTINGS.iter().filter(|setting| setting.group != 0) {
        let flag = format!("--{} {}", setting.flag_name(), setting.value);
        let examples = setting.example.split(", or ");
        let examples = examples.filter(|example| !example.is_empty());
        let examples: Vec<String> = examples.map(|example| format!("`{example}`")).collect();
        let (flag, examples, help) = (flag.trim_end(), examples.join(", "), setting.help);
        // Writing to a string cannot fail.
        let _ = writeln!(page, "| `{flag}` | {examples} | {help} |");
    }
    page
}

const fn row(
    key: &'static str,
    form: SettingForm,
    example: &'static str,
    group: u8,
    value: &'static str,
    help: &'static str,
) -> Setting {
    Setting {
        key,
        form,
        example,
        name: None,
        group,
        value,
        help,
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
