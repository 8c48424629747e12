//! A floating root: the base is carried by a floating joint, and frame 0 is a new link, the world.
//!
//! In: a description, and a request for a floating base. Out: the description with one more joint and one more link,
//! and the request with that link as its base. The joint that carried the base now carries the new link, and so is left
//! out. Nothing else changes.

use std::rc::Rc;

use crate::description::{Description, Joint, Link, Name};
use crate::joint::JointKind;
use crate::joint::actuator::Actuator;
use crate::number::Number;
use crate::request::Request;

/// Names of the joint and of its parent link; the first that is not taken.
const JOINTS: [&str; 3] = ["root", "root_joint", "free_root"];
const LINKS: [&str; 4] = ["world", "ground", "universe", "free_root_base"];

/// The description and the request, with a floating root if it is requested.
///
/// Without a single root they stay as they are, and a later stage reports the error.
pub(super) fn freed(
    description: &Description,
    request: &Request,
) -> (Rc<Description>, Rc<Request>) {
    let mut description = description.clone();
    let wanted = request.floating.then(|| base(&description, request));
    let Some(base) = wanted.flatten() else {
        return (Rc::new(description), Rc::new(request.clone()));
    };
    let links: Vec<&Name> = description.links.iter().map(|link| &link.name).collect();
    let joints: Vec<&Name> = description.joints.iter().map(|joint| &joint.name).collect();
    let ground = new_name(&LINKS, &links, &base);
    let root = new_name(&JOINTS, &joints, &base);
    let place = base.place;
    // Joints may mimic the one that carried the base, so it stays upstream.
    for joint in &mut description.joints {
        if joint.child.text == base.text {
            joint.child = ground.clone();
        }
    }
    description.links.push(Link {
        name: ground.clone(),
        inertial: None,
    });
    description.joints.push(Joint {
        name: root,
        kind: JointKind::Floating,
        parent: ground.clone(),
        child: base,
        origin: Vec::new(),
        axis: [Number::default(); 3],
        second_axis: [Number::default(); 3],
        limits: None,
        mimic: None,
        actuator: Actuator::default(),
        place,
    });
    let request = Request {
        base: Some(ground),
        floating: false,
        ..request.clone()
    };
    (Rc::new(description), Rc::new(request))
}

/// The base link: the one that is named, or the only one without a parent.
fn base(description: &Description, request: &Request) -> Option<Name> {
    let links = description.links.iter().map(|link| &link.name);
    if let Some(base) = &request.base {
        return links
            .into_iter()
            .find(|link| link.text == base.text)
            .cloned();
    }
    let carried = |link: &&Name| {
        let mut joints = description.joints.iter();
        joints.any(|joint| joint.child.text == link.text)
    };
    let mut roots = links.filter(|link| !carried(link));
    let root = roots.next()?;
    roots.next().is_none().then(|| root.clone())
}

/// The first of some names that is not taken, with a place.
fn new_name(names: &[&str], taken: &[&Name], at: &Name) -> Name {
    let free = |name: &&&str| taken.iter().all(|other| other.text != **name);
    let name = names.iter().find(free).or(names.last());
    Name {
        text: (*name.unwrap_or(&"")).to_owned(),
        place: at.place,
    }
}
