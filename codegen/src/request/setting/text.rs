//! Settings as options of the command line: reading them, and printing them again.

use std::num::NonZeroUsize;

use proc_macro2::TokenStream;

use super::{Setting, SettingForm};
use crate::formulation::{Formulation, FormulationReader};
use crate::function::Function;
use crate::name::Name;
use crate::number::Number;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::{Integrator, Request, Target, TargetOf};
use crate::wording::known;

impl Setting {
    /// Sets the field of a request from the value of an option, which is empty for a switch. A setting without a group
    /// has no option, and sets nothing.
    ///
    /// # Errors
    /// The error in the value.
    pub fn take(&self, text: &str, request: &mut Request) -> Result<(), String> {
        match self.form {
            SettingForm::Switch(of) => *of(request) = true,
            SettingForm::Actuator(_, Some(alone)) if text.is_empty() => *alone(request) = true,
            SettingForm::Actuator(quantity, alone) => {
                let (joint, numbers) = text.rsplit_once('=').ok_or("write JOINT=NUMBER")?;
                let numbers = numbers.split(',').map(number).collect::<Result<_, _>>()?;
                request.actuators.push((joint.into(), quantity, numbers));
                if let Some(alone) = alone {
                    *alone(request) = true;
                }
            }
            SettingForm::Pairs(of, alone) => {
                *alone(request) = true;
                if !text.is_empty() {
                    let (first, second) = text.rsplit_once(':').ok_or("write LINK:LINK")?;
                    of(request).push([first.into(), second.into()]);
                }
            }
            SettingForm::Name(of) => *of(request) = Some(text.into()),
            SettingForm::Names(of) | SettingForm::External(of) => of(request).push(text.into()),
            SettingForm::Positions(of) => of(request).push(match text.rsplit_once('=') {
                Some((joint, at)) => (joint.into(), Some(number(at)?)),
                None => (text.into(), None),
            }),
            SettingForm::Gravity if text == "none" => request.gravity = Some(Default::default()),
            SettingForm::Gravity => {
                let entries: Vec<Number> = text.split(',').map(number).collect::<Result<_, _>>()?;
                let refusal = "write gravity as three numbers with commas, or none";
                request.gravity = Some(entries.try_into().map_err(|_| refusal)?);
            }
            SettingForm::Count(of, _) => {
                let count = text.parse::<NonZeroUsize>();
                *of(request) = Some(count.map_err(|reason| reason.to_string())?.get());
            }
            SettingForm::Functions => request.functions.push(together(text)?),
            SettingForm::Formulation => request.formulation = formulation(text)?,
            SettingForm::Processor => {
                let refusal = |hint| format!("unknown processor\n  hint: {hint}");
                request.processor = Processor::from_name(text).map_err(refusal)?;
            }
            SettingForm::Steps => {
                let refusal = |hint| format!("unknown rule\n  hint: {hint}");
                request.for_c.steps = Some(Integrator::from_name(text).map_err(refusal)?);
            }
            SettingForm::Loops => request.loops.push(text.to_owned()),
            SettingForm::Arguments => request.arguments.push(pair(text, "write NAME=VALUE")?),
            SettingForm::Packages => request.packages.push(pair(text, "write NAME=FOLDER")?),
            SettingForm::File | SettingForm::Scalar | SettingForm::Runtime => {}
        }
        Ok(())
    }

    /// The values of the option that set the same; empty if the request has the default, `None` for a switch. Values of
    /// armature, rotors and friction are printed elsewhere, in the order of the request.
    #[must_use]
    pub fn values(&self, request: &mut Request) -> Vec<Option<String>> {
        let texts = |names: &[Name]| names.iter().map(|name| Some(name.text.clone())).collect();
        let one = |value: Option<String>| value.into_iter().map(Some).collect();
        match self.form {
            SettingForm::Switch(of) | SettingForm::Actuator(_, Some(of)) => {
                of(request).then_some(None).into_iter().collect()
            }
            SettingForm::Pairs(of, alone) => {
                let pairs = of(request).iter();
                let pairs = pairs.map(|[a, b]| Some(format!("{}:{}", a.text, b.text)));
                let pairs: Vec<Option<String>> = pairs.collect();
                let is_alone = pairs.is_empty() && *alone(request);
                pairs.into_iter().chain(is_alone.then_some(None)).collect()
            }
            SettingForm::Name(of) => texts(of(request).as_slice()),
            SettingForm::Names(of) | SettingForm::External(of) => texts(of(request)),
            SettingForm::Positions(of) => {
                let positions = of(request).iter().map(|(joint, at)| match at {
                    Some(at) => Some(format!("{}={}", joint.text, at.value)),
                    None => Some(joint.text.clone()),
                });
                positions.collect()
            }
            SettingForm::Gravity => one(request.gravity.map(|gravity| numbers(&gravity))),
            SettingForm::Count(of, _) => one(of(request).map(|count| count.to_string())),
            SettingForm::Functions => {
                let items = request.functions.iter().map(|functions| {
                    let names: Vec<&str> =
                        functions.iter().map(|function| function.name()).collect();
                    names.join("+")
                });
                let items = items.collect::<Vec<_>>().join(",");
                one(Some(items).filter(|items| !items.is_empty()))
            }
            SettingForm::Formulation => {
                let words = dashed(&request.formulation.words().join(","));
                one(Some(words).filter(|words| !words.is_empty()))
            }
            SettingForm::Processor => {
                let chosen =
                    (request.processor != Processor::Portable).then_some(request.processor);
                one(chosen.map(|processor| processor.name().to_owned()))
            }
            // Default type, for code with the runtime or for `core`.
            SettingForm::Scalar => match (request.scalar, &request.runtime) {
                (Real::Generic, _) | (Real::F64, None) => Vec::new(),
                (scalar, _) => one(Some(scalar.name().to_owned())),
            },
            SettingForm::Runtime => {
                let path = request.runtime.as_ref();
                one(path.map(spelled))
            }
            SettingForm::Steps => one(request.for_c.steps.map(|rule| rule.name().to_owned())),
            SettingForm::Loops => request.loops.iter().cloned().map(Some).collect(),
            SettingForm::Arguments => {
                let pairs = request.arguments.iter();
                let pairs = pairs.map(|(name, value)| Some(format!("{}={value}", name.text)));
                pairs.collect()
            }
            // Folders are left out, as that of the file is.
            SettingForm::File | SettingForm::Packages | SettingForm::Actuator(_, None) => {
                Vec::new()
            }
        }
    }
}

/// A name and its value.
fn pair(text: &str, hint: &str) -> Result<(Name, String), String> {
    let (name, value) = text.split_once('=').ok_or(hint)?;
    Ok((name.trim_end_matches(':').into(), value.to_owned()))
}

/// Numbers separated by commas.
pub(crate) fn numbers(numbers: &[Number]) -> String {
    let numbers = numbers.iter().map(|number| number.value.to_string());
    numbers.collect::<Vec<_>>().join(",")
}

/// A path without spaces.
pub(crate) fn spelled(path: &TokenStream) -> String {
    path.to_string().replace(' ', "")
}

fn number(text: &str) -> Result<Number, String> {
    let number = text.trim().parse::<f64>();
    let number = number.map_err(|_| format!("`{text}` is not a number"))?;
    let finite = number.is_finite().then(|| number.into());
    finite.ok_or_else(|| format!("`{text}` is not a finite number"))
}

/// The function with a name.
///
/// # Errors
/// A hint with the known names.
pub fn function(text: &str) -> Result<Function, String> {
    Function::from_name(text).ok_or_else(|| {
        let hint = known(text, "functions", &Function::names());
        format!("unknown function\n  hint: {hint}")
    })
}

/// One function, `mass_matrix`, or several, `mass_matrix+bias`.
///
/// # Errors
/// An unknown or repeated function.
pub fn together(text: &str) -> Result<Vec<Function>, String> {
    let mut functions = Vec::new();
    for name in text.split('+') {
        let function = function(name)?;
        if functions.contains(&function) {
            return Err(format!("{name} occurs twice"));
        }
        functions.push(function);
    }
    Ok(functions)
}

/// The number of the description that a field takes the place of: `mass_of:hand`, `gravity`.
///
/// # Errors
/// An unknown word: a hint that lists the known ones. A word without its name.
pub fn target(text: &str) -> Result<Target, String> {
    let (word, name) = match text.split_once(':') {
        Some((word, name)) => (word, Some(name)),
        None => (text, None),
    };
    match (Target::of(word), name) {
        (Some(TargetOf::Item(of)), Some(name)) => Ok(of(name.into())),
        (Some(TargetOf::Robot(of)), None) => Ok(of()),
        (Some(TargetOf::Item(_)), None) => Err(format!("`{word}` needs a name: {word}:hand")),
        _ => Err(format!(
            "a field cannot stand for `{text}`\n  hint: {}",
            known(word, "words", &Target::keys())
        )),
    }
}

/// The words of attributes, with dashes.
fn formulation(text: &str) -> Result<Formulation, String> {
    let mut reader = FormulationReader::default();
    for item in text.split(',') {
        let (word, value) = match item.split_once('=') {
            Some((word, value)) => (word, Some(value.trim())),
            None => (item, None),
        };
        let word = word.trim().replace('-', "_");
        let refused = reader.take(&word, value);
        refused
            .map_err(|refusal| dashed(&format!("{}\n  hint: {}", refusal.message, refusal.hint)))?;
    }
    Ok(reader.formulation())
}

fn dashed(words: &str) -> String {
    words.replace(" = ", "=").replace('_', "-")
}

#[cfg(test)]
mod tests {
    use super::super::{SETTINGS, SettingForm};
    use crate::request::Request;

    #[test]
    fn options_are_printed_as_they_are_read() {
        for (flag, value) in [
            ("arguments", "type=a b"),
            ("base", "a b"),
            ("lock", "elbow"),
            ("lock", "a=b=-0.25"),
            ("drop", "hand"),
            ("loop", "pin: spherical { from: a, to: b }"),
            ("gravity", "0,-0,-1.62"),
            ("external", "hand"),
            ("processor", "cortex-m4"),
            ("formulation", "frame-0,refined=1"),
            ("functions", "gravity+bias"),
            ("section", "12"),
        ] {
            let mut settings = SETTINGS.iter();
            let setting = settings.find(|setting| setting.flag_name() == flag);
            let (setting, mut request) = (setting.expect(flag), Request::default());
            assert!(setting.values(&mut request).is_empty(), "{flag}");
            assert_eq!(setting.take(value, &mut request), Ok(()), "{flag}");
            assert_eq!(setting.values(&mut request), [Some(value.to_owned())]);
        }
    }

    #[test]
    fn each_switch_sets_its_own() {
        let is_switch = |form| matches!(form, SettingForm::Switch(_));
        let switches = || SETTINGS.iter().filter(|setting| is_switch(setting.form));
        for setting in switches() {
            let mut request = Request::default();
            assert_eq!(setting.take("", &mut request), Ok(()), "{}", setting.key);
            let set = switches().filter(|other| !other.values(&mut request).is_empty());
            assert_eq!(
                set.map(|other| other.key).collect::<Vec<_>>(),
                [setting.key]
            );
        }
    }
}
