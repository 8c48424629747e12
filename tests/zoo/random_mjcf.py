"""Random MJCF files: all elements and attributes that affect a rigid body, in any combination.

In: a folder and a seed. Out: a file, its included files and its meshes, the same for the same seed. MuJoCo compiles
every file: moving bodies have mass, sizes are positive, names exist. Files of odd seeds have no inertia that is summed,
full or of a mesh, and so need no principal axes, which MuJoCo computes to some 1e-6 rad. A third of the files attach
another model, which has settings of its own.
"""

import math
import random
import struct
from pathlib import Path


def write(folder, seed):
    """Writes the files of a robot; returns the path of the main one."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    robot = Robot(random.Random(seed), folder, sums(seed))
    (folder / "robot.xml").write_text(robot.text())
    return folder / "robot.xml"


def sums(seed):
    """True if bodies have inertias whose principal axes MuJoCo has to compute."""
    return seed % 2 == 0


class Robot:
    """A robot under construction."""

    def __init__(self, rng, folder, sums, is_attached=False):
        self.rng, self.folder, self.sums, self.is_attached = rng, folder, sums, is_attached
        self.most_bodies = 4 if is_attached else 9
        self.child, self.attachments, self.frames, self.coordinates = None, 0, [], []
        self.bodies_without_free = []
        self.degrees = rng.random() < 0.5
        self.bodies, self.joints, self.scalars, self.sites, self.meshes = 0, 0, [], [], {}
        self.height_fields = {}
        self.classes = ["main"] + [f"c{k}" for k in range(rng.randrange(4))]
        self.heavy = {}
        self.names = []

    # Numbers.

    def number(self, reach=1.0, digits=None):
        digits = self.rng.choice([1, 2, 3, 6, 17]) if digits is None else digits
        return f"{self.rng.uniform(-reach, reach):.{digits}g}"

    def positive(self, least, most, digits=4):
        return f"{self.rng.uniform(least, most):.{digits}g}"

    def vector(self, reach=1.0, count=3):
        return " ".join(self.rng.choice(["0", self.number(reach), self.number(reach)]) for _ in range(count))

    def direction(self):
        axes = ["1 0 0", "0 1 0", "0 0 1", "0 0 -1", "0 -2 0", "1 1 0", "0.3 -0.4 1.2"]
        while True:
            found = self.rng.choice(axes) if self.rng.random() < 0.6 else self.vector(1.0)
            if math.hypot(*map(float, found.split())) > 0.01:
                return found

    def angle(self, reach=math.pi):
        value = self.rng.choice([self.rng.uniform(-reach, reach), math.pi / 2, -math.pi / 2, math.pi])
        return f"{math.degrees(value) if self.degrees else value:.{self.rng.choice([4, 17])}g}"

    def orientation(self):
        form = self.rng.randrange(7)
        if form == 0:
            return f'quat="{self.direction()} {self.number()}"'
        if form == 1:
            return f'axisangle="{self.direction()} {self.angle()}"'
        if form == 2:
            return f'euler="{self.angle()} {self.angle()} {self.angle()}"'
        if form == 3:
            while True:
                x, y = self.direction(), self.direction()
                a, b = (list(map(float, v.split())) for v in (x, y))
                cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
                if math.hypot(*cross) > 0.05:
                    return f'xyaxes="{x} {y}"'
        if form == 4:
            return f'zaxis="{self.direction()}"'
        return ""

    def placement(self, reach=0.5):
        position = f'pos="{self.vector(reach)}"' if self.rng.random() < 0.8 else ""
        return f"{position} {self.orientation()}"

    # Parts.

    def text(self):
        rng = self.rng
        compiler = [f'angle="{"degree" if self.degrees else "radian"}"'] if not self.degrees or rng.random() < 0.5 else []
        if rng.random() < 0.5:
            compiler.append(f'eulerseq="{"".join(rng.choice("xyzXYZ") for _ in range(3))}"')
        self.inertia_from_geom = rng.choice(["auto", "auto", "auto", "true"])
        if self.inertia_from_geom != "auto" or rng.random() < 0.3:
            compiler.append(f'inertiafromgeom="{self.inertia_from_geom}"')
        self.groups = None
        if rng.random() < 0.3:
            self.groups = (0, 2)
            compiler.append('inertiagrouprange="0 2"')
        if rng.random() < 0.3:
            compiler.append(f'boundmass="{self.positive(0.001, 1)}"')
        if rng.random() < 0.3:
            compiler.append(f'boundinertia="{self.positive(0.0001, 0.05)}"')
        self.balance = rng.random() < 0.3
        if self.balance:
            compiler.append('balanceinertia="true"')
        if self.sums and rng.random() < 0.2:
            compiler.append('fitaabb="true"')
        if rng.random() < 0.15:
            compiler.append(f'settotalmass="{self.positive(1, 50)}"')
        if rng.random() < 0.2:
            compiler.append('fusestatic="false"')
        options = ""
        if rng.random() < 0.5:
            options = f'<option gravity="{self.vector(10)}"/>'
        if not self.is_attached and not options and rng.random() < 0.5:
            compiler.append(f'conflict="{rng.choice(["warning", "merge", "error"])}"')
        split = rng.randrange(len(compiler) + 1)
        defaults = self.defaults()
        if not self.is_attached and rng.random() < 0.35:
            self.child = Robot(rng, self.folder / "child", self.sums, is_attached=True)
            self.child.folder.mkdir()
            text = self.child.text()
            (self.child.folder / "model.xml").write_text(text)
            # MuJoCo leaves the values of a keyframe in joints that are attached later.
            self.most_attachments = 1 if "<key " in text else 3
        roots = [self.body(0, free=not self.is_attached and rng.random() < 0.4) for _ in range(rng.choice([1, 1, 1, 2, 3]))]
        keys = self.keys()
        if self.child:
            # MuJoCo fills a keyframe up in an order that depends on the attachments before it.
            keys = ""
            roots.insert(rng.randrange(len(roots) + 1), self.attach(is_in_world=True))
        elif self.bodies_without_free and rng.random() < 0.15:
            roots.append(f'<frame {self.placement()}><attach body="{rng.choice(self.bodies_without_free)}" prefix="copy_"/></frame>')
            keys = ""
        roots = "\n".join(roots)
        equality = self.equality()
        actuators = self.actuators()
        assets = "".join(f'<mesh name="{name}" {attributes}/>\n' for name, attributes in self.meshes.items())
        assets += "".join(f'<hfield name="{name}" {attributes}/>\n' for name, attributes in self.height_fields.items())
        if self.child:
            assets += '<model name="child" file="child/model.xml"/>\n'
        floor = "" if self.is_attached else '<geom type="plane" size="1 1 1"/>'
        sections = [
            f"<compiler {' '.join(compiler[:split])}/>",
            f"<compiler {' '.join(compiler[split:])}/>",
            options,
            defaults,
            f"<asset>{assets}</asset>",
            f"<worldbody>\n{floor}\n{roots}\n</worldbody>",
            equality,
            actuators,
            keys,
        ]
        if rng.random() < 0.3:
            (self.folder / "parts").mkdir(exist_ok=True)
            (self.folder / "parts" / "some.xml").write_text(f"<mujocoinclude>\n{sections[1]}\n{defaults}\n</mujocoinclude>\n")
            sections[1], sections[3] = '<include file="parts/some.xml"/>', ""
        return '<mujoco model="random">\n' + "\n".join(sections) + "\n</mujoco>\n"

    def defaults(self):
        """Nested default classes, each with some attributes."""
        text, closing = "", 0
        for name in self.classes:
            text += "<default>" if name == "main" else f'<default class="{name}">'
            if self.rng.random() < 0.6:
                text += f"<joint {self.joint_attributes()}/>"
            if self.rng.random() < 0.6:
                text += f"<geom {self.geom_defaults()}/>"
            closing += 1
            if name != "main" and self.rng.random() < 0.5:
                text += "</default>"
                closing -= 1
        return text + "</default>" * closing

    def joint_attributes(self):
        choices = [
            lambda: f'armature="{self.positive(0, 0.5)}"',
            lambda: f'damping="{self.positive(0, 1)}"',
            lambda: f'frictionloss="{self.positive(0, 1)}"',
            lambda: f'axis="{self.direction()}"',
            lambda: f'pos="{self.vector(0.3)}"',
            lambda: 'limited="false"',
        ]
        picked = self.rng.sample(choices, self.rng.randrange(3))
        return " ".join(attribute() for attribute in picked)

    def geom_defaults(self):
        choices = [
            lambda: f'density="{self.positive(100, 3000)}"',
            lambda: f'type="{self.rng.choice(["sphere", "capsule", "box", "cylinder", "ellipsoid"])}"',
            lambda: f'size="{self.positive(0.01, 0.1)} {self.positive(0.01, 0.1)} {self.positive(0.01, 0.1)}"',
            lambda: f'group="{self.rng.randrange(4)}"',
            lambda: f'euler="{self.angle()} {self.angle()} {self.angle()}"',
        ]
        picked = self.rng.sample(choices, self.rng.randrange(3))
        return " ".join(attribute() for attribute in picked)

    def klass(self):
        return f'class="{self.rng.choice(self.classes)}"' if self.rng.random() < 0.3 else ""

    def childclass(self):
        return f'childclass="{self.rng.choice(self.classes)}"' if self.rng.random() < 0.2 else ""

    def body(self, depth, free=False):
        rng = self.rng
        self.bodies += 1
        # Names end without a digit: MuJoCo copies elements of "j1" for the copy "0" of a replicate to a joint "j10".
        name = f"b{self.bodies}_"
        inside = []
        if free and depth == 0:
            self.coordinates += [("free", name)]
            inside.append(rng.choice([f'<freejoint name="f{self.bodies}_"/>', f'<joint type="free" name="f{self.bodies}_" armature="0"  frictionloss="0"/>']))
        else:
            self.bodies_without_free.append(name)
            inside += [self.joint(name, kind) for kind in self.kinds()]
        inside += [self.geom(always=k == 0) for k in range(rng.randrange(1, 4))]
        if self.inertia_from_geom == "auto" and rng.random() < 0.5:
            inside.append(self.inertial())
        for k in range(rng.choice([0, 0, 1])):
            self.sites.append(f"s{name}{k}_")
            inside.append(f'<site name="s{name}{k}_" {self.placement()}/>')
        if self.child and self.attachments + 1 < self.most_attachments and rng.random() < 0.2:
            inside.append(self.attach(is_in_world=False))
        if depth < 4 and self.bodies < self.most_bodies:
            for _ in range(rng.choice([0, 1, 1, 2])):
                inside.append(self.body(depth + 1))
        rng.shuffle(inside)
        if rng.random() < 0.25:
            cut = rng.randrange(len(inside) + 1)
            framed = [part for part in inside[:cut] if not part.startswith(("<inertial", "<freejoint"))]
            rest = [part for part in inside if part not in framed]
            inside = [f"<frame {self.placement()} {self.childclass()}>" + "\n".join(framed) + "</frame>"] + rest
        text = f'<body name="{name}" {self.placement()} {self.childclass()}>\n' + "\n".join(inside) + "\n</body>"
        if depth and rng.random() < 0.1:
            self.frames.append(f"frame_{name}")
            return f'<frame name="frame_{name}" {self.placement()}>{text}</frame>'
        return text

    def attach(self, is_in_world):
        """A body, a frame or the world of the other model, sometimes twice."""
        rng, child = self.rng, self.child
        self.attachments += 1
        prefix = f"child{self.attachments}_"
        form = rng.randrange(3)
        if form == 0 and is_in_world:
            self.scalars += [prefix + name for name in child.scalars]
            what = ""
        elif form == 1 and child.frames:
            what = f'frame="{rng.choice(child.frames)}"'
        else:
            what = f'body="{rng.choice(child.bodies_without_free)}"'
        text = f'<attach model="child" {what} prefix="{prefix}"/>'
        if what and self.most_attachments > 1 and rng.random() < 0.2:
            return f'<replicate count="2" offset="{self.vector()}" euler="0 0 {self.angle()}">{text}</replicate>'
        return f"<frame {self.placement()} {self.childclass()}>{text}</frame>" if rng.random() < 0.6 else text

    def keys(self):
        """Keyframes with the coordinates of the joints in the file itself."""
        if self.rng.random() < 0.5:
            return ""
        sizes = {"free": 7, "ball": 4}
        numbers = [self.positive(0.1, 1) for kind, _ in self.coordinates for _ in range(sizes.get(kind, 1))]
        return f'<keyframe><key name="home" qpos="{" ".join(numbers)}"/></keyframe>' if numbers else ""

    def kinds(self):
        """Joint types of a body: at most six velocities, and no hinge together with a ball joint."""
        rng = self.rng
        found = [rng.choice(["hinge", "hinge", "slide"]) for _ in range(rng.choice([0, 1, 1, 1, 2, 3]))]
        if rng.random() < 0.15:
            found = [kind for kind in found if kind == "slide"] + ["ball"]
        return found

    def joint(self, body, kind):
        self.joints += 1
        name = f"j{self.joints}_"
        self.coordinates.append((kind, name))
        attributes = [f'name="{name}"', self.joint_attributes()]
        attributes = [part for part in " ".join(attributes).split('" ') if part]
        text = '" '.join(attributes)
        text += "" if text.endswith('"') else '"'
        if kind != "hinge" or self.rng.random() < 0.5:
            text += f' type="{kind}"'
        if " pos=" not in text and self.rng.random() < 0.4:
            text += f' pos="{self.vector(0.3)}"'
        if kind != "ball":
            self.scalars.append(name)
            if self.rng.random() < 0.3:
                text += f' ref="{self.angle(1.0) if kind == "hinge" else self.number(0.3)}"'
            if self.rng.random() < 0.4 and "limited" not in text:
                text += ' range="-1.5 2.5" limited="true"'
        return f"<joint {text} {self.klass()}/>"

    def geom(self, always):
        rng = self.rng
        kind = rng.choice(["sphere", "capsule", "box", "cylinder", "ellipsoid", "mesh" if self.sums else "box"])
        attributes = [f'type="{kind}"', self.klass()]
        size = [self.positive(0.02, 0.2) for _ in range(3)]
        ends = kind in ("capsule", "box", "cylinder", "ellipsoid") and rng.random() < 0.3
        fitted = self.sums and kind in ("sphere", "capsule", "box", "cylinder", "ellipsoid") and rng.random() < 0.15
        heights = kind == "mesh" and rng.random() < 0.1
        if heights:
            kind = "hfield"
            attributes[0] = f'type="hfield" hfield="{self.height_field()}"'
            attributes.append(self.placement(0.2))
        elif kind == "mesh" or fitted:
            attributes.append(f'mesh="{self.mesh()}"')
            if fitted and rng.random() < 0.5:
                attributes.append(f'fitscale="{self.positive(0.5, 2)}"')
            attributes.append(self.placement(0.2))
        elif ends:
            while True:
                line = [self.number(0.3, 4) for _ in range(6)]
                if math.dist(list(map(float, line[:3])), list(map(float, line[3:]))) > 0.02:
                    break
            attributes.append(f'fromto="{" ".join(line)}" size="{size[0]}"')
        else:
            attributes.append(f'size="{" ".join(size)}"')
            attributes.append(self.placement(0.2))
        if always:
            attributes.append('group="1"')
        elif rng.random() < 0.3:
            attributes.append(f'group="{rng.randrange(5)}"')
        if not always and not self.sums:
            attributes.append('mass="0"')
        elif rng.random() < 0.3:
            attributes.append(f'mass="{self.positive(0.1, 3) if always else rng.choice(["0", self.positive(0.1, 3)])}"')
        elif rng.random() < 0.3:
            attributes.append(f'density="{self.positive(200, 4000)}"')
        if kind not in ("mesh", "ellipsoid", "hfield") and rng.random() < 0.2:
            attributes.append('shellinertia="true"')
        return f"<geom {' '.join(attributes)}/>"

    def inertial(self):
        attributes = [f'pos="{self.vector(0.2)}"', f'mass="{self.positive(0.1, 5)}"']
        moments = sorted(self.rng.uniform(0.01, 0.3) for _ in range(3))
        if self.balance and self.rng.random() < 0.5:
            moments[2] = 3 * (moments[0] + moments[1])
        else:
            moments[2] = min(moments[2], 0.95 * (moments[0] + moments[1]))
        self.rng.shuffle(moments)
        if self.sums and self.rng.random() < 0.3 and not self.balance:
            # Products of inertia small compared with the moments.
            a, b, c = (0.2 + moment for moment in moments)
            off = [f"{self.rng.uniform(-0.05, 0.05):.4g}" for _ in range(3)]
            attributes.append(f'fullinertia="{a:.6g} {b:.6g} {c:.6g} {" ".join(off)}"')
        else:
            attributes.append(f'diaginertia="{" ".join(f"{moment:.6g}" for moment in moments)}"')
            attributes.append(self.orientation())
        return f"<inertial {' '.join(attributes)}/>"

    def mesh(self):
        """An irregular box, in one of the mesh formats."""
        if self.meshes and self.rng.random() < 0.5:
            return self.rng.choice(list(self.meshes))
        rng = self.rng
        name = f"m{len(self.meshes)}"
        corners = [
            [(k >> bit & 1) * 0.3 + rng.uniform(-0.05, 0.05) + 0.1 * bit for bit in range(3)] for k in range(8)
        ]
        sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        faces = [face for a, b, c, d in sides for face in ((a, b, c), (a, c, d))]
        attributes = []
        if rng.random() < 0.5:
            attributes.append(f'scale="{self.positive(0.2, 2)} {rng.choice(["", "-"])}{self.positive(0.2, 2)} {self.positive(0.2, 2)}"')
        if rng.random() < 0.7:
            attributes.append(f'inertia="{rng.choice(["exact", "legacy", "shell", "convex"])}"')
        if rng.random() < 0.3:
            attributes.append(f'refpos="{self.vector(0.2)}" refquat="{self.direction()} {self.number()}"')
        form = rng.choice(["stl", "obj", "inline", "cloud"])
        if form == "cloud":
            # Without faces, a mesh is its convex hull.
            corners += [[rng.uniform(-0.1, 0.5) for _ in range(3)] for _ in range(rng.randrange(30))]
            attributes.append(f'vertex="{" ".join(f"{entry:.6g}" for corner in corners for entry in corner)}"')
        elif form == "inline":
            attributes.append(f'vertex="{" ".join(f"{entry:.6g}" for corner in corners for entry in corner)}"')
            attributes.append(f'face="{" ".join(str(corner) for face in faces for corner in face)}"')
        else:
            attributes.append(f'file="{name}.{form}"')
            path = self.folder / f"{name}.{form}"
            if form == "obj":
                lines = [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in corners]
                lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
                path.write_text("\n".join(lines) + "\n")
            else:
                data = b" " * 80 + struct.pack("<I", len(faces))
                for face in faces:
                    data += struct.pack("<12fH", 0, 0, 0, *(entry for corner in face for entry in corners[corner]), 0)
                path.write_bytes(data)
        self.meshes[name] = " ".join(attributes)
        return name

    def height_field(self):
        """The size of a height field, and some heights."""
        name = f"h{len(self.height_fields)}"
        size = " ".join([self.positive(0.1, 0.5), self.positive(0.1, 0.5), self.positive(0.05, 0.2), self.positive(0.01, 0.1)])
        heights = " ".join(self.positive(0, 1) for _ in range(6))
        self.height_fields[name] = f'nrow="2" ncol="3" size="{size}" elevation="{heights}"'
        return name

    def equality(self):
        rng = self.rng
        if len(self.scalars) < 2 or rng.random() < 0.6:
            return ""
        mimic, mimicked = rng.sample(self.scalars, 2)
        polynomial = f'polycoef="{self.number(0.5)} {self.positive(0.3, 2)} 0 0 0"' if rng.random() < 0.8 else ""
        return f'<equality><joint joint1="{mimic}" joint2="{mimicked}" {polynomial}/></equality>'

    def actuators(self):
        rng = self.rng
        text = ""
        for joint in self.scalars:
            if rng.random() < 0.2:
                gear = f'gear="{self.positive(0.5, 10)}"' if rng.random() < 0.7 else ""
                armature = f'armature="{self.positive(0.001, 0.01)}"' if rng.random() < 0.7 else ""
                text += f'<motor joint="{joint}" {gear} {armature}/>'
        return f"<actuator>{text}</actuator>"
