//! Collision spheres: their names and pairs, and requests for them that are refused.

use super::lines;
use crate::builder::Builder;
use crate::description::read_text;
use crate::error::Errors;
use crate::function::Function;

/// A robot of links a to e in a row, with the spheres of each, and c fixed to b.
fn row(spheres: [usize; 5]) -> String {
    let sphere = "<collision><geometry><sphere radius=\"0.1\"/></geometry></collision>";
    let links = ["a", "b", "c", "d", "e"].iter().zip(spheres);
    let links =
        links.map(|(name, count)| format!("<link name=\"{name}\">{}</link>", sphere.repeat(count)));
    let joints = [("a", "b"), ("b", "c"), ("c", "d"), ("d", "e")];
    let joints = joints.map(|(parent, child)| {
        let kind = if child == "c" { "fixed" } else { "continuous" };
        format!(
            "<joint name=\"to_{child}\" type=\"{kind}\"><origin xyz=\"1 0 0\"/><parent link=\"{parent}\"/>\
             <child link=\"{child}\"/><axis xyz=\"0 0 1\"/></joint>"
        )
    });
    let links: String = links.collect();
    format!("<robot name=\"row\">{links}{}</robot>", joints.concat())
}

fn read(text: &str) -> Builder {
    let mut errors = Errors::new();
    let description = read_text(text, "row.urdf", None, &mut errors);
    Builder::from_description(description.unwrap_or_else(|| panic!("{errors}")))
}

fn builder(spheres: [usize; 5]) -> Builder {
    read(&row(spheres)).generate([Function::Distances])
}

fn pairs(builder: &Builder) -> Vec<String> {
    let module = builder.module().unwrap_or_else(|errors| panic!("{errors}"));
    let pairs = module.spaces.pairs.iter();
    pairs.map(|pair| pair.name.clone()).collect()
}

fn refused(builder: &Builder) -> String {
    builder.module().expect_err("a mistake").to_string()
}

#[test]
fn spheres_on_links_that_a_joint_joins_are_no_pairs() {
    let found = pairs(&builder([1, 1, 2, 1, 1]).collision());
    // The joint to d joins it to the body of b and c.
    assert_eq!(found, ["a/d", "a/e", "b/e", "c_1/e", "c_2/e"]);
}

#[test]
fn pairs_of_named_links_may_be_neighbours_in_either_order() {
    let asked = builder([1, 1, 2, 1, 1]).collision_between("d", "c");
    assert_eq!(
        pairs(&asked.collision_between("a", "b")),
        ["a/b", "c_1/d", "c_2/d"]
    );
}

#[test]
fn a_joint_with_several_velocities_joins_its_links() {
    let text = row([1, 1, 0, 0, 0]).replace("continuous", "floating");
    let builder = read(&text).collision();
    let refusal = refused(&builder.generate([Function::Distances]));
    assert!(refusal.contains("no two spheres"), "{refusal}");
}

#[test]
fn spheres_have_to_be_asked_for_and_to_be_there() {
    assert_eq!(
        refused(&builder([1; 5])),
        lines(&[
            "error: row.urdf:1:14: \"distances\" is of collision spheres, which are not modelled",
            "  hint: ask for them: collision",
        ])
    );
    assert_eq!(
        refused(&builder([0; 5]).collision()),
        lines(&[
            "error: row.urdf:1:14: the description has no collision spheres",
            "  hint: write them in links of a URDF: <collision><origin xyz=\"0 0 0.1\"/><geometry>\
             <sphere radius=\"0.05\"/></geometry></collision>",
        ])
    );
    let refusal = refused(&builder([1; 5]).collision_between("a", "f"));
    assert!(refusal.contains("there is no link \"f\""), "{refusal}");
    let unread = read(&row([1; 5])).collision();
    let refusal = refused(&unread.generate([Function::ForwardKinematics]));
    assert!(refusal.contains("no function reads them"), "{refusal}");
}

#[test]
fn each_pair_of_links_that_is_named_has_a_distance() {
    let between = |a: &str, b: &str| refused(&builder([0, 1, 1, 1, 1]).collision_between(a, b));
    assert!(between("a", "d").contains("link \"a\" has no collision sphere"));
    assert!(between("b", "c").contains("links \"b\" and \"c\" do not move relative to each other"));
    let dropped = builder([1; 5]).drop("e").collision_between("a", "e");
    assert!(refused(&dropped).contains("link \"e\" is not modelled"));
}

#[test]
fn there_are_not_too_many_pairs() {
    let refusal = refused(&builder([200, 0, 0, 0, 100]).collision());
    assert!(refusal.contains("there are 44850 pairs"), "{refusal}");
    let few = builder([200, 1, 0, 0, 100]).collision_between("b", "e");
    assert_eq!(pairs(&few).len(), 100);
}

#[test]
fn a_mistake_in_a_sphere_counts_where_spheres_are_asked_for() {
    let text = row([1; 5]).replacen("0.1", "-0.1", 1);
    let all = read(&text);
    let without = all.clone().generate([Function::ForwardKinematics]);
    assert!(without.module().is_ok());
    let refusal = refused(&all.collision().generate([Function::SphereCenters]));
    assert!(refusal.contains("is not positive: -0.1"), "{refusal}");
}

#[test]
fn all_functions_are_with_those_of_spheres_where_these_are_asked_for() {
    let of_spheres = |builder: Builder| {
        let module = builder.module().expect("a robot");
        let functions = module
            .functions
            .iter()
            .flat_map(|generated| &generated.functions);
        functions
            .filter(|function| function.is_of_spheres())
            .count()
    };
    let all = || read(&row([1; 5]));
    assert_eq!(of_spheres(all()), 0);
    assert_eq!(of_spheres(all().collision()), 3);
}
