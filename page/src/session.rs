//! An open robot, for a page that asks for one thing after the other.
//!
//! In: the bytes of a file, and requests as JSON objects with a key `do`. Out: answers as JSON, or
//! `{"errors": […], "warnings": […]}`, each with line and column in the file.
//!
//! | `do` | further keys | answer |
//! |---|---|---|
//! | `options` | | the table of options: `name`, `value`, `help`, `switch`, `repeats`, `group` |
//! | `open` | `file`, the name of the file; `options`, pairs of names and values | the robot, and the functions that it may have |
//! | `function` | `index` in that list | the function without its code, or `left_out` with the reason |
//! | `explain` | `index` of a function that has been expanded | `lines`, `code` and `names`, packed |
//! | `frame` | `link`, its index in the skeleton | `indices` of the pose and of the geometric Jacobian of its frame |
//! | `values` | `indices`; `scalar`; `states`, objects with `q`, `qd`, `qdd`, `tau` and further arguments by name, zero if absent | for each state a list of results, one for each function |
//! | `code` | `language`, `scalar`, `functions` | `files` with names and texts, and `command` |
//! | `project` | `kind`, `scalar`, `functions` | the same for a project, with its `folder` |

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::path::Path;

use serde_json::{Value, json};

use crate::firmware::{self, Board};
use crate::project::{self, Project, stem};
use crate::result::values;
use crate::{count, diagnostics, function, shown, skeleton};
use homogen_codegen::Real;
use homogen_codegen::arithmetic::OwnSines;
use homogen_codegen::builder::{Builder, Language};
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::check::Check;
use homogen_codegen::description::{Description, FileFormat, inline, read_bytes_in};
use homogen_codegen::description::{Given, xacro};
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::expand;
use homogen_codegen::expression::Input;
use homogen_codegen::formulation::Sines;
use homogen_codegen::function::Function;
use homogen_codegen::module::{GeneratedFunction, Module, name};
use homogen_codegen::plan::wanted;
use homogen_codegen::print::arrays::Order;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::text::together;
use homogen_codegen::request::setting::{
    FRAMES, FUNCTIONS, ROBOT, SCOPE, SETTINGS, SOURCE, Setting, SettingForm,
};
use homogen_codegen::schedule::{Arithmetic, run};
use homogen_codegen::space::{FrameId, Variable};

/// Options of a robot and of its functions, with the words of their groups.
const GROUPS: [(u8, &str); 5] = [
    (SCOPE, "scope"),
    (FUNCTIONS, "functions"),
    (FRAMES, "functions"),
    (ROBOT, "robot"),
    (SOURCE, "file"),
];

/// Number of states in a vector of LLVM IR.
const LANES: NonZeroUsize = NonZeroUsize::new(8).unwrap();

/// A file, and the robot that was read from it.
#[derive(Default)]
pub struct Session {
    file: Vec<u8>,
    open: Option<Open>,
}

/// A robot, with the functions that have been expanded.
struct Open {
    /// The description as written, without the loops of options.
    written: Description,
    request: Request,
    chain: Chain,
    check: Check,
    /// The file, which a firmware has a copy of.
    file: Vec<u8>,
    /// The functions that the robot may have, each with its frame.
    wanted: Vec<(Vec<Function>, FrameId)>,
    /// Functions by their indices; those of further frames follow the wanted ones.
    expanded: BTreeMap<usize, Module>,
    /// The indices of functions of further frames, by links.
    framed: BTreeMap<usize, [usize; 2]>,
}

impl Session {
    /// Takes the bytes of a file, for the next `open`.
    pub fn take(&mut self, file: Vec<u8>) {
        self.file = file;
    }

    /// The answer to a request.
    #[must_use]
    pub fn answer(&mut self, request: &str) -> String {
        let request: Value = serde_json::from_str(request).unwrap_or(Value::Null);
        let answer = match request["do"].as_str() {
            Some("options") => Ok(options()),
            Some("open") => self.open(&request),
            Some("function") => self.opened().and_then(|open| open.function(&request)),
            Some("explain") => self.opened().and_then(|open| open.explain(&request)),
            Some("frame") => self.opened().and_then(|open| open.frame(&request)),
            Some("values") => self.opened().map(|open| open.values(&request)),
            Some("code") => self.opened().and_then(|open| open.code(&request)),
            Some("project") => self.opened().and_then(|open| open.project(&request)),
            _ => Err(mistake("unknown request")),
        };
        answer.unwrap_or_else(|errors| refused(&errors)).to_string()
    }

    fn open(&mut self, asked: &Value) -> Result<Value, Errors> {
        self.open = None;
        let name = asked["file"].as_str().unwrap_or("robot");
        let request = request(&asked["options"])?;
        let mut errors = Errors::new();
        let given = Given::of(&request, Path::new(""));
        let written = read_bytes_in(&self.file, name, None, &given, None, &mut errors);
        let Some(written) = written else {
            return Err(errors);
        };
        let written = errors.into_result(written)?;
        let mut errors = Errors::new();
        let mut description = written.clone();
        let loops = request.loops.iter().map(String::as_str);
        inline::close(&mut description, loops, &mut errors);
        let description = errors.into_result(description)?;
        // The page shows the origin of each name, which an array between sections would hide.
        let mut shown_request = request.clone();
        shown_request.section = Some(usize::MAX);
        let chain = expand::understand(&description, &shown_request)?;
        let chain = expand::identified_if_asked(chain);
        let module = expand::without_functions(&chain);
        let mut answer = crate::robot(&chain, &module)?;
        let wanted: Vec<_> = wanted(&chain).into_iter().collect();
        let functions = wanted.iter();
        let functions =
            functions.map(|(functions, frame)| function::announced(&chain, functions, *frame));
        answer["functions"] = functions.collect();
        answer["format"] = json!(description.source.format.map(FileFormat::name));
        // As written, since they are values of options.
        let links = description.links.iter().map(|link| &*link.name.text);
        answer["every_link"] = links.collect();
        let joints = description.joints.iter().map(|joint| &*joint.name.text);
        answer["every_joint"] = joints.collect();
        self.open = Some(Open {
            check: Check::of(&chain)?,
            written,
            request,
            chain,
            file: self.file.clone(),
            wanted,
            expanded: BTreeMap::new(),
            framed: BTreeMap::new(),
        });
        Ok(answer)
    }

    fn opened(&mut self) -> Result<&mut Open, Errors> {
        self.open
            .as_mut()
            .ok_or_else(|| mistake("no robot is open"))
    }
}

impl Open {
    /// A function, expanded and checked.
    fn function(&mut self, asked: &Value) -> Result<Value, Errors> {
        let index = index(&asked["index"]);
        let (functions, frame) = self
            .wanted
            .get(index)
            .ok_or_else(|| mistake("unknown function"))?;
        let mut module = expand::one(&self.chain, &self.check, functions.clone(), *frame)?;
        if module.functions.is_empty() {
            // Functions without a frame are left out of every module; the page has their reason already.
            let name = name(functions, None);
            let mut left_out = module.about.left_out;
            left_out.retain(|left_out| left_out.functions.contains(&name));
            module.about.left_out = left_out;
            return Ok(json!({ "left_out": count::left_out(&module) }));
        }
        let layouts = skeleton::layouts(&self.chain, &module);
        let mut answer = function::counted(&module, &layouts).swap_remove(0);
        answer["layout"] = shown(layouts.places[layouts.of[0]].clone());
        self.expanded.insert(index, module);
        Ok(answer)
    }

    /// The code of a function that has been expanded.
    fn explain(&self, asked: &Value) -> Result<Value, Errors> {
        let module = self.expanded.get(&index(&asked["index"]));
        let module = module.ok_or_else(|| mistake("the function has not been expanded"))?;
        let mut answer = json!({});
        for (key, value) in function::explained(module).flatten() {
            answer[key] = value;
        }
        Ok(answer)
    }

    /// The pose and the geometric Jacobian of a link's frame, expanded for values.
    fn frame(&mut self, asked: &Value) -> Result<Value, Errors> {
        let link = index(&asked["link"]);
        if let Some(indices) = self.framed.get(&link) {
            return Ok(json!({ "indices": indices }));
        }
        let links = &self.chain.report.links;
        let name = links.get(link).ok_or_else(|| mistake("unknown link"))?;
        let mut request = (*self.chain.request).clone();
        request.frames = vec![name.clone().into()];
        let chain = chain::build(&self.chain.description, &request)?;
        let mut frames = chain.frames.ids();
        let frame = frames.find(|frame| chain.frames[*frame].name == *name);
        let frame = frame.ok_or_else(|| mistake("the link has no frame"))?;
        let check = Check::of(&chain)?;
        let first = self.wanted.len() + 2 * self.framed.len();
        let indices = [first, first + 1];
        let functions = [Function::ForwardKinematics, Function::GeometricJacobian];
        for (index, function) in indices.into_iter().zip(functions) {
            let module = expand::one(&chain, &check, vec![function], frame)?;
            self.expanded.insert(index, module);
        }
        self.framed.insert(link, indices);
        Ok(json!({ "indices": indices }))
    }

    /// For each state the values of functions that have been expanded, in the order of the request; null for others.
    fn values(&self, asked: &Value) -> Value {
        let indices = asked["indices"].as_array().map_or(&[][..], Vec::as_slice);
        let states = asked["states"].as_array().map_or(&[][..], Vec::as_slice);
        let scalar = scalar(asked);
        let states = states.iter().map(|state| {
            let all = indices.iter();
            let all = all.map(|at| match self.generated(index(at)) {
                Some(generated) => self.results(generated, scalar, state),
                None => Value::Null,
            });
            all.collect::<Value>()
        });
        json!({ "values": states.collect::<Value>() })
    }

    /// A function that has been expanded.
    fn generated(&self, index: usize) -> Option<&GeneratedFunction> {
        self.expanded.get(&index)?.functions.first()
    }

    /// The results of functions that are expanded together, at a state.
    fn results(&self, generated: &GeneratedFunction, scalar: Real, state: &Value) -> Value {
        let number = |variable: Variable, k: u16| {
            state[variable.name()][usize::from(k)]
                .as_f64()
                .unwrap_or(0.0)
        };
        let numbers = match (scalar, self.request.formulation.sines) {
            (Real::F32, Sines::Own) => computed::<OwnSines<f32>>(generated, number),
            (Real::F32, Sines::Platform) => computed::<f32>(generated, number),
            (_, Sines::Own) => computed::<OwnSines<f64>>(generated, number),
            (_, Sines::Platform) => computed::<f64>(generated, number),
        };
        let spaces = self.chain.spaces();
        let mut rest = &*numbers;
        let functions = generated.functions.iter().map(|function| {
            let result = function.result();
            let (own, others) = rest.split_at(result.size(spaces).min(rest.len()));
            rest = others;
            values(result, spaces, own)
        });
        functions.collect()
    }

    /// The request with a scalar type and functions.
    fn asked(&self, asked: &Value) -> Result<Request, Errors> {
        let mut request = self.request.clone();
        request.scalar = scalar(asked);
        if let Some(names) = asked["functions"].as_array() {
            let names = names.iter().map(|name| name.as_str().unwrap_or_default());
            request.functions = names
                .map(together)
                .collect::<Result<_, _>>()
                .map_err(mistake)?;
        }
        Ok(request)
    }

    /// A project, and the command that makes it.
    fn project(&self, asked: &Value) -> Result<Value, Errors> {
        let kind = asked["kind"].as_str().unwrap_or_default();
        let file = self.written.source.file.as_deref();
        let builder = Builder::from_description(self.written.clone());
        if kind == "firmware" {
            return self.firmware(builder, file);
        }
        let mut kinds = Project::ALL.into_iter();
        let project = kinds.find(|project| project.words() == kind);
        let project = project.ok_or_else(|| mistake("unknown project"))?;
        let builder = builder.request(self.asked(asked)?);
        let (files, module) = project.files(&builder)?;
        let folder = project::folder(&module.about.robot);
        let command = builder.command_of(&format!("homogen new {kind}"), file, &folder);
        Ok(named(&folder, files, &command))
    }

    /// A firmware, with its copy of the description.
    fn firmware(&self, builder: Builder, file: Option<&str>) -> Result<Value, Errors> {
        let request = firmware::scope(&self.request);
        let builder = builder.request(request.clone());
        let board = Board::M4F;
        let module = board.functions(builder.clone()).file_module()?;
        let engine = format!("\"={}\"", env!("CARGO_PKG_VERSION"));
        let mut files = firmware::files(&module, &request, &board, &engine);
        let text = match self.written.source.format {
            Some(FileFormat::Xacro) => {
                let mut errors = Errors::new();
                let text = String::from_utf8_lossy(&self.file);
                let given = Given::of(&self.request, Path::new(""));
                let name = file.unwrap_or("robot.xacro");
                let urdf = xacro::expanded(&text, name, None, &given, &mut errors);
                urdf.ok_or(errors)?
            }
            _ => String::from_utf8_lossy(&self.file).into_owned(),
        };
        files.push((
            firmware::description(self.written.source.format).to_owned(),
            text,
        ));
        let folder = format!("{}-firmware", firmware::package(&module.about.robot));
        let command = builder.command_of("homogen new firmware", file, &folder);
        Ok(named(&folder, files, &command))
    }

    /// Files in a language, and the command that makes them.
    fn code(&self, asked: &Value) -> Result<Value, Errors> {
        let file = self.written.source.file.clone();
        let builder = Builder::from_description(self.written.clone()).request(self.asked(asked)?);
        let name = stem(&self.written.name.text);
        let one = |ending: &str, text: String| json!([{ "name": format!("{name}.{ending}"), "text": text }]);
        let header = format!("{name}.h");
        let (language, files) = match asked["language"].as_str() {
            Some("c") => {
                let source = builder.c(&builder.c_module()?, &header);
                let files = json!([
                    { "name": format!("{name}.c"), "text": source.text },
                    { "name": header, "text": source.header },
                ]);
                (Language::C(&header), files)
            }
            Some("cpp") => {
                let (file, order) = (format!("{name}.hpp"), Order::AngularFirst);
                let text = builder.cpp(&builder.cpp_module()?, &file, order);
                let files = json!([{ "name": file, "text": text }]);
                let command = builder.command(
                    self.written.source.file.as_deref(),
                    Language::Cpp(&file, order),
                );
                return Ok(json!({ "files": files, "command": command }));
            }
            Some("llvm") => {
                let text = builder.llvm(&builder.compiled_module()?, LANES);
                (Language::Llvm(LANES), one("ll", text))
            }
            Some("python") => {
                let order = Order::LinearFirst;
                let text = builder.plain_python(&builder.plain_python_module()?, order);
                (Language::Python(order), one("py", text))
            }
            _ => {
                let text = builder.source(&builder.file_module()?).to_string();
                (Language::Rust, one("rs", text))
            }
        };
        let mut command = builder.command(file.as_deref(), language);
        // The command of C names its file already, beside which the header stands.
        if !matches!(language, Language::C(_)) {
            let file = files[0]["name"].as_str().unwrap_or_default();
            command = format!("{command} --output {file}");
        }
        Ok(json!({ "files": files, "command": command }))
    }
}

/// The results of a function, with arguments by their entries.
fn computed<T: Arithmetic + Copy + Into<f64>>(
    generated: &GeneratedFunction,
    number: impl Fn(Variable, u16) -> f64,
) -> Vec<f64> {
    let input = |input| match input {
        Input::Variable(variable, k) => T::literal(number(variable, k)),
        Input::Parameter(..) => unreachable!("a page has no run-time parameters"),
    };
    let results = run(&generated.program, input).into_iter();
    results.map(Into::into).collect()
}

/// The settings that are options here, each with the word of its group.
fn offered() -> impl Iterator<Item = (&'static Setting, &'static str)> {
    // Packages are folders, which a page does not have.
    let settings = SETTINGS
        .iter()
        .filter(|setting| !matches!(setting.form, SettingForm::Packages));
    settings.filter_map(|setting| {
        let group = GROUPS.iter().find(|(bit, _)| setting.group & bit != 0);
        group.map(|(_, word)| (setting, *word))
    })
}

/// The table of options.
fn options() -> Value {
    let options = offered().map(|(setting, group)| {
        let repeats = setting.has_list()
            || matches!(
                setting.form,
                SettingForm::Names(_)
                    | SettingForm::Positions(_)
                    | SettingForm::Actuator(..)
                    | SettingForm::Pairs(..)
                    | SettingForm::Arguments
                    | SettingForm::Loops
            );
        json!({
            "name": setting.flag_name(), "value": setting.value, "help": setting.help, "group": group,
            "switch": matches!(setting.form, SettingForm::Switch(_)), "repeats": repeats,
        })
    });
    json!({ "options": options.collect::<Value>(), "functions": Function::names() })
}

/// The request of pairs of names and values of options.
fn request(pairs: &Value) -> Result<Request, Errors> {
    let mut request = Request::default();
    let mut errors = Errors::new();
    for pair in pairs.as_array().map_or(&[][..], Vec::as_slice) {
        let [name, value] = [0, 1].map(|k| pair[k].as_str().unwrap_or_default());
        let Some((setting, _)) = offered().find(|(setting, _)| setting.flag_name() == name) else {
            errors.push(Place::Unknown, format!("unknown option --{name}"));
            continue;
        };
        let values = value.split(|letter| letter == ',' && setting.has_list());
        for value in values.map(str::trim) {
            if let Err(reason) = setting.take(value, &mut request) {
                let (message, hint) = match reason.split_once("\n  hint: ") {
                    Some((message, hint)) => (message.to_owned(), Some(hint.to_owned())),
                    None => (reason, None),
                };
                errors.record(homogen_codegen::error::Diagnostic {
                    place: Place::Unknown,
                    message: format!("--{name}: {message}"),
                    hint,
                });
            }
        }
    }
    errors.into_result(request)
}

fn index(value: &Value) -> usize {
    let index = value.as_u64().and_then(|index| usize::try_from(index).ok());
    index.unwrap_or(usize::MAX)
}

/// The type of numbers of a request; `f64` by default.
fn scalar(asked: &Value) -> Real {
    match asked["scalar"].as_str() {
        Some("f32") => Real::F32,
        _ => Real::F64,
    }
}

/// The answer of a project.
fn named(folder: &str, files: Vec<(String, String)>, command: &str) -> Value {
    let files = files.into_iter();
    let files = files.map(|(name, text)| json!({ "name": name, "text": text }));
    json!({ "folder": folder, "files": files.collect::<Value>(), "command": command })
}

/// An error without a place.
fn mistake(message: impl Into<String>) -> Errors {
    let mut errors = Errors::new();
    errors.push(Place::Unknown, message);
    errors
}

fn refused(errors: &Errors) -> Value {
    shown(json!({
        "errors": diagnostics::warnings(errors.diagnostics()),
        "warnings": diagnostics::warnings(errors.warnings()),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCARA: &str = include_str!("../../robots/scara.urdf");

    fn asked(session: &mut Session, request: &Value) -> Value {
        serde_json::from_str(&session.answer(&request.to_string())).expect("JSON")
    }

    fn opened(file: &str, options: &Value) -> (Session, Value) {
        let mut session = Session::default();
        session.take(file.as_bytes().to_vec());
        let open = json!({ "do": "open", "file": "robot.urdf", "options": options });
        let answer = asked(&mut session, &open);
        (session, answer)
    }

    #[test]
    fn functions_come_one_at_a_time_and_have_values() {
        let (mut session, robot) = opened(SCARA, &json!([["tip", "tool"]]));
        let functions = robot["functions"].as_array().expect("a list");
        let at = functions.iter().position(|own| own["name"] == "gravity");
        let state = json!({ "q": [0.1, 0.2, 0.3, 0.4] });
        let values = json!({ "do": "values", "indices": [at], "states": [state] });
        assert_eq!(asked(&mut session, &values)["values"], json!([[null]]));
        let function = asked(&mut session, &json!({ "do": "function", "index": at }));
        assert_eq!(function["name"], "gravity");
        assert!(function["count"]["mul"].is_u64() && function["layout"].is_array());
        let explained = asked(&mut session, &json!({ "do": "explain", "index": at }));
        assert!(explained["lines"].as_u64() > Some(1) && explained["code"].is_string());
        let found = &asked(&mut session, &values)["values"][0][0][0];
        let lift = found[2].as_f64().expect("a force of the vertical joint");
        assert!(lift.abs() > 1.0, "{found}");
    }

    #[test]
    fn every_function_is_expanded_or_left_out_with_a_reason() {
        let (mut session, robot) = opened(SCARA, &json!([]));
        for (index, own) in robot["functions"]
            .as_array()
            .expect("a list")
            .iter()
            .enumerate()
        {
            let found = asked(&mut session, &json!({ "do": "function", "index": index }));
            let reason = &found["left_out"][0]["reason"];
            assert!(
                found["name"] == own["name"] || reason.is_string(),
                "{found}"
            );
        }
    }

    #[test]
    fn frames_of_links_have_poses_and_jacobians() {
        let (mut session, robot) = opened(SCARA, &json!([["tip", "tool"]]));
        let count = robot["functions"].as_array().map_or(0, Vec::len);
        let links = robot["skeleton"]["links"].as_array().expect("a list");
        for (link, frame) in links.iter().enumerate() {
            let first = asked(&mut session, &json!({ "do": "frame", "link": link }));
            assert_eq!(
                first["indices"],
                json!([count + 2 * link, count + 2 * link + 1])
            );
            assert_eq!(
                asked(&mut session, &json!({ "do": "frame", "link": link })),
                first
            );
            let values = json!({ "do": "values", "indices": first["indices"], "states": [{}] });
            let found = &asked(&mut session, &values)["values"][0];
            assert_eq!(
                found[0][0].as_array().map(Vec::len),
                Some(4),
                "{frame}: {found}"
            );
            assert_eq!(
                found[1][0].as_array().map(Vec::len),
                Some(6),
                "{frame}: {found}"
            );
        }
        let unknown = asked(&mut session, &json!({ "do": "frame", "link": 99 }));
        assert_eq!(unknown["errors"][0]["message"], "unknown link");
    }

    #[test]
    fn projects_have_the_command_that_makes_them() {
        let (mut session, _) = opened(SCARA, &json!([["tip", "tool"]]));
        for (kind, folder, first) in [
            ("crate", "scara_robot", "Cargo.toml"),
            ("cmake", "scara_robot", "CMakeLists.txt"),
            ("cmake --language cpp", "scara_robot", "CMakeLists.txt"),
            ("python", "scara_robot", "pyproject.toml"),
            ("firmware", "scara-firmware", "Cargo.toml"),
        ] {
            let project = json!({ "do": "project", "kind": kind, "functions": ["gravity"] });
            let answer = asked(&mut session, &project);
            assert_eq!(answer["folder"], folder, "{answer}");
            assert_eq!(answer["files"][0]["name"], first, "{answer}");
            let command = answer["command"].as_str().expect("a command");
            let begin = format!("homogen new {kind} robot.urdf --tip tool");
            assert!(command.starts_with(&begin), "{command}");
            assert!(
                command.ends_with(&format!("--output {folder}")),
                "{command}"
            );
        }
    }

    #[test]
    fn mistakes_have_their_places() {
        let (_, answer) = opened("<robot name='a'>\n <joint name='b'/></robot>", &json!([]));
        let first = &answer["errors"][0];
        assert_eq!(first["line"], 2, "{answer}");
        let (_, answer) = opened(
            SCARA,
            &json!([["tip", "nowhere"], ["lock", "lift=x"], ["paint", ""]]),
        );
        assert_eq!(
            answer["errors"].as_array().map(Vec::len),
            Some(2),
            "{answer}"
        );
        let mut session = Session::default();
        assert!(session.answer("{").contains("unknown request"));
        assert!(
            session
                .answer(r#"{"do":"function","index":0}"#)
                .contains("no robot is open")
        );
    }

    #[test]
    fn code_has_the_command_that_makes_it() {
        let (mut session, _) = opened(SCARA, &json!([["tip", "tool"]]));
        for (language, ending) in [
            ("rust", "rs"),
            ("c", "c"),
            ("cpp", "hpp"),
            ("llvm", "ll"),
            ("python", "py"),
        ] {
            let code =
                json!({ "do": "code", "language": language, "functions": ["gravity", "bias"] });
            let answer = asked(&mut session, &code);
            let file = format!("scara.{ending}");
            assert_eq!(answer["files"][0]["name"], file, "{answer}");
            let command = answer["command"].as_str().expect("a command");
            assert!(
                command.starts_with("homogen generate robot.urdf --tip tool"),
                "{command}"
            );
            assert!(command.ends_with(&format!("--output {file}")), "{command}");
        }
    }
}
