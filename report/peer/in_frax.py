"""A robot of `frax`, dynamics in JAX, from the file that the others have. For scripts, which import it."""

import tempfile
import xml.etree.ElementTree as xml

from frax import Robot

GRAVITY = [0.0, 0.0, 9.81, 0.0, 0.0, 0.0]


def robot(urdf, moving, free):
    """Its model: the joints `moving` in their order, on a base that is fixed or free."""
    with tempfile.NamedTemporaryFile(suffix=".urdf") as file:
        description(urdf, moving).write(file)
        file.flush()
        return Robot(file.name, joint_ordering=moving, floating_base="quaternion" if free else None)


def description(urdf, moving):
    """The robot's file as frax wants it: what does not move is fixed, and nothing is to be seen or touched."""
    tree = xml.parse(urdf)
    for joint in tree.getroot().findall("joint"):
        if joint.get("name") not in moving:
            joint.set("type", "fixed")
            for part in joint.findall("mimic"):
                joint.remove(part)
    for link in tree.getroot().findall("link"):
        for part in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(part)
    return tree
