#!/usr/bin/env bash
# Compiles files of the libraries and of the program by themselves, those that changed last first: a folder is built as
# one file, which hides an include that a file lacks, and names that clash with a header's.
#
#   tests/each_file_alone.sh BUILD [SECONDS]
#
# BUILD is a folder of its own, made where it is missing. No file is begun when SECONDS have gone by (default: all files
# are compiled). Says how many were compiled and which ones failed; exit code 1 where one did.
set -euo pipefail

source=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$1 seconds=${2:-1000000}
cores=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
# Without optimisation: what the compiler has to say of a file alone, it says when it reads it.
cmake -S "$source" -B "$build" -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" \
  -D STEMWARE_UNITY=OFF -D STEMWARE_WERROR=ON -D BUILD_TESTING=OFF >"$build.log" 2>&1 || {
  cat "$build.log" >&2
  exit 1
}

# Objects by the place of their file in the history: ".../CMakeFiles/stemware_solid.dir/solid_foot.cc.o".
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

# What files are made of, revisions and texts that are compiled in, is made first.
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
