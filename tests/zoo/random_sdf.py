"""Random SDF files: models, links, frames and joints in any placement, of all versions.

In: a folder and a seed. Out: a file and the models that it includes, the same for the same seed. Drake reads every
file: inertias are physical, axes of universal joints are perpendicular, names exist. Balls, gearboxes and mimic joints
are missing, because Drake has other coordinates for them or does not read them.
"""

import math
import random
from pathlib import Path

import numpy as np


def write(folder, seed):
    """Writes the files of a robot; returns the path of the main one."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    rng = random.Random(seed)
    version = rng.choice(["1.4", "1.5", "1.6", "1.7", "1.8", "1.9", "1.10", "1.11", "1.12"])
    (folder / "robot.sdf").write_text(File(rng, folder, version).text())
    return folder / "robot.sdf"


class File:
    """A file under construction."""

    def __init__(self, rng, folder, version):
        self.rng, self.folder, self.version = rng, folder, version
        self.minor = int(version.split(".")[1])

    def number(self, reach=1.0):
        return f"{self.rng.uniform(-reach, reach):.{self.rng.choice([1, 2, 4, 17])}g}"

    def angle(self):
        return self.rng.choice(["0", "0", f"{math.pi / 2:.17g}", f"{-math.pi / 2:.17g}", self.number(math.pi)])

    def vector(self, reach=0.5):
        return " ".join(self.rng.choice(["0", self.number(reach), self.number(reach)]) for _ in range(3))

    def direction(self):
        while True:
            found = self.rng.choice(["1 0 0", "0 1 0", "0 0 1", "0 0 -1", self.vector(1.0)])
            if np.linalg.norm([float(x) for x in found.split()]) > 0.1:
                return found

    def pose(self, frames=(), always=False):
        """A pose, relative to one of some frames."""
        rng = self.rng
        if not always and rng.random() < 0.2:
            return ""
        relative = ""
        if frames and self.minor >= 7 and rng.random() < 0.6:
            relative = f' relative_to="{rng.choice(frames)}"'
        turn = " ".join(self.angle() for _ in range(3))
        if self.minor >= 9 and rng.random() < 0.3:
            relative += ' rotation_format="quat_xyzw"'
            while True:
                turn = " ".join(self.number() for _ in range(4))
                if np.linalg.norm([float(x) for x in turn.split()]) > 0.1:
                    break
            # Drake needs quaternions of length 1.
            turn = np.array([float(x) for x in turn.split()])
            turn = " ".join(f"{x:.17g}" for x in turn / np.linalg.norm(turn))
        elif self.minor >= 9 and rng.random() < 0.3:
            relative += ' degrees="true"'
            turn = " ".join(rng.choice(["90", "-180", "0", self.number(180)]) for _ in range(3))
        return f"<pose{relative}>{self.vector()} {turn}</pose>"

    def inertial(self):
        if self.rng.random() < 0.05:
            return ""
        mass = self.rng.uniform(0.1, 3)
        sides = np.array([self.rng.uniform(0.05, 0.5) ** 2 for _ in range(3)])
        moments = mass / 12 * (sum(sides) - sides)
        tensor = np.diag(moments)
        if self.rng.random() < 0.5:
            random_state = np.random.default_rng(self.rng.randrange(10**6))
            turn = np.linalg.qr(random_state.normal(size=(3, 3)))[0]
            tensor = turn @ tensor @ turn.T
        names = [("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2)]
        entries = "".join(f"<{name}>{tensor[i, j]:.17g}</{name}>" for name, i, j in names)
        return f"<inertial>{self.pose()}<mass>{mass:.17g}</mass><inertia>{entries}</inertia></inertial>"

    def axis(self, frames, tag="axis", direction=None):
        rng = self.rng
        expressed, of_model = "", ""
        if direction is None and self.minor >= 7 and rng.random() < 0.4:
            expressed = f' expressed_in="{rng.choice(frames)}"'
        elif direction is None and self.minor in (5, 6) and rng.random() < 0.4:
            of_model = f"<use_parent_model_frame>{rng.choice(['1', 'true', '0'])}</use_parent_model_frame>"
        limit = "<limit><lower>-3</lower><upper>3</upper></limit>" if rng.random() < 0.5 else ""
        direction = direction or self.direction()
        return f"<{tag}><xyz{expressed}>{direction}</xyz>{of_model}{limit}</{tag}>"

    def joint(self, name, parent, child, frames):
        rng = self.rng
        kinds = ["revolute", "revolute", "prismatic", "fixed"]
        # The axes of version 1.4 are in the model, where a child's pose makes them oblique.
        kinds += ["universal"] if self.minor >= 5 else []
        kinds += ["continuous"] if self.minor >= 7 else []
        kinds += ["screw"] if self.minor >= 10 else []
        kind = rng.choice(kinds)
        # A pose relative to the child alone: frames of links that are placed in this joint would be a circle.
        elements = f"<parent>{parent}</parent><child>{child}</child>{self.pose()}"
        if kind == "universal":
            elements += self.axis(frames, direction="1 0 0") + self.axis(frames, "axis2", rng.choice(["0 1 0", "0 -0.6 0.8"]))
        elif kind != "fixed":
            elements += self.axis(frames)
        if kind == "screw":
            elements += f"<screw_thread_pitch>{self.number(0.2)}</screw_thread_pitch>"
        return f'<joint name="{name}" type="{kind}">{elements}</joint>'

    def model(self, name, depth):
        """A model: text, and the names by which the model around it can join it."""
        rng = self.rng
        links, frames, parts = [], ["__model__"], []
        for k in range(rng.randrange(1, 6 - 2 * depth)):
            link = f"l{k}"
            parts.append(f'<link name="{link}">{self.pose(frames)}{self.inertial()}</link>')
            if links:
                parts.append(self.joint(f"j{k}", rng.choice(links), link, [*frames, link]))
            links.append(link)
            frames.append(link)
            if self.minor >= 7 and rng.random() < 0.4:
                to = rng.choice([None, *frames])
                attached = f' attached_to="{to}"' if to else ""
                parts.append(f'<frame name="f{k}"{attached}>{self.pose(frames)}</frame>')
                frames.append(f"f{k}")
                # Joints may connect frames of earlier links.
                links += [f"f{k}"] if to in links and rng.random() < 0.5 else []
        if depth == 0 and self.minor >= 8 and rng.random() < 0.5:
            inner, names = self.inner(frames)
            parts.append(inner)
            parts.append(self.joint("mount", rng.choice(links), f"sub::{names[0]}", frames))
        if depth == 0 and rng.random() < 0.3:
            parts.append(f'<joint name="base" type="fixed"><parent>world</parent><child>l0</child></joint>')
        placement = f' placement_frame="{rng.choice(frames[1:])}"' if self.minor >= 8 and rng.random() < 0.3 else ""
        pose = self.pose() if depth == 0 else ""
        parts = self.shuffled(parts)
        return f'<model name="{name}"{placement}>{pose}{"".join(parts)}</model>', links

    def shuffled(self, parts):
        """Parts in any order, but frames in theirs: Drake misplaces a frame that is attached to a later one."""
        order = self.rng.sample(parts, len(parts))
        frames = iter([part for part in parts if part.startswith("<frame")])
        return [next(frames) if part.startswith("<frame") else part for part in order]

    def inner(self, frames):
        """A model in the model, here or in a file of its own."""
        text, links = self.model("sub", 1)
        pose = self.pose(frames)
        if self.rng.random() < 0.5:
            start = text.index(">") + 1
            return text[:start] + pose + text[start:], links
        beside = self.folder / "part"
        beside.mkdir(exist_ok=True)
        (beside / "model.sdf").write_text(f'<sdf version="{self.version}">{text}</sdf>')
        return f"<include><uri>model://part/model.sdf</uri><name>sub</name>{pose}</include>", links

    def text(self):
        return f'<?xml version="1.0"?>\n<sdf version="{self.version}">{self.model("robot", 0)[0]}</sdf>\n'
