//! A free root: the base hangs on a floating joint, and frame 0 is that of no link.
//!
//! In: a description, and a request for a free base. Out: the description with one joint and one link
//! more, and the request with that link as its base. What carried the base before carries that link, and so is
//! left out. It changes nothing else that was described.

use std::rc::Rc;

use crate::description::{Description, Joint, Link, Name};
use crate::joint::JointKind;
use crate::joint::drive::Parts;
use crate::number::Number;
use crate::request::Request;

/// What the joint is called, and the link that it hangs on; the first names that nothing else has.
const JOINTS: [&str; 3] = ["root", "root_joint", "free_root"];
const LINKS: [&str; 4] = ["world", "ground", "universe", "free_root_base"];

/// Both as they are, or with a free root where one is asked for.
///
/// Where there is no root, or more than one, they stay as they are: the chain stage says so.
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
    // Joints may follow what carried the base, which stays in its place upstream.
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
        drive: Parts::default(),
        place,
    });
    let request = Request {
        base: Some(ground),
        floating: false,
        ..request.clone()
    };
    (Rc::new(description), Rc::new(request))
}

/// The link that is to be free: the one named as the base, or the only one that hangs on none.
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

/// The first of some names that is not taken, where something stands.
fn new_name(names: &[&str], taken: &[&Name], at: &Name) -> Name {
    let free = |name: &&&str| taken.iter().all(|other| other.text != **name);
    let name = names.iter().find(free).or(names.last());
    Name {
        text: (*name.unwrap_or(&"")).to_owned(),
        place: at.place,
    }
}
