//! `<mesh>` of the assets: volume, centre of mass and inertia tensor of a mesh.
//!
//! A file is opened only if its mass is needed, and each mesh is computed once.

mod file;
mod hull;
mod measure;

use std::path::PathBuf;
use std::rc::Rc;

use super::assets::{Asset, MeshInertia};
use super::element::Element;
use super::files::MODEL;
use super::model::Model;
use super::reading::Mjcf;
use super::values::Attributes;
use crate::description::Name;
use crate::description::load::load;
use crate::error::Diagnostic;
use crate::wording::{known, quoted};

/// Maximum number of values in a mesh that is written in the XML file.
const MOST_NUMBERS: usize = 10_000_000;

/// Method for the inertia of a mesh: MuJoCo's `inertia`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum InertiaMethod {
    /// Signed volumes, for a mesh without holes.
    Exact,
    /// Absolute volumes of pyramids.
    Legacy,
    /// Areas of faces.
    Shell,
    /// The convex hull.
    Convex,
}

const INERTIA_METHODS: [(&str, InertiaMethod); 4] = [
    ("exact", InertiaMethod::Exact),
    ("legacy", InertiaMethod::Legacy),
    ("shell", InertiaMethod::Shell),
    ("convex", InertiaMethod::Convex),
];

/// Vertices, and the indices of the three vertices of each face.
#[derive(Clone, Debug, Default, PartialEq)]
struct Mesh {
    corners: Vec<[f64; 3]>,
    faces: Vec<[usize; 3]>,
}

impl<'a> Mjcf<'a> {
    /// Collects the `<mesh>`, `<hfield>` and `<model>` elements of the current model by name.
    pub(super) fn list_assets(&mut self, root: Element<'a>) {
        let model = self.current;
        for section in root.named("asset") {
            for element in section.named("mesh") {
                if let Some(name) = self.asset_name(element) {
                    let asset = Asset { model, element };
                    self.model_mut().assets.meshes.insert(name, asset);
                }
            }
            for element in section.named("hfield") {
                if let Some(name) = self.asset_name(element) {
                    let asset = Asset { model, element };
                    self.model_mut().assets.height_fields.insert(name, asset);
                }
            }
            for element in section.named(MODEL) {
                self.list_model(element);
            }
        }
    }

    /// Adds a model that may be attached, by the name in the assets, or else by that in its own file.
    fn list_model(&mut self, element: Element<'a>) {
        let Some(root) = element.model() else {
            return;
        };
        let name = element.attribute("name").or(root.attribute("model"));
        let name = name.map_or_else(String::new, |name| self.word(name).text);
        let model = self.models.push(Model::new(root));
        self.model_mut().attachable.insert(name, model);
    }

    /// The name of an asset, or that of its file without folders and ending.
    fn asset_name(&mut self, element: Element<'a>) -> Option<String> {
        if let Some(name) = element.attribute("name") {
            return Some(self.word(name).text);
        }
        let file = self.word(element.attribute("file")?).text;
        let file = file.replace('\\', "/");
        let last = file.rsplit('/').next().unwrap_or_default();
        let stem = last.rsplit_once('.').map_or(last, |(stem, _)| stem);
        Some(stem.to_owned())
    }

    /// The inertia of a named mesh at density 1.
    pub(super) fn measured(&mut self, name: &Name, subject: &str) -> Option<Rc<MeshInertia>> {
        if let Some(known) = self.model().assets.measured.get(&name.text) {
            return known.clone();
        }
        let Some(&Asset { model, element }) = self.model().assets.meshes.get(&name.text) else {
            let names: Vec<&str> = self
                .model()
                .assets
                .meshes
                .keys()
                .map(String::as_str)
                .collect();
            let refusal = unknown("mesh", "meshes", name, names, subject);
            self.reader.errors.record(refusal);
            return None;
        };
        let measured = self.within(model, |mjcf| mjcf.measure(element, &name.text, subject));
        let measured = measured.map(Rc::new);
        self.model_mut()
            .assets
            .measured
            .insert(name.text.clone(), measured.clone());
        measured
    }

    fn measure(&mut self, element: Element<'a>, name: &str, subject: &str) -> Option<MeshInertia> {
        let what = format!("mesh {}", quoted(name));
        let class = self.class(element.attribute("class"));
        let attributes = Attributes {
            own: element,
            kind: "mesh",
            class: class.unwrap_or_else(|| self.model().defaults.main()),
        };
        let method = self.choice(
            attributes.get("inertia"),
            &INERTIA_METHODS,
            InertiaMethod::Legacy,
            &what,
        );
        let most = self.number(attributes.get("maxhullvert"), &what);
        let measured = self
            .corners(element, &what)
            .and_then(|(mut mesh, is_swapped)| {
                let scale = self.numbers::<3>(attributes.get("scale"), &what);
                let scale = scale.map_or([1.0; 3], |scale| scale.map(|factor| factor.value));
                let origin = self.numbers::<3>(element.attribute("refpos"), &what);
                let axes = self.numbers::<4>(element.attribute("refquat"), &what);
                let origin = origin.map_or([0.0; 3], |origin| origin.map(|entry| entry.value));
                let axes = axes.map_or([1.0, 0.0, 0.0, 0.0], |axes| axes.map(|entry| entry.value));
                let is_hull = method == InertiaMethod::Convex || mesh.faces.is_empty();
                if is_hull {
                    if most.is_some_and(|most| most.value >= 0.0) {
                        return Err("maxhullvert reduces its convex hull".to_owned());
                    }
                    mesh.faces = hull::hull(&mesh.corners)?;
                }
                let edges = measure::twice_used(&mesh);
                if method == InertiaMethod::Exact && edges {
                    return Err(
                        "its faces are not consistently oriented, as inertia=\"exact\" requires"
                            .to_owned(),
                    );
                }
                let is_mirrored = scale[0].signum() * scale[1].signum() * scale[2].signum() < 0.0;
                mesh.place(origin, axes, scale, is_mirrored && (is_hull || !is_swapped));
                let mut measured = mesh.measured(method)?;
                if self.fits_extents() {
                    measured.corners = mesh.corners;
                }
                Ok(measured)
            });
        match measured {
            Ok(measured) => Some(measured),
            Err(reason) => {
                let message = format!("cannot compute the mass of {subject} from {what}: {reason}");
                let hint = "give its body an <inertial>, or the geom mass=\"0\"";
                self.refuse(element, message, hint);
                None
            }
        }
    }

    /// Vertices and faces, and true if the faces of a mirrored mesh must not be reversed.
    fn corners(&mut self, element: Element<'a>, what: &str) -> Result<(Mesh, bool), String> {
        if element.attribute("builtin").is_some() || !element.named("plugin").is_empty() {
            return Err("meshes generated by MuJoCo are not supported".to_owned());
        }
        if let Some(written) = element.attribute("file") {
            let written = self.word(written).text;
            return self.corners_of_file(element, &written);
        }
        let mut list = |name: &str| {
            let written = element.attribute(name)?;
            let numbers = self.list(written, 0..=MOST_NUMBERS, what)?;
            Some(
                numbers
                    .iter()
                    .map(|number| number.value)
                    .collect::<Vec<f64>>(),
            )
        };
        let corners = list("vertex").ok_or("it has neither file nor vertex")?;
        let faces = list("face").unwrap_or_default();
        file::of_numbers(&corners, &faces).map(|mesh| (mesh, false))
    }

    fn corners_of_file(
        &mut self,
        element: Element<'a>,
        written: &str,
    ) -> Result<(Mesh, bool), String> {
        let folder = self.folder.clone();
        let folder = folder.ok_or("a text without a file has no folder")?;
        let mut name = written.replace('\\', "/");
        if self.model().compiler.strip {
            name = name.rsplit('/').next().unwrap_or_default().to_owned();
        }
        let of_model = self.model().root.file().folder();
        let meshes = folder.join(of_model);
        let meshes = meshes.join(self.model().compiler.meshes.replace('\\', "/"));
        // As in MuJoCo: relative to the model's first file, or else to the file that contains the element.
        let beside = element.file().folder();
        let beside = beside.strip_prefix(of_model).unwrap_or(beside);
        let beside = beside.trim_start_matches('/');
        let paths: [PathBuf; 2] = [meshes.join(&name), meshes.join(beside).join(&name)];
        let path = paths.iter().find(|path| path.exists()).unwrap_or(&paths[0]);
        let bytes = load(path).map_err(|reason| format!("{}: {reason}", path.display()))?;
        self.beside.push(path.clone());
        let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
        let is_msh = ending.eq_ignore_ascii_case("msh");
        file::read(&bytes, ending)
            .map(|mesh| (mesh, is_msh))
            .map_err(|reason| format!("{}: {reason}", path.display()))
    }
}

/// The error for a name of an asset that does not exist.
pub(super) fn unknown(
    kind: &str,
    kinds: &str,
    name: &Name,
    mut names: Vec<&str>,
    subject: &str,
) -> Diagnostic {
    names.sort_unstable();
    Diagnostic {
        place: name.place,
        message: format!(
            "{subject} names a {kind} that does not exist: {}",
            quoted(&name.text)
        ),
        hint: Some(known(&name.text, kinds, &names)),
    }
}
