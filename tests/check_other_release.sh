#!/usr/bin/env bash
# Checks the comparison of numbers in other_release.sh, and its messages if it cannot work.
#
#   check_other_release.sh SOURCE_FOLDER
# shellcheck disable=SC2317 # functions are called through expect()
set -euo pipefail

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
chmod 755 "$scratch"
mkdir "$scratch/tests" "$scratch/bin"
script=$scratch/tests/other_release.sh
cp -- "$1/tests/other_release.sh" "$script"

troubles=0
expect() { # what, then a command that must succeed
  "${@:2}" && return
  echo "other_release: $1"
  troubles=$((troubles + 1))
}
ends() { # exit code, then a command
  local status=0
  "${@:2}" >"$scratch/out" 2>&1 </dev/null || status=$?
  ((status == $1)) || { echo "exit code $status instead of $1:" && cat "$scratch/out" && return 1; }
}
shows() { grep -qE -e "$1" "$scratch/out" || { cat "$scratch/out" && return 1; }; }
ran() { # residual of an iteration, results
  printf '  step   residual\n  1   %s\n\n%s\n\nResults   here\n' "$@"
}

ran 1.0e-12 "It spins at −3.65098 ± 1.6e-06 rad/s, and so on: 12 rings." >"$scratch/one"
for case in "0 −3.65098 1.6e-06 spins" "0 −3.65099 1.6e-06 spins" "0 −3.65097 1.7e-06 spins" "1 −3.65100 1.6e-06 spins" \
  "1 +3.65098 1.6e-06 spins" "1 −3.65098 1.6e-05 spins" "1 −3.65098 1.8e-06 spins" "1 −3.65098 1.6e-06 stands"; do
  read -r expected spin band word <<<"$case"
  ran 2.0e-13 "It $word at $spin ± $band rad/s, and so on: 12 rings." >"$scratch/other"
  expect "$case" ends "$expected" "$script" compare "$scratch/one" "$scratch/other"
done
ran 1 "±9.9e-07" >"$scratch/below"
ran 1 "±1.0e-06" >"$scratch/above"
expect "a digit less may be one unit" ends 0 "$script" compare "$scratch/below" "$scratch/above"
ran 1 "±1.1e-06" >"$scratch/above"
expect "or two" ends 1 "$script" compare "$scratch/below" "$scratch/above"
expect "other words are refused" ends 1 "$script" compare "$scratch/one" "$scratch/other"
expect "the difference is shown" shows '"spins|stands'
ran 1 "It spins at −3.65098 ± 1.6e-06 rad/s, and so on: 12 rings. 7" >"$scratch/other"
expect "a further number is a difference" ends 1 "$script" compare "$scratch/one" "$scratch/other"
echo "stemware: no such file" >"$scratch/other"
expect "no results are no agreement" ends 1 "$script" compare "$scratch/other" "$scratch/other"
expect "that is said" shows "holds no results"

for wrong in "" jump "compare one" "--folder"; do
  # shellcheck disable=SC2086 # several words
  expect "\"$wrong\" is refused" ends 2 "$script" $wrong
done
as_root=()
as_nobody=()
if ((EUID == 0)); then
  as_nobody=(setpriv --reuid 65534 --regid 65534 --clear-groups)
else
  as_root=(unshare --user --map-root-user)
fi
expect "without root it is skipped" ends 77 "${as_nobody[@]}" "$script" root
expect "the reason is said" shows "needs root"
for command in bash dirname; do ln -s -- "$(command -v $command)" "$scratch/bin/"; done
if "${as_root[@]}" true 2>/dev/null; then
  expect "without debootstrap it is skipped" ends 77 "${as_root[@]}" env PATH="$scratch/bin" "$script" root
  expect "what is missing is said" shows "there is no [a-z-]+ here"
fi

((troubles == 0)) && echo "other_release compares and refuses as it should."
exit $((troubles > 0))
