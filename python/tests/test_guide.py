"""Programs of the guide and of the examples: they run, and compute what other libraries do where these are installed."""

import re
import runpy
import sys
import warnings

import numpy as np
import pytest
from conftest import REPOSITORY, library, robot

GUIDE = REPOSITORY / "guide/src"
EXAMPLES = REPOSITORY / "examples/python"

#: Pages with two programs, the module of the first, and what is compared.
PAGES = {
    "from-pinocchio.md": ("pinocchio", ["tau", "qdd", "mass", "bias", "pose", "jacobian", "ahead"]),
    "from-mujoco.md": ("mujoco", ["tau", "bias", "mass", "position", "jacobian", "ahead"]),
    "from-robotics-toolbox.md": (
        "roboticstoolbox",
        ["tau", "gravity", "mass", "acceleration", "pose", "jacobian", "body", "reached"],
    ),
}


def programs(page):
    """The programs in Python of a page."""
    return re.findall(r"^```python\n(.*?)^```$", (GUIDE / page).read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)


def variables(program, **given):
    scope = {"__name__": "guide", **given}
    exec(compile(program, "guide", "exec"), scope)
    return scope


@pytest.mark.parametrize("page", PAGES)
def test_programs_beside_each_other_run(page, monkeypatch):
    monkeypatch.chdir(REPOSITORY)
    theirs, ours = programs(page)
    module, names = PAGES[page]
    assert f"import {module}" in theirs and "import homogen" in ours
    found = variables(ours)
    assert all(np.isfinite(found[name]).all() for name in names)


# A library warns of what it does itself.
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("page", PAGES)
def test_programs_beside_each_other_compute_the_same(page, monkeypatch):
    module, names = PAGES[page]
    library(module)
    monkeypatch.chdir(REPOSITORY)
    theirs, ours = map(variables, programs(page))
    for name in names:
        wanted, found = np.asarray(theirs[name]), np.asarray(ours[name])
        if page == "from-pinocchio.md" and name == "mass":
            # Pinocchio need not fill the lower half.
            wanted, found = np.triu(wanted), np.triu(found)
        # The other library ends its search at a larger error.
        off = 1e-3 if name == "reached" else 1e-9 * (1 + np.abs(wanted).max())
        assert np.allclose(found, wanted, rtol=0, atol=off), name


def test_pictures_are_drawn():
    matplotlib = library("matplotlib")
    matplotlib.use("Agg")
    (program,) = (text for text in programs("python.md") if "matplotlib" in text)
    with warnings.catch_warnings():
        # Of matplotlib's own dependencies.
        warnings.simplefilter("ignore")
        plot = variables(program, panda=robot("arm"))["plt"]
    lines = plot.gca().get_lines()
    assert [line.get_label() for line in lines] == list(robot("arm").joint_names)
    assert len(plot.gca().collections[0].get_offsets()) == 5000
    plot.close("all")


def test_identification_finds_what_the_measurements_are_made_with(monkeypatch, capsys):
    library("torch")
    monkeypatch.setattr(sys, "argv", ["identify.py", "--states=500", "--noise=1e-6"])
    scope = runpy.run_path(str(EXAMPLES / "identify.py"), run_name="__main__")
    rows = [line.replace("[", " ").replace("]", " ") for line in capsys.readouterr().out.splitlines()]
    assert len(rows) == 5
    found, true = (np.array(rows[0].split(word)[1].split("true")[0].split(), float) for word in ("found", "true"))
    assert np.allclose(found, true, atol=2e-4) and np.allclose(true, scope["OFFSETS"])
    assert abs(float(rows[2].split("found")[1].split()[0]) - scope["MASS"]) < 1e-3


def test_the_arm_of_mppi_moves(monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["mppi.py", "--rollouts=512", "--steps=50"])
    runpy.run_path(str(EXAMPLES / "mppi.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert float(lines[1].split()[2]) < 60
    assert float(lines[2].split()[2]) <= 1
    assert lines[3].startswith("512 rollouts of 12 times in ") and lines[3].endswith(" a second a core")
