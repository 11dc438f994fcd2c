#!/bin/sh
# Installs the ring with pip into a folder and runs the test of the ring on it. Given: Python, the sources, the folder.
set -eu
rm -rf -- "$3" && mkdir -p -- "$3"
cp -r -- "$2/ring_model" "$3/ring_model" # setuptools leaves a build folder beside what it builds
mkdir -p -- "$3/fem/pipeline"
cp -rL -- "$2/fem/pipeline/python" "$3/fem/pipeline/python"
cp -- "$2/CMakeLists.txt" "$2/LICENSE" "$3"
"$1" -m pip install "$3/fem/pipeline/python" --no-build-isolation --no-index --no-deps --quiet --target "$3/site"
test -f "$3/site/stemware/py.typed"
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$3/site exec "$1" "$2/tests/fem/pipeline/python/ring_test.py"
