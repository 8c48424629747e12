#!/usr/bin/env bash
# Labels states on Ray and Dask with 1, 2 and 4 workers, some of them killed on purpose: the bytes are those of one
# process, and the files agree with `homogen eval`, bit for bit.
#
# Ray, Dask and PyArrow come from PyPI, 400 MB; takes three to six minutes on two cores. `.ci/run` does not call it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

name=cluster
. tests/python/packages.sh
"$homogen" python robots/panda_class.urdf --tip link8 --functions inverse_dynamics -o "$folder/panda_py" >/dev/null
pip install ray 'dask[distributed]' pyarrow
CARGO_TARGET_DIR="$built/python/target" pip install "$folder/panda_py"

passed=0
check() {
    if ! "${@:2}"; then
        echo "failed: $1"
        exit 1
    fi
    passed=$((passed + 1))
}
label() { # folder, options
    "$python" examples/python/label.py --states 260000 --chunk 30000 --folder "$folder/$1" "${@:2}" 2>"$folder/$1.log" |
        sed -n 's/.*sha256 //p'
}
bytes() { (cd "$folder/$1" && sha256sum ./* | sha256sum); }
whole() { # all chunks and nothing else, hidden files included
    [ "$(find "$folder/$1" -type f | wc -l)" = 9 ] && [ "$(find "$folder/$1" -name 'panda_py-1-*.parquet' | wc -l)" = 9 ]
}

expected=$(label alone)
check "there is a digest" [ -n "$expected" ]
check "nine chunks" whole alone
for on in ray dask; do
    for workers in 1 2 4; do
        name="$on-$workers"
        found=$(label "$name" --on "$on" --workers "$workers" --lose 1 --lose 4)
        check "$name: the same digest" [ "$found" = "$expected" ]
        check "$name: the same bytes" [ "$(bytes "$name")" = "$(bytes alone)" ]
        check "$name: nothing is left" whole "$name"
        echo "$name: $found, with two workers lost"
    done
done

# Killed in the middle of a file, without a restart: existing files are complete, and a second run writes the rest.
label again --lose 5 >"$folder/killed" || true
check "no digest of a part" [ ! -s "$folder/killed" ]
check "five chunks" [ "$(find "$folder/again" -name 'panda_py-1-*.parquet' | wc -l)" = 5 ]
check "the digest after all" [ "$(label again)" = "$expected" ]
check "nothing is left" whole again

# Files of other states have other names, so existing files are never taken for them.
check "another seed" [ "$(label again --seed 2)" != "$expected" ]
check "another size" [ "$(label again --chunk 40000)" != "$expected" ]
check "the first ones are there" [ "$(label again)" = "$expected" ]

# A full disk, simulated by a limit on file size.
if (ulimit -f 1000 && label full) >"$folder/refused"; then
    check "no digest without files" [ ! -s "$folder/refused" ]
fi
check "no file of a part" [ "$(find "$folder/full" -type f | wc -l)" = 0 ]
check "the reason is reported" grep -q "File too large" "$folder/full.log"

# States of a chunk as NumPy files, and the results of eval.
"$python" - "$folder" <<'PYTHON'
import pathlib, sys
import numpy as np
import pyarrow.parquet as pq

folder = pathlib.Path(sys.argv[1])
table = pq.read_table(folder / "alone" / "panda_py-1-000000240000-20000.parquet")
for name in ("q", "qd", "qdd", "tau"):
    numbers = np.concatenate([part.flatten().to_numpy() for part in table[name].chunks])
    np.save(folder / f"{name}.npy", numbers.reshape(-1, 7))
PYTHON
"$homogen" eval robots/panda_class.urdf --tip link8 --function inverse_dynamics --states "q=$folder/q.npy" \
    --states "qd=$folder/qd.npy" --states "qdd=$folder/qdd.npy" -o "$folder/eval.npy"
check "the bits of eval" cmp "$folder/tau.npy" "$folder/eval.npy"

# Files of other programs, in other NumPy types, are read; truncated files are rejected.
"$python" - "$folder" <<'PYTHON'
import pathlib, sys
import numpy as np

folder = pathlib.Path(sys.argv[1])
q = np.linspace(-1, 1, 700).reshape(100, 7)
np.save(folder / "q.npy", q)
np.save(folder / "single.npy", q.astype("f4"))
np.save(folder / "fortran.npy", np.asfortranarray(q))
np.save(folder / "whole.npy", np.ones((3, 7), int))
np.savez(folder / "many.npz", q=q)
(folder / "cut.npy").write_bytes((folder / "q.npy").read_bytes()[:-50])
PYTHON
gravity() { "$homogen" eval robots/panda_class.urdf --tip link8 --function gravity --states "$folder/$1" -o "$folder/gravity.npy"; }
for read in q single; do
    check "$read" gravity "$read.npy"
done
rm "$folder/gravity.npy"
for refused in "fortran.npy:Fortran's order" "whole.npy:type <i8" "cut.npy:is cut off"; do
    check "$refused" bash -c '! "$1" eval robots/panda_class.urdf --tip link8 --function gravity --states "$2/${3%%:*}" -o "$2/gravity.npy" 2>"$2/reason"' - "$homogen" "$folder" "$refused"
    check "$refused" grep -q "${refused#*:}" "$folder/reason"
    check "$refused: no panic" bash -c '! grep -q panicked "$1"' - "$folder/reason"
    check "$refused" [ ! -e "$folder/gravity.npy" ]
done
echo "$passed passed, 0 failed"
