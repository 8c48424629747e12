"""Takes the robot descriptions out of a wheel.

In: a wheel and a folder. Out: the .urdf files in the folder, under the paths that they have in the
wheel. It never unpacks anything else.
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
