//! MJCF, the format of MuJoCo.
//!
//! Reads the text of a file and the files that it includes into a [`Description`] with the numbers of MuJoCo's
//! compiler, as far as rigid bodies go. Each mistake is an error with file, line and column.
//! Bodies become links, sites become massless links, the world is the fixed base, and frames are merged into the
//! placements of what they contain. Elements of the solver, contacts and visuals are ignored. Other mechanics that are
//! not modelled are reported as warnings. Time and memory are proportional to the text, and no missing number is
//! guessed.

mod actuator;
mod assets;
mod attach;
mod body;
mod class;
mod compiler;
mod defaults;
mod element;
mod elements;
mod equality;
mod expand;
mod files;
mod geom;
mod gravity;
mod inertial;
mod joint;
mod keyframe;
mod mesh;
mod model;
mod names;
mod orientation;
mod parts;
mod reading;
mod references;
mod settings;
mod shape;
mod tree;
mod unmodelled;
mod values;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use proc_macro2::Span;

use self::element::Element;
use self::model::Model;
use self::names::Names;
use self::parts::ModelId;
use self::reading::Mjcf;
use self::tree::Tree;
use self::unmodelled::Noted;
use super::xml::element::Reader;
use super::xml::survey;
use super::xml::texts::Parsed;
use super::{Description, FileFormat, Name, Number, Source, names as twice, spatial};
use crate::error::{Errors, Place};
use crate::expression::Double;
use crate::list::{Id, List};

#[doc(hidden)]
pub use self::elements::page;

/// Reads the text of the file `file` in `folder`; `anchor` is the token that named the file, for the compiler.
///
/// A description returned together with errors is partial: good for counting joints, not for computing.
pub fn read(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    errors.set_file(file, anchor);
    let texts = files::load(text, file, folder, errors)?;
    let plains = texts.plains();
    let parsed = texts.parse(&plains, files::BEGINS, errors)?;
    let mut found = Errors::new();
    let (mut description, beside) = read_files(&parsed, file, folder, &mut found);
    errors.append(found);
    errors.warn(description.warnings.iter().cloned());
    description.source = texts.source(FileFormat::Mjcf, anchor);
    description.source.beside.extend(beside);
    twice::check(&description, errors);
    twice::check_loops(&description, errors);
    Some(description)
}

/// Reads the parsed files; returns the paths of further files that were read, too.
fn read_files<'a>(
    files: &'a [Parsed<'a>],
    file: &str,
    folder: Option<&Path>,
    errors: &mut Errors,
) -> (Description, Vec<PathBuf>) {
    let root = Element::root(files);
    let mut mjcf = Mjcf {
        reader: Reader::new(&files[0].positions),
        models: List::new(),
        current: ModelId::new(0),
        parts: 0,
        copies: 0,
        tree: Tree::default(),
        loop_names: Names::default(),
        noted: Noted::default(),
        folder: folder.map(Path::to_owned),
        beside: Vec::new(),
    };
    mjcf.read_models(root);
    let first = ModelId::new(0);
    let list = std::mem::take(&mut mjcf.models[first].parts.list);
    mjcf.read_tree(&list);
    mjcf.models[first].parts.list = list;
    mjcf.scale_masses();
    let scopes = mjcf.models[first].parts.scopes.clone();
    let loops = mjcf.read_equalities(&scopes);
    mjcf.read_actuators(&scopes);
    let configurations = mjcf.read_keys(&scopes);
    let gravity = mjcf.models[first].gravity.acceleration();
    let attached: BTreeSet<ModelId> = scopes.iter().map(|scope| scope.model).collect();
    for model in attached {
        mjcf.survey(mjcf.models[model].root);
    }
    let name = mjcf.robot_name(root, file);
    let warnings = std::mem::take(&mut mjcf.reader.warnings);
    let mut warnings: Vec<_> = warnings.into_iter().chain(mjcf.noted.warnings()).collect();
    warnings.sort_by_key(|warning| warning.place.order());
    errors.append(mjcf.reader.errors);
    if let Some(place) = mjcf.reader.xacro {
        let hint = "replace each ${…} by its number: MuJoCo does not expand it either";
        errors.push_with_hint(
            place,
            "this file contains ${…}, which is not expanded",
            hint,
        );
    }
    let description = Description {
        name,
        source: Source::default(),
        links: mjcf.tree.links,
        joints: mjcf.tree.joints.into(),
        loops,
        configurations,
        collisions: Vec::new(),
        gravity,
        warnings,
        unmodelled: mjcf.reader.unmodelled,
    };
    (description, mjcf.beside)
}

impl<'a> Mjcf<'a> {
    /// Reads the settings of all models, and lists their trees of bodies.
    fn read_models(&mut self, root: Element<'a>) {
        self.models.push(Model::new(root));
        while self.current < self.models.next() {
            let root = self.model().root;
            for element in root.named("compiler") {
                self.read_compiler(element);
            }
            for element in root.named("option") {
                self.read_option(element);
            }
            self.read_defaults(root);
            self.list_assets(root);
            self.current = self.current.plus(1);
        }
        for model in self.models.ids().rev() {
            self.current = model;
            let parts = self.expand(model);
            self.model_mut().parts = parts;
        }
    }

    /// The name of the model, or of the file if the model has none.
    fn robot_name(&mut self, root: Element<'a>, file: &str) -> Name {
        let written = root.attribute("model").map(|written| self.word(written));
        written
            .filter(|name| !name.text.is_empty())
            .unwrap_or_else(|| {
                let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
                let stem = if matches!(stem, "" | "-") {
                    "robot"
                } else {
                    stem
                };
                Name {
                    text: stem.to_owned(),
                    place: Place::Unknown,
                }
            })
    }

    /// Scales all masses and inertias so that the total mass is that of `settotalmass`.
    fn scale_masses(&mut self) {
        let Some(total) = self.model().compiler.total_mass else {
            return;
        };
        let inertials = self
            .tree
            .links
            .iter()
            .filter_map(|link| link.inertial.as_ref());
        let masses = inertials.map(|inertial| inertial.mass.exact());
        let mass = masses.fold(Double::ZERO, |sum, mass| sum + mass);
        if mass.is_zero() {
            return;
        }
        let factor = total.exact() / mass;
        let scale = |number: &mut Number| {
            *number = spatial::to_number(number.exact() * factor, number.place);
        };
        let links = self.tree.links.iter_mut();
        for inertial in links.filter_map(|link| link.inertial.as_mut()) {
            scale(&mut inertial.mass);
            inertial.inertia.iter_mut().for_each(scale);
        }
    }

    /// Warns of what is not modelled in a model, file by file.
    fn survey(&mut self, root: Element<'a>) {
        survey::survey(self.at(root), root.node, &elements::MJCF);
        for (element, content) in elements::included(root) {
            let reader = self.at(element);
            survey::survey_included(reader, element.node, content, &elements::MJCF);
        }
    }
}

#[cfg(test)]
mod tests;
