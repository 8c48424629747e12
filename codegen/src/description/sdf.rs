//! SDF, the format of Gazebo and Drake, versions 1.4 to 1.12.
//!
//! Reads the model of a file and the models that it includes into a [`Description`], as far as URDF reaches. Links stay
//! links, named frames become massless links, and a joint away from the frame of its child moves an auxiliary link. The
//! root link is the fixed base; if it does not stand at the origin, the world is, so that gravity acts along −z of the
//! world. Elements of simulators without mechanics are ignored, and other mechanics are warnings. Time and memory are
//! proportional to the text and the number of included models, and no missing number is guessed.

mod element;
mod elements;
mod files;
mod frames;
mod gearbox;
mod index;
mod joint;
mod link;
mod model;
mod names;
mod pose;
mod reading;
mod root;
mod scope;

use std::collections::HashMap;
use std::path::Path;

use proc_macro2::Span;

use self::element::Element;
use self::frames::Frames;
use self::reading::Sdf;
use self::scope::WORLD;
use super::fresh::FreshNames;
use super::xml::element::Reader;
use super::xml::survey;
use super::xml::texts::Parsed;
use super::{Description, FileFormat, Given, Name, Source, names as twice};
use crate::error::{Errors, Place};

#[doc(hidden)]
pub use self::elements::page;

/// Reads the text of the file `file` in `folder`; `given` has the folders of packages, `anchor` is the token that named
/// the file, for the compiler.
///
/// A description returned together with errors is partial: good for counting joints, not for computing.
pub fn read(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    errors.set_file(file, anchor);
    let texts = files::load(text, file, folder, given, errors)?;
    let plains = texts.plains();
    let parsed = texts.parse(&plains, files::BEGINS, errors)?;
    let mut found = Errors::new();
    let description = read_files(&parsed, &mut found);
    errors.append(found);
    let mut description = description?;
    errors.warn(description.warnings.iter().cloned());
    description.source = texts.source(FileFormat::Sdf, anchor);
    twice::check(&description, errors);
    Some(description)
}

/// Reads the parsed files.
fn read_files<'a>(files: &'a [Parsed<'a>], errors: &mut Errors) -> Option<Description> {
    let root = Element::root(files, 0);
    let mut sdf = Sdf {
        reader: Reader::new(&files[0].positions),
        frames: Frames::default(),
        scopes: Vec::new(),
        links: Vec::new(),
        link_frames: Vec::new(),
        joints: Vec::new(),
        parts: HashMap::new(),
        pending: Vec::new(),
        open: Vec::new(),
        link_names: FreshNames::of([WORLD]),
        joint_names: FreshNames::default(),
        has_world: false,
    };
    let top = sdf.top(root);
    let mut gravity = None;
    let mut name = Name {
        text: "robot".to_owned(),
        place: Place::Unknown,
    };
    if let Some(top) = top {
        name = top.name;
        gravity = top.gravity;
        sdf.attach_joints();
        sdf.resolve();
        sdf.build_joints();
        sdf.add_frames();
        sdf.add_world();
        sdf.link_mimics();
    }
    sdf.survey(root);
    sdf.reader
        .warnings
        .sort_by_key(|warning| warning.place.order());
    if let Some(place) = sdf.reader.xacro {
        let hint = "expand the file first: SDF has no expressions";
        let message = "this file contains ${…}, which is not expanded";
        sdf.reader.errors.push_with_hint(place, message, hint);
    }
    let is_empty = sdf.links.is_empty();
    errors.append(sdf.reader.errors);
    if is_empty {
        if errors.is_empty() {
            errors.push(name.place, "the model has no links");
        }
        return None;
    }
    Some(Description {
        name,
        source: Source::default(),
        links: sdf.links,
        joints: sdf.joints,
        loops: Vec::new(),
        configurations: Vec::new(),
        collisions: Vec::new(),
        gravity,
        warnings: sdf.reader.warnings,
        unmodelled: sdf.reader.unmodelled,
    })
}

impl<'a> Sdf<'a> {
    /// Warns of what is not modelled, file by file.
    fn survey(&mut self, root: Element<'a>) {
        survey::survey(self.at(root), root.node, &elements::SDF);
        for file in 1..root.count() {
            let included = Element::root(root.files(), file);
            survey::survey(self.at(included), included.node, &elements::SDF);
        }
    }
}

#[cfg(test)]
mod tests;
