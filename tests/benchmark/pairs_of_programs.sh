#!/usr/bin/env bash
# Measures user CPU and wall clock of two programs for the same studies, alternately.
set -euo pipefail

usage() {
  cat <<'HELP'
Measures the time of two programs for the same studies, alternately.

  pairs_of_programs.sh [OPTIONS] OLD NEW [STUDY...]

OLD and NEW are programs ("stemware", as built from two commits). Prints for each study the medians of user CPU and of
wall clock in seconds, children included, and NEW over OLD. Compare only ratios of one run: the speed of a machine
changes from hour to hour.

  --rounds N     how often each runs (default: 3)
  --sweep N      a sweep of N cases on bare hardwood too (default: none)

Studies: mat wood rough cork disc wavy solid (default: all but solid, which takes minutes)
HELP
}

source=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
cookbooks=$source/docs/cookbooks
rounds=3 sweep=0

# Prints the arguments of a study, one per line.
arguments_of() { # name
  case $1 in
  mat) printf '%s\n' run "$cookbooks/wine_glass.prm" ;;
  wood) printf '%s\n' run "$cookbooks/bare_wood.prm" ;;
  rough) printf '%s\n' run "$cookbooks/bare_wood.prm" --set Table/Interface=rough ;;
  cork) printf '%s\n' run "$cookbooks/soft_cork.prm" ;;
  disc) # glass disc below the foot
    printf '%s\n' run "$cookbooks/bare_wood.prm" --set 'Motion/Centre of mass height=0.10' --set 'Motion/Force offset=-0.05' \
      --set Table/Interface=hard --set Table/Substrate=elastic --set 'Table/Disc Young modulus=70e9' \
      --set 'Table/Disc Poisson ratio=0.22' --set 'Table/Disc radius=0.15' --set 'Table/Disc thickness=0.05'
    ;;
  wavy) printf '%s\n' run "$cookbooks/three_point_waviness.prm" ;;
  solid)
    printf '%s\n' run "$cookbooks/lift_off.prm" --set Contact/Body=solid --set Glass/Shape=step \
      --set 'Contact/Azimuthal cells=96' --set 'Contact/Radial cells=8' --set 'Contact/Foot layers=4' \
      --set Contact/Degree=2
    ;;
  sweep) printf '%s\n' sweep "$cookbooks/bare_wood.prm" --vary "Motion/Friction coefficient=0.2:0.4:$sweep" ;;
  *)
    printf 'pairs_of_programs: there is no study "%s"\n' "$1" >&2
    exit 2
    ;;
  esac
}

median() { sort -n | awk '{ value[NR] = $1 } END { print (value[int((NR + 1) / 2)] + value[int(NR / 2) + 1]) / 2 }'; }

while (($#)); do
  case $1 in
  --help) usage && exit ;;
  --rounds) rounds=$2 && shift 2 ;;
  --sweep) sweep=$2 && shift 2 ;;
  -*) usage >&2 && exit 2 ;;
  *) break ;;
  esac
done
(($# >= 2)) || { usage >&2 && exit 2; }
declare -A programs=([old]=$(readlink -f "$1") [new]=$(readlink -f "$2"))
shift 2
studies=("$@")
((${#studies[@]})) || studies=(mat wood rough cork disc wavy)
((sweep == 0)) || studies+=(sweep)

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
TIMEFORMAT='%U %R'
printf '%-8s %31s %31s\n' '' 'user CPU: old      new    ratio' 'wall: old      new    ratio'
for study in "${studies[@]}"; do
  mapfile -t arguments < <(arguments_of "$study")
  ((${#arguments[@]})) || exit 2
  for ((round = 0; round < rounds; ++round)); do
    for program in old new; do
      rm -rf "$folder/results"
      { time "${programs[$program]}" "${arguments[@]}" --output "$folder/results" >/dev/null 2>"$folder/messages" ||
        printf 'pairs_of_programs: %s failed on %s\n' "${programs[$program]}" "$study" >&2; } 2>>"$folder/$study.$program"
    done
  done
  for column in 1 2; do
    for program in old new; do
      grep -E '^[0-9.]+ [0-9.]+$' "$folder/$study.$program" | cut -d' ' -f$column | median
    done
  done | paste -s | awk -v study="$study" \
    '{ printf "%-8s %15.2f %8.2f %6.2f %15.2f %8.2f %6.2f\n", study, $1, $2, $2 / $1, $3, $4, $4 / $3 }'
done
