#!/usr/bin/env bash
# Checks the calls and messages of ./quickstart, with stand-ins for apt, CMake and the program that log their calls.
#
#   check_quickstart.sh SOURCE_FOLDER
# shellcheck disable=SC2016 # the stand-ins expand their arguments
set -euo pipefail

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
mkdir -p "$scratch/clone" "$scratch/bin"
cp -- "$1"/{quickstart,packages.txt,CMakePresets.json} "$scratch/clone"
cd -- "$scratch/clone"
export PATH=$scratch/bin:$PATH CALLS=$scratch/calls
unset STEMWARE_PRESET CMAKE_BUILD_PARALLEL_LEVEL

stand_in() { # name, what it does
  printf '#!/usr/bin/env bash\necho "%s $*" >>"$CALLS"\n%s\n' "$1" "$2" >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}
stand_in dpkg-query 'echo "g++ installed"'
stand_in dpkg '[[ $1 != --print-architecture ]] || echo amd64'
stand_in sudo '[[ $1 == -* ]] || exec "$@"'
stand_in apt-get 'seq 500'
stand_in ctest ''
stand_in npm ''
stand_in cmake 'seq 200; [[ $* != *--build* ]] || { mkdir -p build/release; printf "%s\n" "#!/bin/sh" "echo \"stemware \$*\" >>\"\$CALLS\"" >build/release/stemware; chmod +x build/release/stemware; }'

troubles=0
# Checks the exit code of the command, and that each further argument occurs in its output or calls.
ends() { # exit code, command, patterns
  local status=0 pattern
  : >"$CALLS"
  # shellcheck disable=SC2086 # several words
  ./quickstart $2 >"$scratch/out" 2>&1 </dev/null || status=$?
  for pattern in "${@:3}"; do grep -qE -e "$pattern" "$scratch/out" "$CALLS" || status="$status, no \"$pattern\""; done
  [[ $status == "$1" ]] || { echo "quickstart $2: $status instead of $1" && cat "$scratch/out" "$CALLS" && troubles=$((troubles + 1)); }
}

for wrong in "" jump "install a b" "install --prefix=a" "install --no-python a b" "package a"; do ends 2 "$wrong"; done
ends 0 --help 'solid foot only for a study'
ends 0 run '^apt-get .*install --yes .*cmake' '^cmake --preset release --fresh -D STEMWARE_SOLID=OFF$' '^cmake --build .*--target stemware$' '3/4 .*without the solid foot' '^stemware run docs/cookbooks/wine_glass.prm --output results/wine_glass$'
(($(wc -l <"$scratch/out") <= 10)) && ! grep chromium "$CALLS" || { echo "run: says too much, or installs the browser" && troubles=$((troubles + 1)); }
ends 0 "run my_glass.prm --set Contact/Body=solid" '^cmake --preset release --fresh$' '--target stemware$' '^stemware run my_glass.prm --set Contact/Body=solid --output results/my_glass$'
printf '%s\n' "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" STEMWARE_SOLID:BOOL=OFF >build/release/CMakeCache.txt
ends 0 "run --set Contact/Body=solid" '^cmake --preset release -D STEMWARE_SOLID=ON$'
ends 0 "install $scratch/there" '^cmake --preset release -D STEMWARE_SOLID=ON$' '--target stemware$' "^cmake --install .*--prefix $scratch/there" 'Python package is left out'
echo STEMWARE_PYTHON:BOOL=ON >>build/release/CMakeCache.txt
ends 0 "install $scratch/there" '--target stemware stemware_python$' "^cmake --install .*--prefix $scratch/there --component python" "export PYTHONPATH=\"$scratch/there/lib/python3"
ends 0 "install --no-python $scratch/there" '--target stemware$' "^cmake --install .*--prefix $scratch/there --component program"
! grep -q 'component python' "$CALLS" || { echo "--no-python: installs the Python package" && troubles=$((troubles + 1)); }
ends 0 test '^apt-get .*chromium' '^cmake --build --preset release --parallel [0-9]+$' '^ctest --preset release$'
mkdir -p build/release && touch build/release/build.ninja && echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/release/CMakeCache.txt
ends 0 "run --yes" '^cmake --preset release$' # packages were installed
on_a_terminal() { script -qec "./quickstart run $1" /dev/null >"$scratch/out" 2>&1; } # answer on standard input, arguments
: >"$CALLS"
! on_a_terminal "" <<<n && grep -q 'apt-get install' "$scratch/out" && ! grep -q '^apt-get' "$CALLS" || { echo "n: installs" && cat "$scratch/out" "$CALLS" && troubles=$((troubles + 1)); }
on_a_terminal "" <<<y && grep -q '^apt-get .*install' "$CALLS" || { echo "y: does not install" && cat "$scratch/out" && troubles=$((troubles + 1)); }
on_a_terminal --yes </dev/null && ! grep -q 'Install them' "$scratch/out" || { echo "--yes: asks" && cat "$scratch/out" && troubles=$((troubles + 1)); }
stand_in apt-get '[[ -e $CALLS.mended ]] || { echo "dpkg was interrupted, you must manually run dpkg --configure -a"; exit 100; }'
stand_in dpkg '[[ $1 != --configure ]] || touch "$CALLS.mended"; [[ $1 != --print-architecture ]] || echo amd64'
ends 0 run '^dpkg --configure -a$' '^apt-get .*install'
stand_in dpkg '[[ $1 != --print-architecture ]] || echo amd64'
ends 0 run '^apt-get .*install'
! grep -q 'dpkg --configure' "$CALLS" || { echo "dpkg --configure without need" && troubles=$((troubles + 1)); }
ends 0 "test --long -j 3" '^ctest --preset release-long -j 3$'
ends 0 "test -R ring" '^ctest --preset release -R ring$'
stand_in cmake '[[ $* != *--build* ]] || sleep 60'
for signal in INT TERM; do
  : >"$scratch/out"
  env --default-signal=INT,TERM ./quickstart run >"$scratch/out" 2>&1 </dev/null & # a background job ignores SIGINT otherwise
  quickstart=$!
  for ((i = 0; i < 100; i++)); do grep -q "3/4" "$scratch/out" && break || sleep 0.1; done
  sleep 0.3
  start=$SECONDS status=0
  kill -s "$signal" "$quickstart"
  wait "$quickstart" || status=$?
  ((status == 130 && SECONDS - start < 10)) && grep -q "interrupted; the same command continues" "$scratch/out" || { echo "SIG$signal: $status" && troubles=$((troubles + 1)); }
done
stand_in cmake 'seq 100; [[ $* != *--build* ]] || { echo "the cause"; exit 1; }'
ends 1 run "the cause" "build/quickstart.log"
exit $((troubles > 0))
