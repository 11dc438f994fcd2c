#!/usr/bin/env bash
# Compiles each file of the libraries and of the program by itself, recently changed files first. A normal build compiles
# a folder as one file, which hides missing includes and names that clash with a header.
#
#   tests/each_file_alone.sh BUILD [SECONDS]
#
# BUILD is a separate build folder, created if missing. No new file is started after SECONDS (default: no limit). Prints
# the number of compiled files and the errors; exit code 1 if a file failed.
set -euo pipefail

source=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$1 seconds=${2:-1000000}
cores=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
# No optimisation: the errors appear while the compiler parses the file.
cmake -S "$source" -B "$build" -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" \
  -D STEMWARE_UNITY=OFF -D STEMWARE_WERROR=ON -D BUILD_TESTING=OFF >"$build.log" 2>&1 || {
  cat "$build.log" >&2
  exit 1
}

# Objects, last changed first: ".../CMakeFiles/stemware_solid.dir/solid_foot.cc.o".
mapfile -t objects < <(
  git -C "$source" log --format= --name-only -- '*.cc' 2>/dev/null | awk 'NF && !seen[$0]++' |
    awk 'FNR == NR { file = $1; sub(/CMakeFiles\/[^\/]*\.dir\//, "", file); sub(/\.o$/, "", file); object[file] = $1; next }
         $1 in object { print object[$1]; delete object[$1] }
         END { for (file in object) print object[file] }' \
      <(ninja -C "$build" -t targets all | sed -n 's/: CXX_COMPILER.*//p') -
)
[[ ${#objects[@]} -gt 0 ]] || {
  echo "each_file_alone: $build has no file to compile." >&2
  exit 1
}

# Generated sources (revision, embedded texts) are made first.
ninja -C "$build" -t targets all | sed -n 's/: CUSTOM_COMMAND.*//p' | grep '\.cc$' | sort -u |
  xargs -r ninja -C "$build" >"$build.log" 2>&1
end=$((SECONDS + seconds)) done=0 failed=0
while [[ $done -lt ${#objects[@]} && $SECONDS -lt $end ]]; do
  some=("${objects[@]:done:cores*4}")
  ninja -C "$build" -k 0 -j "$cores" "${some[@]}" >"$build.log" 2>&1 || {
    grep -v '^\[' "$build.log" >&2
    failed=1
  }
  done=$((done + ${#some[@]}))
done
echo "$done of ${#objects[@]} files compiled by themselves."
exit "$failed"
