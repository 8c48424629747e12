"""The cache on disk, threads and processes."""

import multiprocessing
import os
import subprocess
import sys
import threading

import numpy as np
import pytest
from conftest import ROBOTS, robot, same

PROGRAM = """
import sys, time, hashlib
import numpy as np
import homogen
import homogen._compile as compiler
compiled, whole = 0, compiler._compile
def counted(*words):
    global compiled
    compiled += 1
    return whole(*words)
compiler._compile = counted
of = homogen.load(sys.argv[1])
q = np.linspace(-1, 1, 40).reshape(20, 2)
found = of.mass_matrix(q).tobytes() + of.gravity(q[0]).tobytes()
print(compiled, hashlib.sha256(found).hexdigest())
"""


def run(cache):
    """A process with a folder as its cache, or with another environment: how many functions it has compiled, and a hash of
    its results."""
    words = [sys.executable, "-W", "error", "-c", PROGRAM, str(ROBOTS / "two_link.urdf")]
    environment = cache if isinstance(cache, dict) else {**os.environ, "HOMOGEN_CACHE": str(cache)}
    return subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment)


def answer(process):
    output, _ = process.communicate(timeout=120)
    assert process.returncode == 0
    count, found = output.split()
    return int(count), found


def alone(program, file="panda_class.urdf", **environment):
    """What a process of its own prints that compiles everything, which is ended where it waits for ever."""
    words = [sys.executable, "-W", "ignore", "-c", program, str(ROBOTS / file)]
    environment = {**os.environ, "HOMOGEN_CACHE": "", **environment}
    return subprocess.run(words, check=True, timeout=300, capture_output=True, text=True, env=environment).stdout


@pytest.fixture
def cache(tmp_path):
    folder = tmp_path / "cache"
    assert answer(run(folder))[0] == 2
    assert len(list(folder.iterdir())) == 2
    return folder


def test_code_is_kept_and_found(cache):
    before = answer(run(""))
    assert before[0] == 2
    assert answer(run(cache)) == (0, before[1])
    assert cache.stat().st_mode & 0o077 == 0


@pytest.mark.parametrize("damage", ["cut", "empty", "changed", "a folder"])
def test_entries_that_are_not_whole_are_made_again(cache, damage):
    before = answer(run(""))[1]
    for entry in cache.iterdir():
        kept = entry.read_bytes()
        if damage == "cut":
            entry.write_bytes(kept[:-100])
        elif damage == "empty":
            entry.write_bytes(b"")
        elif damage == "changed":
            entry.write_bytes(kept[:200] + bytes([kept[200] ^ 1]) + kept[201:])
        else:
            entry.unlink()
            entry.mkdir()
    assert answer(run(cache)) == (2, before)
    # A folder in the place of an entry stays, and code is compiled each time.
    assert answer(run(cache)) == (2 if damage == "a folder" else 0, before)
    assert not list(cache.glob("*.new"))


def test_a_folder_that_cannot_be_written_is_done_without(cache, tmp_path):
    before = answer(run(""))[1]
    file = tmp_path / "file"
    file.touch()
    for folder in (file, file / "below", "/proc/nowhere"):
        assert answer(run(folder)) == (2, before)
    if os.name == "posix":
        # What others may write could be anybody's code.
        cache.chmod(0o777)
        assert answer(run(cache)) == (2, before)
        cache.chmod(0o500)
        for entry in cache.iterdir():
            entry.chmod(0o400)
        assert answer(run(cache)) == (0, before)


@pytest.mark.skipif(os.name != "posix", reason="sizes of files are limited elsewhere in another way")
def test_a_full_disk_is_done_without(tmp_path):
    before = answer(run(""))[1]
    # No file becomes larger than this, as on a disk that is full.
    program = "import resource\nresource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))\n" + PROGRAM
    for _ in range(2):
        found = alone(program, "two_link.urdf", HOMOGEN_CACHE=str(tmp_path / "cache")).split()
        assert (int(found[0]), found[1]) == (2, before)
    assert not list((tmp_path / "cache").iterdir())


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="no folder is read-only to root elsewhere")
def test_a_read_only_home_is_done_without():
    before = answer(run(""))[1]
    environment = {key: value for key, value in os.environ.items() if key not in ("HOMOGEN_CACHE", "XDG_CACHE_HOME")}
    for _ in range(2):
        assert answer(run(environment | {"HOME": "/proc"})) == (2, before)


def test_processes_share_a_cache(tmp_path):
    processes = [run(tmp_path / "cache") for _ in range(4)]
    assert len({answer(process)[1] for process in processes}) == 1
    assert answer(run(tmp_path / "cache"))[0] == 0
    assert len(list((tmp_path / "cache").iterdir())) == 2


def test_threads_call_and_compile_side_by_side():
    of = robot("arm")
    q = np.random.default_rng(1).uniform(-2, 2, (6, 999, 7))
    expected = [robot("arm").inverse_dynamics(one, one, one) for one in q]
    wrong = []

    def work(k):
        for _ in range(20):
            found = of.inverse_dynamics(q[k], q[k], q[k])
            single = of.inverse_dynamics(q[k, 0], q[k, 0], q[k, 0])
            if not same(found, expected[k]) or not same(single, expected[k][0]):
                wrong.append(k)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


RACE = """
import sys, threading
import numpy as np
import homogen
q = np.zeros((20, 2))
sys.setswitchinterval(1e-5)
for _ in range(40):
    of = homogen.load(sys.argv[1])
    calls = [of.gravity, of.mass_matrix, of.gravity, of.mass_matrix]
    start = threading.Barrier(8)
    def work(call):
        start.wait()
        call(q), call(q[0])
    threads = [threading.Thread(target=work, args=(call,)) for call in calls * 2]
    for thread in threads: thread.start()
    for thread in threads: thread.join()
"""


def test_threads_that_compile_the_same_never_wait_for_each_other(cache):
    # A process of its own, which can be ended where they do.
    words = [sys.executable, "-c", RACE, str(ROBOTS / "two_link.urdf")]
    subprocess.run(words, check=True, timeout=300, env={**os.environ, "HOMOGEN_CACHE": str(cache)})


def test_the_lock_of_the_interpreter_is_free_meanwhile():
    of = robot("arm", threads=1)
    q = np.zeros((1_000_000, 7))
    of.inverse_dynamics(q[:20], q[:20], q[:20])
    began, steps = threading.Event(), 0

    def work():
        began.set()
        of.inverse_dynamics(q, q, q)

    interval = sys.getswitchinterval()
    # A thread that computes in Python would keep the lock for so long.
    sys.setswitchinterval(2)
    try:
        thread = threading.Thread(target=work)
        thread.start()
        began.wait()
        while thread.is_alive():
            steps += 1
    finally:
        sys.setswitchinterval(interval)
    assert steps > 1000


def torques(of, q):
    return of.inverse_dynamics(q, q, q), of.gravity(q)


@pytest.mark.parametrize("method", [name for name in ("fork", "spawn") if name in multiprocessing.get_all_start_methods()])
def test_robots_go_to_other_processes(method):
    of = robot("arm")
    q = np.random.default_rng(4).uniform(-2, 2, (50_000, 7))
    # The process that is forked has computed on several threads before.
    expected = of.inverse_dynamics(q, q, q)
    context = multiprocessing.get_context(method)
    with context.Pool(2) as pool:
        for dynamics, gravity in pool.starmap(torques, [(of, q)] * 4):
            assert same(dynamics, expected) and same(gravity, of.gravity(q))


# --- functions in the background ------------------------------------------------------------------

NAMED = ["inverse_dynamics", "forward_dynamics", "mass_matrix", "inverse_dynamics_derivatives"]


def test_named_functions_compile_while_the_program_goes_on():
    q = np.random.default_rng(2).uniform(-1, 1, (20, 7))
    of = robot("arm", functions=NAMED)
    # Each call finds code, waits for it, or has it compiled.
    for k in (3, 0, 2, 1):
        function = getattr(of, NAMED[k])
        arguments = [q] * len(function.parameters()[0])
        expected = getattr(robot("arm"), NAMED[k])(*arguments)
        found = function(*arguments)
        for one, other in zip(*(array if isinstance(array, tuple) else [array] for array in (found, expected))):
            assert same(one, other)
    assert same(robot("arm", functions="gravity").gravity(q), of.gravity(q))
    with pytest.raises(AttributeError, match="'panda_class' has no function 'gravty'"):
        robot("arm", functions=["gravity", "gravty"])
    of.compile("gravity", "bias", dtype=np.float32, wait=False)
    assert of.gravity(q.astype(np.float32)).dtype == np.float32


SIDE_BY_SIDE = """
import sys, threading
import numpy as np
import homogen, homogen._compile as compiler
count, whole = 0, compiler._compile
def counted(*words):
    global count
    count += 1
    return whole(*words)
compiler._compile = counted
of = homogen.load(sys.argv[1], tip="link8", functions=["inverse_dynamics_derivatives", "forward_dynamics"])
q = np.zeros((20, 7))
threads = [threading.Thread(target=lambda: of.forward_dynamics(q, q, q)) for _ in range(8)]
for thread in threads: thread.start()
for thread in threads: thread.join()
of.compile("inverse_dynamics_derivatives", "forward_dynamics")
of.compile("inverse_dynamics_derivatives", "forward_dynamics", many=False)
print(count)
"""


def test_threads_wait_for_a_function_that_another_compiles():
    # Two functions, each for one state and for many.
    assert int(alone(SIDE_BY_SIDE)) == 4


FORK = """
import multiprocessing, sys, time
import numpy as np
import homogen
names = ["forward_dynamics", "inverse_dynamics"]
def call(of):
    return of.mass_matrix(np.zeros(7)).sum()
if __name__ == "__main__":
    context = multiprocessing.get_context("fork")
    for k in range(3):
        of = homogen.load(sys.argv[1], tip="link8", functions=names)
        time.sleep(0.1 + 0.05 * k)
        process = context.Process(target=call, args=(of,))
        process.start()
        process.join()
        assert process.exitcode == 0
    print(call(of))
"""


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="there is no fork")
def test_a_process_forks_while_functions_compile():
    assert np.isfinite(float(alone(FORK)))


FREED = """
import gc, multiprocessing, sys, threading, time
import numpy as np
import homogen
import llvmlite.binding as llvm
freeing, dispose = threading.Event(), llvm.ExecutionEngine._dispose
def slowly(engine):
    # As LLVM does: with its lock, while other threads go on.
    with llvm.ffi.lib._lock:
        freeing.set()
        time.sleep(1)
        dispose(engine)
def call():
    homogen.load(sys.argv[1]).gravity(np.ones(2))
if __name__ == "__main__":
    robots = [homogen.load(sys.argv[1])]
    robots[0].gravity(np.ones(2))
    llvm.ExecutionEngine._dispose = slowly
    thread = threading.Thread(target=lambda: (robots.clear(), gc.collect()))
    thread.start()
    assert freeing.wait(10)
    process = multiprocessing.get_context("fork").Process(target=call)
    process.start()
    thread.join()
    process.join(60)
    process.kill()
    print(process.exitcode)
"""


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="there is no fork")
def test_a_process_forks_while_code_is_freed():
    assert alone(FREED, "two_link.urdf") == "0\n"


ENDING = """
import sys, time
import homogen
began = time.monotonic()
for _ in range(100):
    of = homogen.load(sys.argv[1], tip="link8", functions=["gravity", *["mass_matrix"] * 1000])
del of
of = homogen.load(sys.argv[1], tip="link8", functions=["mass_matrix_inverse", "forward_dynamics_derivatives"] * 1000)
print("ended")
"""


def test_a_program_ends_before_its_functions_are_compiled():
    assert alone(ENDING) == "ended\n"


# --- the size of the cache ------------------------------------------------------------------------

PRUNED = """
import os, sys, time
from homogen import _cache
for k in range(int(sys.argv[2]), int(sys.argv[3])):
    _cache.write(f"{k:064x}", bytes(100_000))
    # The first entry is used again and again.
    _cache.read(f"{0:064x}")
"""


def entries(folder):
    return sorted(path.name for path in folder.iterdir())


def test_entries_that_were_used_longest_ago_go(tmp_path):
    folder = tmp_path / "cache"
    environment = {**os.environ, "HOMOGEN_CACHE": str(folder), "HOMOGEN_CACHE_SIZE": "1"}

    def write(first, end):
        return subprocess.Popen([sys.executable, "-c", PRUNED, "", str(first), str(end)], env=environment)

    assert write(0, 5).wait() == 0
    left, other = folder / "half.new", folder / "notes.txt"
    for path in (left, other):
        path.write_bytes(bytes(2_000_000))
        os.utime(path, (0, 0))
    processes = [write(first, first + 20) for first in (5, 25, 45)]
    assert [process.wait() for process in processes] == [0, 0, 0]
    assert write(65, 70).wait() == 0
    kept = [path for path in folder.iterdir() if path.suffix == ".o"]
    # A process that writes looks at all files whenever it has written a sixteenth of the size.
    assert 8 <= len(kept) <= 11
    names = {int(path.stem, 16) for path in kept}
    assert {0, 66, 67, 68, 69} <= names and 1 not in names
    # Half an entry that nobody finishes goes, and what is not of the cache stays.
    assert not left.exists() and other.exists()


def test_a_size_that_is_no_number_is_the_default(tmp_path):
    program = "from homogen import _cache; print(_cache.size == _cache.DEFAULT_SIZE)"
    assert alone(program, HOMOGEN_CACHE_SIZE="much") == "True\n"
    assert alone(program, HOMOGEN_CACHE_SIZE="2.5") == "False\n"
