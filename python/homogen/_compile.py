"""LLVM IR to machine code, once in a process, and from the cache on disk where it has been compiled before.

An entry is named after a hash of everything that decides the code: IR, versions, processor and its features. A thread that
needs a function which another thread compiles waits for that one. While LLVM compiles or frees code it holds a lock of its
own; a process that forks waits for that, since its child would keep the lock for ever.
"""

import hashlib
import threading
import weakref

import llvmlite
import llvmlite.binding as llvm

from . import _cache
from ._engine import VERSION
from ._progress import working

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

# Code that is alive, by the name of its entry: robots of one description share it.
_loaded = weakref.WeakValueDictionary()


# Functions that are being compiled, by recipe and kind of call, and codes that are being freed, by a key of their own;
# guarded by the lock of `_idle`, which is notified when there are fewer. A thread that has the lock may free code.
_pending = {}
_idle = threading.Condition(threading.RLock())


class _Pending:
    """A function that is being compiled: an event at its end, and what `compiled` then returns, unless that failed."""

    def __init__(self):
        self.done, self.found = threading.Event(), None


def compiled(recipe, name, frame, order, single, many):
    """The address of a function's code, about how many operations a state takes, and the object that keeps the code alive."""
    key = recipe, name, frame, order, single, many
    own = _Pending()
    while (other := _claimed(key, own)) is not own:
        with working(f"compiling {name}"):
            other.done.wait()
        if other.found is not None:
            return other.found
    try:
        with working(f"compiling {name}"):
            own.found = _from_recipe(*key)
        return own.found
    finally:
        _ended(key)
        own.done.set()


# Code is freed as the interpreter ends, too, when names of modules may be gone: hence the defaults.
def _claimed(key, own, idle=_idle, pending=_pending):
    """What stands for a function that is being compiled: that of another thread, or one's own."""
    with idle:
        return pending.setdefault(key, own)


def _ended(key, idle=_idle, pending=_pending):
    """LLVM works for this no longer."""
    with idle:
        del pending[key]
        idle.notify_all()


def _from_recipe(recipe, name, frame, order, single, many):
    fused = FUSES and not recipe.reproducible
    lanes = _VECTOR // (4 if single else 8) if many else 1
    entry, ir, operations = recipe.code(name, frame, order, single, lanes, fused)
    code = loaded(entry, ir)
    return code.address, operations, code


def hold():
    """Waits until LLVM works for no thread, and keeps it so until `release`."""
    _idle.acquire()
    while _pending:
        _idle.wait()


def release():
    """LLVM may work again."""
    _idle.release()


class _Code:
    """Machine code in memory."""

    def __init__(self, entry, image):
        machine = _machine()
        module = llvm.parse_assembly("")
        module.triple = _TRIPLE
        engine = llvm.create_mcjit_compiler(module, machine)
        engine.add_object_file(llvm.ObjectFileRef.from_data(image))
        engine.finalize_object()
        self.address = engine.get_function_address(entry)
        if not self.address:
            raise RuntimeError(f"the code of {entry} cannot be linked")
        self._engine = _Engine(engine)


class _Engine:
    """LLVM's part of a code. It is an object of its own, since a weak reference still leads to one whose `__del__` runs."""

    def __init__(self, engine):
        self._engine = engine

    def __del__(self, claimed=_claimed, ended=_ended):
        own = object()
        claimed(own, own)
        # Frees the code; as the interpreter ends, llvmlite leaves it.
        del self._engine
        ended(own)


def loaded(entry, ir):
    """The code of an entry, from memory, from disk, or compiled."""
    about = (VERSION, llvmlite.__version__, *llvm.llvm_version_info, _TRIPLE, _CPU, _FEATURES.flatten(), _EFFORT, entry, ir)
    key = key_of(about)
    code = _loaded.get(key)
    if code is None:
        code = _Code(entry, kept(key, lambda: _compile(entry, ir)))
        _loaded[key] = code
    return code


def key_of(about):
    """The name in the cache of what is made of all this."""
    return hashlib.sha256("\0".join(map(str, about)).encode()).hexdigest()


def kept(key, make):
    """The bytes of an entry, from disk or made."""
    image = _cache.read(key)
    if image is None:
        image = make()
        _cache.write(key, image)
    return image


def _machine():
    target = llvm.Target.from_triple(_TRIPLE)
    return target.create_target_machine(cpu=_CPU, features=_FEATURES.flatten(), opt=_EFFORT, reloc="default", codemodel="jitdefault")


def _compile(entry, ir):
    machine = _machine()
    module, _ = parsed(entry, ir, _TRIPLE)
    optimise(module, machine, _EFFORT)
    return machine.emit_object(module)


def parsed(entry, ir, triple):
    """A module for a target, and its functions without the entry, which nobody calls from outside."""
    module = llvm.parse_assembly(ir)
    module.triple = triple
    inner = [function for function in module.functions if not function.is_declaration and function.name != entry]
    for function in inner:
        function.linkage = "internal"
    return module, inner


def optimise(module, machine, effort):
    passes = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=effort))
    passes.getModulePassManager().run(module, passes)
