"""Files of a robot for CasADi: C with its external interface, compiled, and plain Python that runs over its symbols."""

import importlib.util
import subprocess


def generated(homogen, folder, name, options, for_c=()):
    """The path of the library, the text of the C file, and the module of Python of a robot; `for_c` are options of C alone."""
    source, library, plain = folder / f"{name}.c", folder / f"{name}.so", folder / f"{name}.py"
    make = [homogen, "generate", *options, "--ascii"]
    subprocess.run([*make, *for_c, "--language", "c", "--casadi", "-o", source], check=True)
    without = [option for option in options if not option.startswith("--section")]
    if "--section" in options:
        place = options.index("--section")
        without = options[:place] + options[place + 2 :]
    plain_options = ["--language", "python", "--order", "angular-first", "-o", plain]
    subprocess.run([homogen, "generate", *without, *plain_options], check=True)
    compile_c(source, library)
    found = importlib.util.spec_from_file_location(name, plain)
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return library, source.read_text(), module


def compile_c(source, library):
    flags = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-O2", "-ffp-contract=off"]
    subprocess.run(["cc", *flags, "-shared", "-fPIC", source, "-o", library], check=True)
