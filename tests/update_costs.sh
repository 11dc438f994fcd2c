#!/usr/bin/env bash
# Brings the seconds of tests/costs.txt up to date with the last runs of ctest in a build folder, and adds the entries that
# take more than ten.
#
#   tests/update_costs.sh build/release
set -euo pipefail

costs=$(dirname -- "${BASH_SOURCE[0]}")/costs.txt
measured=$1/Testing/Temporary/CTestCostData.txt # lines "NAME RUNS SECONDS", then "---" and what failed
awk 'FNR == NR { if ($0 == "---") over = 1; if (!over) seconds[$1] = int($3 + 0.5); next }
     /^[^#]/ { known[$1] = 1; if ($1 in seconds) $2 = seconds[$1] }
     { print }
     END { for (name in seconds) if (seconds[name] > 10 && !(name in known) && name !~ /^(docs_|examples_|ranks_|[a-z]+_package|fem_on)/) print name, seconds[name] | "sort" }' \
  "$measured" "$costs" >"$costs.new"
mv -- "$costs.new" "$costs"
