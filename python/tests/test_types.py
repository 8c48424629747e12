"""Stubs: what they say is what the engine has, and what type checkers take."""

import ast
import inspect
import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import REPOSITORY, ROBOTS

import homogen

TYPED = Path(__file__).with_name("typed.py")


def test_stubs_are_those_of_the_engine():
    script = REPOSITORY / "python/stub.py"
    folder = Path(homogen.__file__).parent
    subprocess.run([sys.executable, str(script), "--check", str(folder)], check=True)
    assert (folder / "py.typed").exists()


def test_a_typed_program_runs():
    subprocess.run([sys.executable, "-W", "error", str(TYPED), str(ROBOTS / "panda_class.urdf")], check=True)


def test_a_typed_program_is_accepted_by_mypy(tmp_path):
    pytest.importorskip("mypy")
    words = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path), str(TYPED)]
    checked = subprocess.run(words, capture_output=True, text=True, env=os.environ)
    assert checked.returncode == 0, checked.stdout
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import homogen\nhomogen.load('a', flaoting=True)\n")
    checked = subprocess.run([*words[:-1], str(wrong)], capture_output=True, text=True)
    assert 'Unexpected keyword argument "flaoting"' in checked.stdout


def test_stubs_have_the_names_of_the_package(arm):
    folder = Path(homogen.__file__).parent
    functions = [item for item in ast.parse((folder / "_load.pyi").read_text()).body if isinstance(item, ast.FunctionDef)]
    keywords = [argument.arg for argument in functions[0].args.kwonlyargs]
    own = ["order", "fields", "ranges", "threads", "functions"]
    assert keywords == own + [key for key, _ in homogen._engine.options()]
    assert keywords == list(inspect.signature(homogen.load).parameters)[1:]
    classes = [item for item in ast.parse((folder / "_robot.pyi").read_text()).body if isinstance(item, ast.ClassDef)]
    names = {item.target.id for item in classes[0].body if isinstance(item, ast.AnnAssign)}
    names |= {item.name for item in classes[0].body if isinstance(item, ast.FunctionDef) and not item.name.startswith("__")}
    not_of_all = {name for name, *_, needs in homogen._engine.functions() if needs}
    assert names - not_of_all == {name for name in dir(arm) if not name.startswith("_")}
