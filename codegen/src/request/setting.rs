//! The table of keys: one row for each setting, from which attributes, the command line with its help, heads of files
//! and the guide follow.

#[cfg(feature = "files")]
pub mod text;

use std::fmt::Write;

use crate::joint::actuator::ActuatorQuantity;
use crate::name::Name;
use crate::number::Number;
use crate::request::Request;

/// A row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The key in attributes.
    pub key: &'static str,
    /// The field that it sets, and the form of its values.
    pub form: SettingForm,
    /// An example in attributes; empty if they have no such key.
    pub example: &'static str,
    /// The option of the command line, if its name differs from the key.
    name: Option<&'static str>,
    /// The group of options, one of the bits below; 0 if a command reads the option itself, or there is none.
    pub group: u8,
    /// Placeholder of the value in help; it ends with … if several values with commas are allowed.
    pub value: &'static str,
    /// The sentence in help.
    pub help: &'static str,
    /// The key of another option that this one requires.
    pub needs: Option<&'static str>,
}

/// Access to the field of a request that a setting sets.
type FieldAccess<T> = fn(&mut Request) -> &mut T;

/// The field that a setting sets, and the syntax of its values.
#[derive(Clone, Copy, Debug)]
pub enum SettingForm {
    /// The file that describes the robot.
    File,
    /// Arguments of a xacro file, each with a value.
    Arguments,
    /// Packages, each with a folder.
    Packages,
    /// The key alone.
    Switch(FieldAccess<bool>),
    /// A link.
    Name(FieldAccess<Option<Name>>),
    /// Links or joints.
    Names(FieldAccess<Vec<Name>>),
    /// Joints, each with or without a coordinate.
    Positions(FieldAccess<Vec<(Name, Option<Number>)>>),
    /// Joints, each with one number or one for each velocity; or the key alone, if it is a switch as well.
    Actuator(ActuatorQuantity, Option<FieldAccess<bool>>),
    /// Pairs of links, or the key alone.
    Pairs(FieldAccess<Vec<[Name; 2]>>, FieldAccess<bool>),
    /// Links with external wrenches, and their frame.
    External(FieldAccess<Vec<Name>>),
    /// Three numbers, or `none`.
    Gravity,
    /// A positive number, with a noun for messages.
    Count(FieldAccess<Option<usize>>, &'static str),
    /// Functions, alone or together.
    Functions,
    /// Words of a formulation.
    Formulation,
    /// The name of a processor.
    Processor,
    /// The type of numbers.
    Scalar,
    /// The path of the runtime.
    Runtime,
    /// The rule of time steps.
    Steps,
    /// Loops, each written as after the word `loop` in attributes.
    Loops,
}

/// Options of the part of the robot that moves.
pub const SCOPE: u8 = 1;
/// Options of the robot and of its computation.
pub const ROBOT: u8 = 1 << 1;
/// Options with names of functions.
pub const FUNCTIONS: u8 = 1 << 2;
/// Options with further frames.
pub const FRAMES: u8 = 1 << 3;
/// Options about fields of the struct.
pub const FIELDS: u8 = 1 << 4;
/// Options of a file in Rust, C or LLVM IR.
pub const FILE: u8 = 1 << 5;

/// Options of the file that describes the robot.
pub const SOURCE: u8 = 1 << 6;
/// Those options of a file that a project in C has, too.
pub const C: u8 = 1 << 7;

/// A row with default values.
const SETTING: Setting = Setting {
    key: "",
    form: SettingForm::File,
    example: "",
    name: None,
    group: 0,
    value: "",
    help: "",
    needs: None,
};

/// All keys, in the order of help, heads of files and messages.
#[rustfmt::skip]
pub const SETTINGS: [Setting; 40] = [
    Setting { key: "urdf", form: SettingForm::File, example: r#"urdf = "arm.urdf""#, ..SETTING },
    Setting { key: "mjcf", form: SettingForm::File, example: r#"mjcf = "arm.xml""#, ..SETTING },
    Setting { key: "sdf", form: SettingForm::File, example: r#"sdf = "arm.sdf""#, ..SETTING },
    Setting { key: "dh", form: SettingForm::File, example: r#"dh = "arm.dh""#, ..SETTING },
    Setting { key: "arguments", form: SettingForm::Arguments, example: r#"arguments(ur_type = "ur5e", safety_limits = true)"#, group: SOURCE, value: "NAME=VALUE",
        help: "An argument of a xacro file; it stands for the environment variable of the same name, too", ..SETTING },
    Setting { key: "packages", form: SettingForm::Packages, example: r#"packages(ur_description = "../ur_description")"#, group: SOURCE, value: "NAME=FOLDER",
        help: "The folder of a ROS package, for $(find NAME) in a xacro file, or of a model, for model://NAME in an SDF file [default: near the file]", ..SETTING },
    Setting { key: "base", form: SettingForm::Name(|asked| &mut asked.base), example: r#"base = "link""#, group: SCOPE, value: "LINK",
        help: "The fixed link [default: the root]", ..SETTING },
    Setting { key: "floating", form: SettingForm::Switch(|asked| &mut asked.floating), example: "floating", group: SCOPE,
        help: "A floating base: the joint `root` with seven coordinates (x, y, z, and a quaternion x, y, z, w) and six velocities in its own frame, linear first", ..SETTING },
    Setting { key: "tip", form: SettingForm::Name(|asked| &mut asked.tip), example: r#"tip = "link""#, group: SCOPE, value: "LINK",
        help: "The end effector: the link of poses and Jacobians [default: the last link, if there is only one]", ..SETTING },
    Setting { key: "path_only", form: SettingForm::Switch(|asked| &mut asked.path_only), example: "path_only", group: SCOPE,
        help: "Lock every joint that does not move the end effector; the bodies stay as mass", ..SETTING },
    Setting { key: "lock", form: SettingForm::Positions(|asked| &mut asked.lock), example: "lock(joint, other = 0.3)", group: SCOPE, value: "JOINT[=q]",
        help: "Hold a joint still, at 0 or at a given coordinate (rad or m); its body stays as mass", ..SETTING },
    Setting { key: "drop", form: SettingForm::Names(|asked| &mut asked.drop), example: "drop(link)", group: ROBOT, value: "LINK",
        help: "Remove a link with everything that it carries, and with their mass", ..SETTING },
    Setting { key: "loop", form: SettingForm::Loops, group: ROBOT, value: "NAME: TYPE {…}",
        help: "Close a loop by a joint between two links, written as in attributes: 'pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0), to_at: xyz(0.2, 0, 0) }'", ..SETTING },
    Setting { key: "actuated", form: SettingForm::Names(|asked| &mut asked.actuated), example: "actuated(joint, other)", group: ROBOT, value: "JOINT",
        help: "An actuated joint of a robot with loops", ..SETTING },
    Setting { key: "gravity", form: SettingForm::Gravity, example: "gravity = [0.0, 0.0, -9.81], or gravity = none", group: ROBOT, value: "x,y,z",
        help: "Acceleration of gravity in the base frame (m/s²), or none [default: 0,0,-9.81]", ..SETTING },
    Setting { key: "external", form: SettingForm::External(|asked| &mut asked.external), example: "external(gripper)", group: ROBOT, value: "LINK,…",
        help: "A link with an external wrench: inverse and forward dynamics and their derivatives take one for each, in the link's frame", ..SETTING },
    Setting { key: "external_in_frame_0", form: SettingForm::Switch(|asked| &mut asked.external_in_frame_0), group: ROBOT, needs: Some("external"),
        help: "These wrenches are in frame 0", ..SETTING },
    Setting { key: "friction", form: SettingForm::Actuator(ActuatorQuantity::Friction, Some(|asked| &mut asked.friction)), example: "friction(joint = 0.1)", group: ROBOT, value: "JOINT=f",
        help: "Model the friction of the file, and Coulomb friction of a joint if one is named (N m or N)", ..SETTING },
    Setting { key: "damping", form: SettingForm::Actuator(ActuatorQuantity::Damping, None), example: "damping(joint = 0.1)", group: ROBOT, value: "JOINT=d",
        help: "Viscous friction of a joint (N m s/rad or N s/m), and all friction of the file", ..SETTING },
    Setting { key: "rotors", form: SettingForm::Switch(|asked| &mut asked.rotors), example: "rotors", group: ROBOT,
        help: "Model the rotors of the file, with their gears", ..SETTING },
    Setting { key: "armature", form: SettingForm::Actuator(ActuatorQuantity::Armature, None), example: "armature(joint = 0.1)", group: ROBOT, value: "JOINT=a",
        help: "Armature: inertia at a joint in addition to the bodies (kg m² or kg), and all rotors of the file", ..SETTING },
    Setting { key: "rotor", form: SettingForm::Actuator(ActuatorQuantity::Rotor, None), example: "rotor(joint = 0.1)", group: ROBOT, value: "JOINT=j",
        help: "Inertia of a joint's rotor (kg m²), multiplied by the square of the ratio", ..SETTING },
    Setting { key: "ratio", form: SettingForm::Actuator(ActuatorQuantity::Ratio, None), example: "ratio(joint = 0.1)", group: ROBOT, value: "JOINT=n",
        help: "Turns of a rotor for one of its joint [default: that of the file, or 1]", ..SETTING },
    Setting { key: "exact", form: SettingForm::Switch(|asked| &mut asked.exact), example: "exact", group: ROBOT,
        help: "Keep an angle such as 1.5708 as written instead of taking it as a right angle", ..SETTING },
    Setting { key: "strict", form: SettingForm::Switch(|asked| &mut asked.strict), example: "strict", group: ROBOT,
        help: "Make warnings errors, such as those of non-physical inertias", ..SETTING },
    Setting { key: "quiet", form: SettingForm::Switch(|asked| &mut asked.quiet), example: "quiet", ..SETTING },
    Setting { key: "processor", form: SettingForm::Processor, example: r#"processor = "cortex-m4""#, group: ROBOT, value: "NAME",
        help: "The processor that the functions run on: cortex-m4, cortex-m7, x86-64, x86-64-v3 or aarch64 [default: portable]", ..SETTING },
    Setting { key: "formulation", form: SettingForm::Formulation, example: "formulation(raw, refined = 1)", group: ROBOT, value: "WORD,…",
        help: "The formulation: frame-0, raw, refined=1 (or 0, 2), articulated, merged, unfused, platform-sines [default: the engine's choice]", ..SETTING },
    Setting { key: "generate", form: SettingForm::Functions, example: "generate(inverse_dynamics)", name: Some("functions"), group: FUNCTIONS, value: "NAME,…",
        help: "The functions; several with + between them share their work and count as one [default: all]", ..SETTING },
    Setting { key: "frames", form: SettingForm::Names(|asked| &mut asked.frames), example: "frames(link, other)", group: FRAMES, value: "LINK,…",
        help: "Further links with poses and Jacobians", ..SETTING },
    Setting { key: "collision", form: SettingForm::Pairs(|asked| &mut asked.collision_pairs, |asked| &mut asked.collision), example: "collision, or collision(hand: base)", group: ROBOT, value: "LINK:LINK",
        help: "Model the collision spheres of the file: their centres, and the distances of those on two links, or on all that no joint joins", ..SETTING },
    Setting { key: "scalar", form: SettingForm::Scalar, example: "scalar = f32", ..SETTING },
    Setting { key: "reproducible", form: SettingForm::Switch(|asked| &mut asked.reproducible), example: "reproducible", group: ROBOT,
        help: "The same bits on every processor: no product is fused with a sum", ..SETTING },
    Setting { key: "prepare", form: SettingForm::Switch(|asked| &mut asked.prepare), example: "prepare", group: FIELDS,
        help: "Compute once what depends on fields alone", ..SETTING },
    Setting { key: "batch", form: SettingForm::Switch(|asked| &mut asked.batch), example: "batch", group: FILE, needs: Some("runtime"),
        help: "Functions of slices of states in addition", ..SETTING },
    Setting { key: "section", form: SettingForm::Count(|asked| &mut asked.section, "the maximum number of statements of one compiled function"), example: "section = 2000", group: FILE | C, value: "COUNT",
        help: "Maximum number of statements of one compiled function: longer ones are cut into sections that are called in order [default: 2000, of functions with more than 8000; with batches 500, of functions with more than 4000]", ..SETTING },
    Setting { key: "casadi", form: SettingForm::Switch(|asked| &mut asked.for_c.casadi), group: FILE | C,
        help: "In C, add CasADi's external interface, with the derivatives that are generated", ..SETTING },
    Setting { key: "steps", form: SettingForm::Steps, group: FILE | C, value: "RULE",
        help: "In C, add time steps of forward dynamics, with the derivatives that are generated: semi-implicit, euler or rk4; or of inverse dynamics: implicit-midpoint", ..SETTING },
    Setting { key: "acados", form: SettingForm::Switch(|asked| &mut asked.for_c.acados), group: FILE | C, needs: Some("steps"),
        help: "In C, add these steps as discrete dynamics of acados", ..SETTING },
    Setting { key: "crate", form: SettingForm::Runtime, example: r#"crate = "::homogen""#, name: Some("runtime"), ..SETTING },
];

/// The keys of attributes.
pub fn of_attributes() -> impl Iterator<Item = &'static Setting> {
    SETTINGS
        .iter()
        .filter(|setting| !setting.example.is_empty())
}

/// The table of the guide: each option, with the key of attributes.
#[must_use]
pub fn page() -> String {
    let mut page = "| option | in attributes | |\n|---|---|---|\n".to_owned();
    for setting in SETTINGS.iter().filter(|setting| setting.group != 0) {
        let (flag, value) = (setting.flag_name(), setting.value);
        let flag = if setting.may_stand_alone() {
            format!("--{flag}[={value}]")
        } else {
            format!("--{flag} {value}")
        };
        let examples = setting.example.split(", or ");
        let examples = examples.filter(|example| !example.is_empty());
        let examples: Vec<String> = examples.map(|example| format!("`{example}`")).collect();
        let (flag, examples, help) = (flag.trim_end(), examples.join(", "), setting.help);
        // Writing to a string cannot fail.
        let _ = writeln!(page, "| `{flag}` | {examples} | {help} |");
    }
    page
}

impl Setting {
    /// True if an option has several values, with commas between them.
    #[must_use]
    pub fn has_list(&self) -> bool {
        let listed = matches!(
            self.form,
            SettingForm::Names(_) | SettingForm::External(_) | SettingForm::Functions
        );
        listed && self.value.ends_with(",…")
    }

    /// True if an option may stand without a value; a value follows `=` then.
    #[must_use]
    pub const fn may_stand_alone(&self) -> bool {
        matches!(
            self.form,
            SettingForm::Actuator(_, Some(_)) | SettingForm::Pairs(..)
        )
    }

    /// The option of the command line, without dashes.
    #[must_use]
    pub fn flag_name(&self) -> String {
        self.name.unwrap_or(self.key).replace('_', "-")
    }
}
