#!/bin/sh
# Installs the program and the Python package into a folder and solves a study there. Arguments: CMake, Python, build
# folder, target folder.
set -eu
rm -rf -- "$4"
for component in program python; do
  "$1" --install "$3" --component $component --prefix "$4" >/dev/null
done
study=$(find "$4" -name '_study*.so')
cd / # far from any build
PYTHONPATH=${study%/stemware/*} exec "$2" -c "
import stemware
assert stemware.__file__.startswith('$4'), stemware.__file__
assert abs(stemware.Study().answer()['omega_terminal'] + 3.592) < 1e-3
"
