//! Random robots with arbitrary names.
//!
//! In: a seed. Out: the text of a file, and the options of the command line that name its parts. Joints and functions
//! are few: these tests are about names, and about the tests that files contain.

use std::collections::BTreeSet;
use std::fmt::Write;

use homogen_random::Random;

use crate::pool::{identifier, name};

/// A robot and the options of its request.
#[derive(Clone, Debug)]
pub struct Robot {
    /// Its name, from the file or from an option.
    pub name: String,
    /// The text of the file.
    pub urdf: String,
    /// The options, without the language and the output. Python has no `--prepare`.
    pub options: Vec<String>,
}

/// Functions to choose from.
const FUNCTIONS: [&str; 20] = [
    "forward_kinematics",
    "body_jacobian",
    "geometric_jacobian_rate",
    "velocity",
    "acceleration",
    "inverse_dynamics",
    "gravity",
    "bias",
    "mass_matrix",
    "mass_matrix_inverse",
    "forward_dynamics",
    "regressor",
    "base_regressor",
    "kinetic_energy",
    "center_of_mass",
    "centroidal_momentum",
    "momentum",
    "inverse_dynamics_derivatives",
    "mass_matrix+bias",
    "center_of_mass_velocity",
];

/// Functions of robots with loops.
const OF_LOOPS: [&str; 3] = ["constraint", "constraint_jacobian", "constraint_bias"];

/// Types of joints, and whether each has an `<axis>`.
const KINDS: [(&str, bool); 9] = [
    ("revolute", true),
    ("continuous", true),
    ("prismatic", true),
    ("spherical", false),
    ("planar", true),
    ("floating", false),
    ("cylindrical", true),
    ("universal", true),
    ("translation", false),
];

impl Robot {
    /// The robot of a seed.
    #[must_use]
    pub fn of(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let random = &mut random;
        let has_loop = random.chance(6);
        let count = if has_loop { 3 } else { 1 + random.below(3) };
        let links = distinct(random, count + 1);
        let joints = distinct(random, count);
        let called = name(random);
        let urdf = urdf(random, (&called, &links, &joints), has_loop);
        let mut robot = Self {
            name: called,
            urdf,
            options: Vec::new(),
        };
        robot.ask(random, &links, has_loop);
        robot
    }

    fn ask(&mut self, random: &mut Random, links: &[String], has_loop: bool) {
        if random.chance(3) {
            let name = identifier(random);
            name.trim_start_matches("r#").clone_into(&mut self.name);
            self.option("name", &name);
        }
        let last = links.len() - 1;
        // A comma separates names in these options.
        let tip = &links[if has_loop { last - 1 } else { last }];
        self.option("tip", tip);
        if random.chance(3) && !links[1].contains(',') {
            self.option("frames", &links[1]);
        }
        if random.chance(4) && !has_loop {
            self.options.push("--floating".to_owned());
        }
        let mut functions = BTreeSet::new();
        for _ in 0..2 + random.below(3) {
            functions.insert(*random.choose(&FUNCTIONS));
        }
        if has_loop {
            functions.insert(*random.choose(&OF_LOOPS));
            let loop_name = name(random);
            let text = format!(
                "{loop_name:?}: revolute(z) {{ from: {:?}, to: {:?}, at: xyz(0.3, 0, 0), to_at: xyz(0.2, 0, 0) }}",
                links[2], links[3]
            );
            self.option("loop", &text);
        }
        let scalar = *random.choose(&["f32", "f64"]);
        self.option("scalar", scalar);
        let has_fields = self.fields(random, &links[1]);
        // Such robots may be unable to have these functions.
        functions.retain(|function| match *function {
            "base_regressor" => !has_fields,
            "mass_matrix_inverse" | "forward_dynamics" => scalar == "f64",
            _ => true,
        });
        functions.insert("gravity");
        let functions: Vec<&str> = functions.into_iter().collect();
        self.option("functions", &functions.join(","));
    }

    /// Adds options for fields. Returns true if there are any.
    fn fields(&mut self, random: &mut Random, link: &str) -> bool {
        let mut fields = BTreeSet::new();
        let mut has_gravity = false;
        let targets = [
            (format!("mass_of:{link}"), 3),
            (format!("com_of:{link}"), 4),
            ("gravity".to_owned(), 4),
        ];
        for (target, chance) in targets {
            let field = identifier(random);
            let alike = field.trim_start_matches("r#").to_owned();
            if random.chance(chance) && fields.insert(alike) {
                self.option("field", &format!("{field}={target}"));
                has_gravity |= target == "gravity";
            }
        }
        // The gravity torques of every robot have a part that depends on gravity alone.
        if has_gravity && random.chance(2) {
            self.options.push("--prepare".to_owned());
        }
        !fields.is_empty()
    }

    fn option(&mut self, option: &str, value: &str) {
        self.options.push(format!("--{option}={value}"));
    }
}

/// `count` different names.
fn distinct(random: &mut Random, count: usize) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    while names.len() < count {
        let name = name(random);
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn urdf(
    random: &mut Random,
    (name, links, joints): (&str, &[String], &[String]),
    has_loop: bool,
) -> String {
    let mut text = format!("<robot name=\"{}\">\n", escaped(name));
    for (k, link) in links.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "  <link name=\"{}\"><inertial><origin xyz=\"0.1 0.0{k} -0.03\"/><mass value=\"1.{k}\"/>\
             <inertia ixx=\"0.02\" ixy=\"0.001\" ixz=\"-0.002\" iyy=\"0.03\" iyz=\"0.0005\" izz=\"0.025\"/>\
             </inertial></link>",
            escaped(link)
        );
    }
    for (k, joint) in joints.iter().enumerate() {
        // In a loop, the third joint is a sibling of the first.
        let parent = if has_loop && k == 2 { 0 } else { k };
        let (kind, motion) = if has_loop {
            ("continuous", "<axis xyz=\"0 0 1\"/>".to_owned())
        } else {
            moving(random)
        };
        let rpy = if has_loop { "0 0 0" } else { "0.1 0.2 0.3" };
        let _ = writeln!(
            text,
            "  <joint name=\"{}\" type=\"{kind}\"><parent link=\"{}\"/><child link=\"{}\"/>\
             <origin xyz=\"0.2 0 0\" rpy=\"{rpy}\"/>{motion}</joint>",
            escaped(joint),
            escaped(&links[parent]),
            escaped(&links[k + 1])
        );
    }
    text + "</robot>\n"
}

/// The type of a joint, and its elements `<axis>` and `<limit>`.
fn moving(random: &mut Random) -> (&'static str, String) {
    let (kind, has_axis) = *random.choose(&KINDS);
    let axis = random.choose(&["1 0 0", "0 1 0", "0.6 0 0.8"]);
    let axis = format!("<axis xyz=\"{axis}\"/>");
    let motion = match kind {
        "universal" => "<axis xyz=\"1 0 0\"/><axis2 xyz=\"0 1 0\"/>".to_owned(),
        "revolute" | "prismatic" => {
            let most = random.choose(&["2", "0.5", "3000", "1e6"]);
            format!(
                "{axis}<limit lower=\"-{most}\" upper=\"{most}\" effort=\"50\" velocity=\"3\"/>"
            )
        }
        _ if has_axis => axis,
        _ => String::new(),
    };
    (kind, motion)
}

/// A text, escaped for an attribute in XML.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '"' => escaped.push_str("&quot;"),
            letter => escaped.push(letter),
        }
    }
    escaped
}
