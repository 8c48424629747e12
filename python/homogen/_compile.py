"""LLVM IR to machine code, and its cache on disk.

An entry is named after a hash of everything that decides the code: IR, versions, processor and its features. It holds the
object code behind its own hash, so that an entry which is cut short or changed is made again. It is written to a file of its
own that then takes its place, so that processes can share a cache. Where nothing can be written, code is compiled anew.

`HOMOGEN_CACHE` names another folder; where it is empty nothing is kept.
"""

import contextlib
import hashlib
import os
import tempfile
import weakref
from pathlib import Path

import llvmlite
import llvmlite.binding as llvm
import platformdirs

from ._engine import VERSION

llvm.initialize_native_target()
llvm.initialize_native_asmprinter()

_CPU = llvm.get_host_cpu_name()
_FEATURES = llvm.get_host_cpu_features()
_TRIPLE = llvm.get_process_triple()

#: True if the processor fuses products with sums in one instruction.
FUSES = bool(_FEATURES.get("fma")) or _TRIPLE.startswith(("aarch64", "arm64"))

#: Optimisation level: more gains nothing for straight-line code that may not be reordered.
_EFFORT = 1

#: Bytes of the widest vector.
_VECTOR = 64 if _FEATURES.get("avx512f") else 32 if _FEATURES.get("avx2") else 16

_SUFFIX = ".o"
_HASH = hashlib.sha256

# Code that is alive, by the name of its entry: robots of one description share it.
_loaded = weakref.WeakValueDictionary()


def compiled(recipe, name, frame, order, single, many):
    """The address of a function's code, about how many operations a state takes, and the object that keeps the code alive."""
    fused = FUSES and not recipe.reproducible
    lanes = _VECTOR // (4 if single else 8) if many else 1
    entry, ir, operations = recipe.code(name, frame, order, single, lanes, fused)
    code = loaded(entry, ir)
    return code.address, operations, code


class _Code:
    """Machine code in memory."""

    def __init__(self, entry, image):
        machine = _machine()
        module = llvm.parse_assembly("")
        module.triple = _TRIPLE
        self._engine = llvm.create_mcjit_compiler(module, machine)
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(image))
        self._engine.finalize_object()
        self.address = self._engine.get_function_address(entry)
        if not self.address:
            raise RuntimeError(f"the code of {entry} cannot be linked")


def loaded(entry, ir):
    """The code of an entry, from memory, from disk, or compiled."""
    about = (VERSION, llvmlite.__version__, *llvm.llvm_version_info, _TRIPLE, _CPU, _FEATURES.flatten(), _EFFORT, entry, ir)
    key = _HASH("\0".join(map(str, about)).encode()).hexdigest()
    code = _loaded.get(key)
    if code is None:
        file = folder and folder / (key + _SUFFIX)
        image = _read(file)
        if image is None:
            image = _compile(entry, ir)
            _write(file, image)
        code = _Code(entry, image)
        _loaded[key] = code
    return code


def _machine():
    target = llvm.Target.from_triple(_TRIPLE)
    return target.create_target_machine(cpu=_CPU, features=_FEATURES.flatten(), opt=_EFFORT, reloc="default", codemodel="jitdefault")


def _compile(entry, ir):
    module = llvm.parse_assembly(ir)
    module.triple = _TRIPLE
    for function in module.functions:
        # What nobody calls from outside is not kept.
        if not function.is_declaration and function.name != entry:
            function.linkage = "internal"
    machine = _machine()
    options = llvm.create_pipeline_tuning_options(speed_level=_EFFORT)
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    return machine.emit_object(module)


def _folder():
    """The folder of the cache; `None` where nothing is to be kept, or others could put code there."""
    named = os.environ.get("HOMOGEN_CACHE")
    if named == "":
        return None
    try:
        path = Path(named) if named else platformdirs.user_cache_path("homogen")
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        if hasattr(os, "getuid"):
            status = path.stat()
            if status.st_uid != os.getuid() or status.st_mode & 0o022:
                return None
    except (OSError, RuntimeError):
        return None
    return path


#: The folder of the cache; `None` where nothing is kept.
folder = _folder()


def _read(file):
    """The object code of an entry; `None` where there is none, or it is not whole."""
    if file is None:
        return None
    try:
        kept = file.read_bytes()
    except OSError:
        return None
    size = _HASH().digest_size
    image = kept[size:]
    return image if kept[:size] == _HASH(image).digest() else None


def _write(file, image):
    if file is None:
        return
    fresh = None
    try:
        number, fresh = tempfile.mkstemp(dir=file.parent, suffix=".new")
        with open(number, "wb") as stream:
            stream.write(_HASH(image).digest() + image)
        os.replace(fresh, file)
    except OSError:
        # A full disk or a folder that cannot be written: the next process compiles again.
        if fresh is not None:
            with contextlib.suppress(OSError):
                os.unlink(fresh)
