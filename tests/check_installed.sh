#!/usr/bin/env bash
# What is installed with the program: cookbooks, meshes, templates of pictures, licence, a manual page that can be read,
# completions that complete.
#
#   check_installed.sh PREFIX
# shellcheck disable=SC2317 # functions are called through expect() and by the completion
set -euo pipefail
share=$1/share
export PATH=$1/bin:$PATH

troubles=0
expect() { # what, then a command that must succeed
  "${@:2}" && return
  echo "installed program: $1"
  troubles=$((troubles + 1))
}

for file in doc/stemware/LICENSE stemware/cookbooks/lift_off.prm stemware/cookbooks/own_profile.csv stemware/meshes/oval_foot.msh stemware/plots/load.gp stemware/plots/style.gnuplot stemware/summary.schema.json; do
  expect "$file is installed" test -s "$share/$file"
done
expect "a cookbook runs where it lies" stemware mesh "$share/stemware/cookbooks/oval_foot.prm" --quiet

page=$share/man/man1/stemware.1
read_page() { if command -v man >/dev/null; then man -l "$page"; else sed 's/\\&//g; s/\\-/-/g' "$page"; fi; }
manual=$(read_page | sed 's/.\x08//g' | tr -s ' ' | tr '‐−' '--')
for text in "stemware run \[OPTIONS\] \[STUDY\]" "Exit codes:" "--output DIR" "STEMWARE SWEEP"; do
  expect "the manual has \"$text\"" grep -qe "$text" <<<"$manual"
done
if command -v groff >/dev/null; then
  expect "troff has nothing to say about the manual" test -z "$(groff -man -Tutf8 -ww -z "$page" 2>&1)"
fi

# shellcheck source=/dev/null # made by the program
source "$share/bash-completion/completions/stemware"
compopt() { :; } # there is no line to be completed here
completes() { # expected word, words of the command line; the last one is completed
  COMP_WORDS=("${@:2}") COMP_CWORD=$(($# - 2)) COMPREPLY=()
  _stemware stemware "${*: -1}" "${*: -2:1}"
  printf '%s\n' "${COMPREPLY[@]}" | grep -qxFe "$1" || { echo "${COMPREPLY[*]}" && return 1; }
}
expect "verbs are completed" completes sweep stemware sw
expect "options are completed" completes --rows stemware sweep --r
expect "sections are completed" completes Motion/ stemware run --set Mo
expect "entries are completed" completes "Motion/Friction coefficient" stemware run --set 'Motion/Friction\ c'
expect "tables are completed" completes "cork mat" stemware new my.prm --table co
expect "cookbooks are completed" completes lift_off stemware new --cookbook l
expect "sections of defaults are completed" completes Contact stemware defaults C
if command -v zsh >/dev/null; then
  expect "zsh can read its completion" zsh -n "$share"/zsh/*/_stemware
fi

((troubles == 0)) && echo "What is installed is complete."
exit $((troubles > 0))
