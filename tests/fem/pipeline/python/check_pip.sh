#!/bin/sh
# Builds an sdist, installs the package without finite elements from it with pip, and runs the test of the ring on it.
# Arguments: Python, sources, target folder.
set -eu
rm -rf -- "$3" && mkdir -p -- "$3/fem/pipeline"
cp -r -- "$2/ring_model" "$3/ring_model"   # pip builds inside the source folder
cp -rL -- "$2/fem/pipeline/python" "$3/fem/pipeline/python"
cp -- "$2/CMakeLists.txt" "$2/LICENSE" "$3"
cp -- "$2/fem/portable.cmake" "$3/fem"
cd -- "$3/fem/pipeline/python"
"$1" -c "from setuptools import build_meta; build_meta.build_sdist('$3')" >/dev/null
export STEMWARE_CMAKE_ARGUMENTS="-D STEMWARE_FEM=OFF"
"$1" -m pip install "$3"/stemware-*.tar.gz --no-build-isolation --no-index --no-deps --quiet --target "$3/site"
cd / # far from the sources
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$3/site"
test -f "$3/site/stemware/py.typed"
"$1" -c "
import stemware
try:
    stemware.Study
except ImportError as missing:
    assert 'needs the finite elements' in str(missing), missing
else:
    raise SystemExit('a build without finite elements has a Study')
"
exec "$1" "$2/tests/fem/pipeline/python/ring_test.py"
