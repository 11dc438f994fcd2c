#!/usr/bin/env bash
# Checks that cookbooks, meshes and licence are installed with the program.
#
#   check_installed.sh PREFIX
set -euo pipefail
share=$1/share
export PATH=$1/bin:$PATH

troubles=0
expect() { # what, then a command that must succeed
  "${@:2}" && return
  echo "installed program: $1"
  troubles=$((troubles + 1))
}

for file in doc/stemware/LICENSE stemware/cookbooks/lift_off.prm stemware/cookbooks/own_profile.csv stemware/meshes/oval_foot.msh stemware/verification/claims.json stemware/summary.schema.json; do
  expect "$file is installed" test -s "$share/$file"
done
expect "a cookbook runs where it lies" stemware mesh "$share/stemware/cookbooks/oval_foot.prm" --quiet

expect "the verification runs where it lies" python3 "$share/stemware/verification/verify.py" first_harmonic

((troubles == 0)) && echo "What is installed is complete."
exit $((troubles > 0))
