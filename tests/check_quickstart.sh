#!/usr/bin/env bash
# What ./quickstart does and says, with stand-ins for apt, CMake and the program that note how they are called.
#
#   check_quickstart.sh SOURCE_FOLDER
# shellcheck disable=SC2016,SC2317
# (The stand-ins expand their arguments, not this script; functions are called through expect().)
set -euo pipefail

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
mkdir -p "$scratch/clone" "$scratch/bin"
cp -- "$1"/{quickstart,packages.txt,CMakePresets.json} "$scratch/clone"
cd -- "$scratch/clone"
sed -i "s|/etc/os-release|$scratch/os-release|" quickstart
export PATH=$scratch/bin:$PATH CALLS=$scratch/calls
unset STEMWARE_PRESET CMAKE_BUILD_PARALLEL_LEVEL

stand_in() { # name, what it does
  printf '#!/usr/bin/env bash\necho "%s $*" >>"$CALLS"\n%s\n' "$1" "$2" >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}
stand_in dpkg-query 'echo "g++ installed"'
stand_in dpkg '[[ $1 != --print-architecture ]] || echo "$ARCHITECTURE"'
stand_in sudo '[[ $1 == -* ]] || exec "$@"'
stand_in apt-get 'case $* in *--assume-no*) printf "%s\n" "6 upgraded, 318 newly installed, 0 to remove and 9 not upgraded." "Need to get 293 MB/300 MB of archives." "After this operation, 1,953 MB of additional disk space will be used." ;; *) yes "Unpacking something" | head -n 500 ;; esac'
program='mkdir -p build/release; printf "%s\n" "#!/bin/sh" "echo \"stemware \$*\" >>\"\$CALLS\"" "echo Report" >build/release/stemware; chmod +x build/release/stemware'
stand_in cmake "yes 'Building something' | head -n 200; [[ \$* != *--build* ]] || { $program; }"

system() { # ID and VERSION_ID of its /etc/os-release, its architecture
  printf 'NAME="Some system"\nID=%s\nVERSION_ID="%s"\n' "$1" "$2" >"$scratch/os-release"
  export ARCHITECTURE=$3
}
system debian 12 amd64

troubles=0
expect() { # what, then a command that must succeed
  "${@:2}" && return
  echo "quickstart: $1"
  troubles=$((troubles + 1))
}
ends() { # exit code, then the arguments of quickstart
  local status=0
  : >"$CALLS"
  ./quickstart "${@:2}" >"$scratch/out" 2>&1 </dev/null || status=$?
  ((status == $1)) || { echo "exit code $status instead of $1:" && cat "$scratch/out" && return 1; }
}
shows() { grep -qE -e "$1" "$scratch/out" || { cat "$scratch/out" && return 1; }; }
hides() { ! shows "$1" >/dev/null || { cat "$scratch/out" && return 1; }; }
calls() { grep -qE -e "$1" "$CALLS" || { cat "$CALLS" && return 1; }; }

expect "help ends with 0" ends 0 --help
for wrong in "" jump "install a b" "install --prefix=a"; do
  # shellcheck disable=SC2086 # several words
  expect "\"$wrong\" is refused" ends 2 $wrong
done

expect "run works" ends 0 run
first=$(head -n 1 "$scratch/out")
expect "what it will do is said first: $first" grep -qE "installs 318 Debian packages \(293 MB to download, 1,953 MB on disk; upgrades 6 .* about [0-9]+ minutes" <<<"$first"
for part in "1/4 install" "2/4 configure" "3/4 build" "4/4 run" "stemware new"; do expect "$part is shown" shows "$part"; done
expect "apt and CMake are quiet" test "$(wc -l <"$scratch/out")" -le 12
expect "packages are installed" calls '^apt-get .*install --yes .*cmake'
expect "the browser is not installed for that" test -z "$(grep chromium "$CALLS")"
expect "the program alone is built" calls '^cmake --build .*--target stemware$'
expect "the default study is run" calls '^stemware run docs/cookbooks/wine_glass.prm --output results/wine_glass$'
expect "a study and its options reach the program" ends 0 run my_glass.prm --set "Motion/Mass=0.2"
expect "a study is run under its name" calls '^stemware run my_glass.prm --set Motion/Mass=0.2 --output results/my_glass$'

expect "of a system that works nothing is said" hides "known to work"
system debian 13 amd64
expect "Debian 13 works" ends 0 run
expect "of Debian 13 nothing is said" hides "known to work"
system ubuntu 24.04 amd64
expect "another system is tried" ends 0 run
expect "what is known to work is said" shows "known to work on Debian 12 and 13 on amd64; ubuntu 24.04 on amd64 has not been tried"
rm "$scratch/os-release"
expect "an unknown system is tried" ends 0 run
expect "what is known to work is said of it" shows "this system on amd64 has not been tried"
system debian 13 arm64
expect "arm64 is refused" ends 1 run
expect "the way out is said" shows "no deal.II for arm64.*docker run --platform linux/amd64"
expect "apt is not asked" test -z "$(grep ^apt-get "$CALLS")"
system debian 12 amd64
cp "$scratch/bin/apt-get" "$scratch/apt-get"
stand_in apt-get '[[ $* != *--assume-no* ]] || { printf "E: Unable to locate package %s\n" libdeal.ii-dev mold; exit 100; }'
expect "a package that does not exist ends with 1" ends 1 run
expect "it is named" shows "apt finds no package libdeal.ii-dev, mold here"
cp "$scratch/apt-get" "$scratch/bin/apt-get"

stand_in ctest 'echo "each test: ${STEMWARE_EACH_TEST:-no}" >>"$CALLS"'
expect "test works" ends 0 test
expect "it says how long that takes" shows "runs the tests: about [0-9]+ minutes"
expect "everything is built" calls '^cmake --build --preset release --parallel [0-9]+$'
expect "the tests are run without the long ones" calls '^ctest --preset release$'
expect "several of them in one process" calls '^each test: no$'
expect "the long tests can be had" ends 0 test --long -j 3
expect "they have a preset of their own" calls '^ctest --preset release-long -j 3$'
expect "a test is named" ends 0 test -R Wrench
expect "a name is looked for among all tests" calls '^ctest --preset release-long -R Wrench$'
expect "each of which is an entry" calls '^each test: 1$'
expect "labels reach ctest" ends 0 test -L quick
expect "a label is none of a name" calls '^ctest --preset release -L quick$'

stand_in cmake 'seq 100; [[ $* != *--build* ]] || { echo "the cause"; exit 1; }'
expect "a failing build ends with 1" ends 1 run
expect "the end of the log is shown" shows "the cause"
expect "the path of the log is shown" shows "$scratch/clone/build/quickstart.log"
expect "no more of it than its end" test "$(wc -l <"$scratch/out")" -le 25

stand_in cmake '[[ $* != *--build* ]] || sleep 60'
for signal in INT TERM; do
  : >"$scratch/out"
  # A shell starts its background jobs with SIGINT ignored; env gives them back what they had.
  env --default-signal=INT,TERM ./quickstart run >"$scratch/out" 2>&1 </dev/null &
  quickstart=$!
  for ((i = 0; i < 100; i++)); do if grep -q "3/4" "$scratch/out"; then break; else sleep 0.1; fi; done
  sleep 0.3
  kill -s "$signal" "$quickstart"
  start=$SECONDS status=0
  wait "$quickstart" || status=$?
  expect "SIG$signal ends with 130, not $status" test "$status" -eq 130
  expect "SIG$signal ends at once" test $((SECONDS - start)) -lt 10
  expect "SIG$signal is answered in a sentence" shows "interrupted; the same command goes on"
done

((troubles == 0)) && echo "quickstart does and says what it should."
exit $((troubles > 0))
