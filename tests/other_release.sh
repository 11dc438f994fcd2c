#!/usr/bin/env bash
# Runs Stemware in a bare root of another Debian release (12 or 13).
# shellcheck disable=SC2016,SC2317 # the root's shell and apt expand the texts; traps call functions
set -euo pipefail

usage() {
  cat <<'HELP'
Runs Stemware in a bare root of a Debian release, without any other software.

  other_release.sh [OPTIONS] source [CTEST_ARGUMENT...]   in a clone of the commit: ./quickstart run, ./quickstart test
  other_release.sh [OPTIONS] package FILE.deb...          installs packages of Stemware and runs the default study
  other_release.sh [OPTIONS] root                         makes the root and stops
  other_release.sh [OPTIONS] in COMMAND...                runs a command in the root of the last time
  other_release.sh compare FILE FILE                      compares the numbers that two runs have printed

  --release bookworm|trixie   the release (default: not the release of this machine)
  --folder DIR                works in DIR and keeps it (default: a folder that is removed at the end)
  --again                     reuses the root of the last run instead of a bare one
  --run-only                  without ./quickstart test
  --commit COMMIT             the commit that is cloned (default: HEAD)
  --program FILE              the stemware of this machine (default: build/release/stemware); the numbers that both
                              print for three studies must be equal to one unit of the last digit

"source" and "package" report packages, megabytes, minutes and the answer. The root comes from the Debian mirror of
this machine's apt, through its proxy. It needs root and debootstrap; if these or the mirror are missing, it says so
and exits with 77 ("skipped" in ctest). STEMWARE_PRESET, CMAKE_BUILD_PARALLEL_LEVEL and CTEST_PARALLEL_LEVEL are passed
to ./quickstart.
HELP
}

source=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
# Studies that are compared: the glass on a mat and two solid feet.
studies=(
  "docs/cookbooks/mat.prm"
  "docs/cookbooks/oval_foot.prm"
  "docs/cookbooks/paper.prm --set Contact/Body=solid --set Contact/Linear\ solver=multigrid"
)

stop() { # sentence, exit code
  printf 'other_release: %s\n' "$1" >&2
  exit "${2:-1}"
}

skip() { stop "$1" 77; }

# ---- the root

# Prints the Debian archives of this machine's apt, one "URI SUITE" per line.
mirrors_of_this_machine() {
  apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' 2>/dev/null |
    grep -E " $this_release(-updates|-security)?\$" | sort -u || true
}

# Prints the same lines for the requested release.
mirrors() {
  local found
  found=$(mirrors_of_this_machine)
  printf '%s\n' "${found// $this_release/ $release}"
}

# Prints the proxy settings of apt, as lines of an apt.conf.
proxies() { apt-config dump 2>/dev/null | grep -E '^Acquire::[a-zA-Z]+::Proxy ' || true; }

# Runs a command in the root, with private namespaces: its mounts and processes end when the command ends or is killed.
in_root() {
  local status=0 variable environment=()
  for variable in STEMWARE_PRESET CMAKE_BUILD_PARALLEL_LEVEL CTEST_PARALLEL_LEVEL; do
    [[ -z ${!variable:-} ]] || environment+=("$variable=${!variable}")
  done
  # The inner shell stays alive and reaps orphans.
  unshare --mount --pid --fork --kill-child bash -c '
    set -e
    root=$1
    mount -t proc proc "$root/proc"
    mount -t sysfs -o ro sysfs "$root/sys"
    mount --rbind /dev "$root/dev"
    chroot "$@"
    exit' - "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    DEBIAN_FRONTEND=noninteractive "${environment[@]}" "$@" </dev/null &
  child=$!
  wait "$child" || status=$?
  child=''
  return "$status"
}

# $folder/bare-RELEASE, as debootstrap leaves it, with the apt settings of this machine.
make_bare_root() {
  local bare=$folder/bare-$release mirror suite
  [[ ! -d $bare ]] || return 0
  read -r mirror suite < <(mirrors | grep " $release\$") || skip "apt reads no Debian archive of $this_release on this machine."
  /usr/lib/apt/apt-helper download-file "${mirror%/}/dists/$suite/InRelease" "$folder/InRelease" >/dev/null 2>&1 ||
    skip "the mirror ${mirror} does not answer for $release."
  local proxy
  proxy=$(proxies | sed -nE 's/^Acquire::http::Proxy "(.*)";$/\1/p')
  [[ -z $proxy || $proxy == DIRECT ]] || export http_proxy=$proxy
  rm -rf --one-file-system -- "$bare.part"
  unshare --mount --pid --fork --kill-child debootstrap --variant=minbase --keyring="$keyring" "$release" "$bare.part" "$mirror" \
    >"$folder/debootstrap.log" 2>&1 </dev/null &
  child=$!
  wait "$child" || stop "debootstrap failed: $(tail -n 1 "$folder/debootstrap.log"), see $folder/debootstrap.log."
  child=''
  mirrors | sed 's/^\([^ ]*\) \(.*\)$/deb \1 \2 main/' >"$bare.part/etc/apt/sources.list"
  proxies >"$bare.part/etc/apt/apt.conf.d/90proxy"
  printf '#!/bin/sh\nexit 101\n' >"$bare.part/usr/sbin/policy-rc.d" # packages start no daemons
  chmod +x "$bare.part/usr/sbin/policy-rc.d"
  cp -L -- /etc/resolv.conf /etc/hosts "$bare.part/etc/"
  rm -rf -- "$bare.part"/var/cache/apt/archives/*.deb "$bare.part"/var/lib/apt/lists/*
  mv -- "$bare.part" "$bare"
}

# Checks the tools that a root needs. Sets release, folder and root.
prepare() {
  ((EUID == 0)) || skip "making a root of another release needs root."
  local command
  for command in apt-get debootstrap unshare git; do
    [[ -n $(command -v "$command") ]] || skip "there is no $command here (Debian packages: apt, debootstrap, util-linux, git)."
  done
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  [[ -r $keyring ]] || skip "there is no $keyring here (Debian package: debian-archive-keyring)."
  # shellcheck disable=SC1091 # a list of shell variables that every system has
  this_release=$(. /etc/os-release && [[ $ID != debian ]] || echo "${VERSION_CODENAME:-}")
  if [[ -z $release ]]; then
    release=trixie
    [[ $this_release != trixie ]] || release=bookworm
  fi
  if [[ -z $folder ]]; then
    folder=$(mktemp -d "${TMPDIR:-/var/tmp}/stemware-$release-XXXXXX")
    is_temporary=yes
  fi
  mkdir -p -- "$folder"
  folder=$(cd -- "$folder" && pwd -P)
  root=$folder/$release
}

clean_up() {
  trap '' INT TERM HUP
  if [[ -n $child ]]; then
    kill -KILL "$child" 2>/dev/null || true
    wait "$child" 2>/dev/null || true
  fi
  [[ -z $is_temporary ]] || rm -rf --one-file-system -- "$folder"
}

make_root() {
  [[ -z $again || ! -d $root ]] || return 0
  make_bare_root
  rm -rf --one-file-system -- "$root"
  cp -a -- "$folder/bare-$release" "$root"
}

# ---- reports

n_packages() { in_root dpkg-query --show --showformat='.\n' | wc -l; }
megabytes() { du -smx -- "$root" | cut -f 1; }
minutes_since() { awk -v s=$((SECONDS - $1)) 'BEGIN { printf "%.1f minutes", s / 60 }'; }

# Runs a command in the root, copies its output to a file of the folder, and adds its packages, size and time to the
# report.
reported() { # name, command...
  local start=$SECONDS packages size status=0
  packages=$(n_packages) size=$(megabytes)
  echo "==== $1"
  # Not through a pipe: a signal must reach the child.
  local screen copier
  exec {screen}> >(tee -- "$folder/$1.txt")
  copier=$!
  in_root "${@:2}" >&"$screen" 2>&1 || status=$?
  exec {screen}>&-
  wait "$copier"
  report+=("$(printf '%-16s exit code %d, %s, %d packages and %d MB more than before' "$1" "$status" "$(minutes_since "$start")" \
    "$(($(n_packages) - packages))" "$(($(megabytes) - size))")")
  ((status == 0)) || troubles=$((troubles + 1))
  return 0
}

# ---- numbers

# Prints the results in the output of a run, without the progress before and the paths after them.
results_in() { sed -e '1,/^$/d' -e '/^Results  /,$d' -- "$1"; }

# Prints each number on its own line, in ASCII.
tokens() { sed -E -e 's/−/-/g' -e 's/[-+]?[0-9]+(\.[0-9]+)?([eE][-+]?[0-9]+)?/\n&\n/g'; }

# Fails if the outputs of two runs differ by more than one unit in the last digit of a number.
compare() { # file, file
  local first second
  first=$(results_in "$1" | tokens) second=$(results_in "$2" | tokens)
  [[ -n $first ]] || stop "$1 holds no results."
  paste -d '\t' <(cat <<<"$first") <(cat <<<"$second") | LC_ALL=C awk -F '\t' '
    function unit(text,   decimals, exponent) { # value of one unit in the last printed digit
      exponent = match(text, /[eE]/) ? substr(text, RSTART + 1) : 0
      sub(/[eE].*/, "", text)
      decimals = match(text, /\./) ? length(text) - RSTART : 0
      return 10 ^ (exponent - decimals)
    }
    $1 "" == $2 "" { n_equal += $1 ~ /^[-+]?[0-9]/; next }
    $1 ~ /^[-+]?[0-9]/ && $2 ~ /^[-+]?[0-9]/ {
      largest = unit($1) > unit($2) ? unit($1) : unit($2) # 9.9e-07 and 1.0e-06 are one unit apart
      if (($1 - $2) ^ 2 < (1.01 * largest) ^ 2) { n_near++; next }
    }
    { printf "    \"%s\" and \"%s\"\n", $1, $2; n_different++ }
    END {
      printf "%d printed numbers equal, %d one unit apart, %d differences\n", n_equal, n_near, n_different
      exit n_different > 0 || n_equal + n_near == 0
    }'
}

# Runs the studies on this machine and in the root, and compares the outputs.
compare_studies() { # stemware of the root, folder of the cookbooks' parent in the root
  local n study words name result
  for ((n = 0; n < ${#studies[@]}; n++)); do
    study=${studies[n]}
    # shellcheck disable=SC2294 # words with blanks in them
    eval "words=($study)"
    name=numbers-$n
    echo "==== $study"
    (cd -- "$source" && OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 "$program" run "${words[@]}" \
      --output "$folder/$name") >"$folder/$name-here.txt" 2>&1 || true
    in_root sh -c 'cd "$1" && shift && OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 exec "$@"' - "$2" "$1" run "${words[@]}" \
      --output "/srv/$name" >"$folder/$name-there.txt" 2>&1 || true
    result=$(compare "$folder/$name-here.txt" "$folder/$name-there.txt") || troubles=$((troubles + 1))
    report+=("$(printf '%-16s %s: %s' "numbers" "$study" "$result")")
  done
}

# ---- verbs

source_commands() {
  git -C "$source" rev-parse --verify --quiet "$commit^{commit}" >/dev/null || skip "$source is no clone that has $commit."
  [[ -x $program ]] || stop "$program is missing; build it, or name another with --program."
  make_root
  rm -rf --one-file-system -- "$root/srv/stemware"
  git clone --quiet --no-hardlinks "$source" "$root/srv/stemware"
  git -C "$root/srv/stemware" checkout --quiet --detach "$(git -C "$source" rev-parse "$commit")"
  report=("Debian $(cat "$root/etc/debian_version") ($release), commit $(git -C "$root/srv/stemware" rev-parse --short HEAD), $(nproc) cores")
  report+=("bare             $(n_packages) packages, $(megabytes) MB")
  reported "quickstart-run" sh -c 'cd /srv/stemware && ./quickstart run'
  reported "quickstart-install" sh -c 'cd /srv/stemware && ./quickstart install /srv/installed' # with the solid foot
  grep -h -E "^Stemware |^[1-4]/4 .* s$" "$folder/quickstart-run.txt" | sed 's/^/    /' >"$folder/steps"
  mapfile -t -O "${#report[@]}" report <"$folder/steps"
  if [[ -x $root/srv/stemware/build/${STEMWARE_PRESET:-release}/stemware ]]; then
    compare_studies "./build/${STEMWARE_PRESET:-release}/stemware" /srv/stemware
  fi
  if [[ -z $run_only ]]; then
    reported "quickstart-test" sh -c 'cd /srv/stemware && exec ./quickstart test "$@"' - "$@"
    grep -h -E "^Stemware |^[1-4]/4 .* s$|tests passed|^[[:space:]]+[0-9]+ - " "$folder/quickstart-test.txt" | sed 's/^/    /' >"$folder/steps"
    mapfile -t -O "${#report[@]}" report <"$folder/steps"
  fi
  rm -f -- "$folder/steps"
}

package_commands() {
  (($#)) || stop "name the packages: other_release.sh package stemware.deb" 2
  [[ -x $program ]] || stop "$program is missing; build it, or name another with --program."
  make_root
  mkdir -p -- "$root/srv/packages"
  cp -- "$@" "$root/srv/packages/"
  report=("Debian $(cat "$root/etc/debian_version") ($release), $(nproc) cores")
  report+=("bare             $(n_packages) packages, $(megabytes) MB")
  reported "install" sh -c 'cd /srv && apt-get -qq update && apt-get -qq -o Dpkg::Use-Pty=0 install --yes ./packages/*.deb'
  reported "run" sh -c 'mkdir -p /srv/empty && cd /srv/empty && stemware run'
  mkdir -p -- "$root/srv/source/docs"
  cp -r -- "$source/docs/cookbooks" "$root/srv/source/docs/"
  cp -r -- "$source/meshes" "$root/srv/source/"
  compare_studies stemware /srv/source
}

release='' folder='' root='' keyring='' this_release='' is_temporary='' again='' run_only='' commit=HEAD child=''
program=$source/build/release/stemware
report=() troubles=0
while (($#)); do
  case $1 in
  --release | --folder | --commit | --program)
    (($# > 1)) || stop "$1 needs a value." 2
    declare "${1#--}=$2"
    shift 2
    ;;
  --again) again=yes && shift ;;
  --run-only) run_only=yes && shift ;;
  -h | --help) usage && exit 0 ;;
  *) break ;;
  esac
done
case ${1:-} in
compare)
  (($# == 3)) || stop "compare takes two files." 2
  compare "$2" "$3"
  exit
  ;;
root | source | package | in) ;;
*) stop "say what to do: source, package, root, in or compare; see --help." 2 ;;
esac
[[ $program == /* ]] || program=$PWD/$program

trap clean_up EXIT
trap 'exit 130' INT TERM HUP
verb=$1
shift
prepare
case $verb in
root)
  make_root
  echo "$root"
  ;;
in)
  [[ -d $root ]] || stop "there is no $root; make it first: other_release.sh --folder $folder root" 2
  in_root "$@"
  exit
  ;;
source) source_commands "$@" ;;
package) package_commands "$@" ;;
esac
((${#report[@]} == 0)) || printf '%s\n' "" "${report[@]}"
exit $((troubles > 0))
