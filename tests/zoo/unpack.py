"""Extracts the robot descriptions from a wheel.

In: a wheel and a folder. Out: the .urdf files in the folder, under their paths in the wheel. Other files are not
extracted.
"""

import sys
from pathlib import Path
from zipfile import ZipFile


def main():
    wheel, folder = map(Path, sys.argv[1:])
    folder.mkdir(parents=True)
    with ZipFile(wheel) as files:
        for name in files.namelist():
            if name.lower().endswith(".urdf"):
                files.extract(name, folder)


main()
