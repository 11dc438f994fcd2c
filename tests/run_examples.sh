#!/usr/bin/env bash
# Runs the examples of a page or of a --help text, with few cases, few ranks and coarse solid meshes; each must exit with
# code 0.
#
#   run_examples.sh SOURCE_FOLDER STEMWARE PAGE.md RESULTS            the code blocks and the `stemware ...` of a page
#   run_examples.sh SOURCE_FOLDER STEMWARE "help [VERB]" RESULTS      the examples of stemware [VERB] --help
#
# Examples of a page run in a clone; examples of --help run in an empty folder with only the installed program. A command
# that is in docs/studies.txt is not rerun: the folder RESULTS has its results from the same program and studies.
#
# Commands of one code block share a shell. Lines that begin with an unknown word are left to other tests. ./quickstart is
# not run; its verb and its study must exist.
set -euo pipefail

source=$1
program=$2
what=$3
results=$4
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
home=$scratch/home
mkdir -p "$scratch/bin" "$home"
ln -s -- "$program" "$scratch/bin/stemware"
ln -s -- "$source/tests/mpirun" "$scratch/bin/mpirun"
# Without jq, the whole line is printed.
command -v jq >/dev/null || { printf '#!/bin/sh\ncat\n' >"$scratch/bin/jq" && chmod +x "$scratch/bin/jq"; }
# shellcheck disable=SC2016 # for the script that is written
printf '#!/bin/sh\ntest -f "$1"\n' >"$scratch/bin/xdg-open"
chmod +x "$scratch/bin/xdg-open"
export PATH=$scratch/bin:$PATH
cd -- "$home"
# Files that the examples expect from the reader.
if [[ $what == help* ]]; then
  stemware new my_glass.prm >/dev/null
  [[ $what != *mesh ]] || stemware mesh --write my_foot.msh >/dev/null
  [[ $what != *sweep ]] || own_cases=yes
else
  own_cases=yes
  mkdir docs
  cp -r -- "$source/docs/cookbooks" docs/
  cp -r -- "$source/meshes" "$source/quickstart" .
  cp meshes/flat_foot.msh my_foot.msh
  for study in my_glass.prm glass.prm; do stemware defaults >$study; done
fi

# Cases without an elastic foot.
if [[ ${own_cases:-} ]]; then
  { echo "Load/Source,Motion/Mass (g)" && seq -f "first harmonic,%g" 201 204; } >cases.csv
fi

# Converts lines "BLOCK<tab>LINE" to lines "BLOCK<tab>COMMAND": joins continued lines and removes the remarks of --help
# (after three blanks).
commands_of() {
  sed -E -e ':join' -e '/\\$/{N;s/ *\\\n[^\t]*\t */ /;b join' -e '}' -e 's/\t +/\t/' -e 's/ {3,}[^-" ].*$//' |
    grep -E $'\t'"(stemware|build/release/stemware|mpirun|\./quickstart|cd|cat|xdg-open) " || true
}

# Prints the code blocks of a page, indented or fenced, and its complete inline commands.
# shellcheck disable=SC2016 # backticks of Markdown
examples_of_page() {
  {
    awk '/^```/ { fenced = !fenced; if (fenced) block++; inside = fenced; next }
         fenced { print block "\t" $0; next }
         /^    / { if (!inside) block++; inside = 1; print block "\t" substr($0, 5); next }
         { inside = 0 }' "$source/$what"
    grep -oE '`stemware [a-z]+ [^`<>…]*`' "$source/$what" | tr -d '`' | grep -vE '\[|DIR|STUDY|\.\.\.' |
      awk '{ print "inline" NR "\t" $0 }' || true
  } | commands_of
}

examples_of_help() {
  local verb=${what#help}
  # shellcheck disable=SC2086 # no verb: no word
  stemware ${verb# } --help | sed -n '/^Examples:/,/^$/p' | sed '1d;/^$/d' | awk '{ print "help\t" $0 }' | commands_of
}

# Prints the command with cheaper settings.
reduced() {
  local command
  command=$(sed -E -e 's/:[0-9]+(:log)?"/:2\1"/g' -e 's/--samples [0-9]+/--samples 4/' -e 's/mpirun -n [0-9]+/mpirun -n 2/' \
    -e 's|build/release/stemware|stemware|' -e 's/(Azimuthal cells)=[0-9]+/\1=24/' -e 's/--levels [0-9]+/--levels 3/' \
    -e 's/(Refinements|Foot layers|Degree)=2/\1=1/' <<<"$1")
  # The answer shows whether a command works; budget and bands are tested by the studies in docs/studies.txt.
  [[ $command == *--quick* || $examples == *budget.dat* ]] || command=$(sed -E 's/stemware run( |$)/stemware run --quick\1/' <<<"$command")
  # One contact is enough; a balance at every spin takes hundreds.
  local of_the_page=$source/docs/cookbooks/none
  [[ $command == *snippet.prm* ]] && of_the_page=docs/cookbooks/snippet.prm
  if [[ $command == *"stemware run"*"Contact/Body=solid"* || $command == mpirun* ]] || grep -qs "Body *= *solid" "$of_the_page"; then
    [[ $command == *"Load/Coupling="* ]] || command+=' --set "Load/Coupling=one-way"'
  fi
  if [[ $command == *"Table/Waviness="* ]]; then
    command+=' --set "Contact/Harmonics=6" --set "Contact/Azimuth lines=64"'
  fi
  if [[ $command == *"Contact/Body=solid"* && $command != *"Mesh file"* ]]; then
    local entry
    for entry in "Azimuthal cells=24" "Radial cells=4" "Degree=1" "Foot layers=1"; do
      [[ $command == *"${entry%=*}="* ]] || command+=" --set \"Contact/$entry\""
    done
  fi
  printf '%s' "$command"
}

# Copies the results of a command from RESULTS; fails if this program has no results there.
take_results() {
  [[ $1 != *--output* ]] || return 1
  local name verb study
  name=$(awk -v command="${1% --quiet}" '$1 ~ /^[a-z0-9_]+:$/ { name = $1; sub(/^[a-z0-9_]+: */, ""); if ($0 == command) { sub(/:/, "", name); print name; exit } }' \
    "$source/docs/studies.txt")
  local summary=$results/$name/summary.json
  [[ -n $name && $summary -nt $program && -z $(find "$source/docs/cookbooks" "$source/docs/studies.txt" "$source/meshes" -newer "$summary") ]] || return 1
  read -r _ verb study _ <<<"$1"
  [[ $study == *.prm ]] && study=$(basename -- "$study" .prm) || study=default
  [[ $verb == run ]] || study+=-$verb
  mkdir -p results && rm -rf -- "results/$study" && cp -r -- "$results/$name" "results/$study"
}

check_quickstart() {
  local verb study
  read -r _ verb study _ <<<"$1"
  grep -qE "^(run \| test \| install|help \| .*)\)" quickstart && [[ $verb =~ ^(run|test|install|package|--help)$ ]] || return 1
  [[ $verb != run || $study != *.prm || $study == my_* || -f $study ]]
}

if [[ $what == help* ]]; then examples=$(examples_of_help); else examples=$(examples_of_page); fi
# Runs the studies of a page in the folder of the cookbooks.
if [[ $what != help* ]]; then
  awk '/^    subsection/ { inside = 1 } inside { print substr($0, 5) } /^    end$/ { inside = 0 }' "$source/$what" >docs/cookbooks/snippet.prm
  [[ ! -s docs/cookbooks/snippet.prm ]] || examples+=$'\n'$'snippet\tstemware run docs/cookbooks/snippet.prm'
fi

status=0 block='' n=0
while IFS=$'\t' read -r next command; do
  [[ -n $command ]] || continue
  [[ $next == "$block" ]] || cd -- "$home"
  block=$next
  n=$((n + 1))
  start=$SECONDS
  if [[ $command == "stemware new "* ]]; then
    read -r _ _ study _ <<<"$command"
    rm -f -- "$study"     # an existing file is not overwritten
  fi
  # Examples of one study in the same folder are alternatives.
  if [[ $command == "stemware sweep "* && $command != *--output* ]]; then rm -rf -- results/*-sweep; fi
  if [[ $command == ./quickstart* ]]; then
    check_quickstart "$command" && result=0 || result=$?
  elif [[ $command == "cd "*" && "* ]]; then
    cd -- "$(sed -E 's/^cd ([^ ]+) .*/\1/' <<<"$command")" && bash -c "${command#* && }" && result=0 || result=$?
  elif [[ $command == "cd "* ]]; then
    cd -- "${command#cd }" && result=0 || result=$?
  elif take_results "$command"; then
    result=0
  else
    bash -c "set -o pipefail; $(reduced "$command")" >"$scratch/output" 2>&1 </dev/null && result=0 || result=$?
  fi
  printf '%s (%d s): exit code %d\n' "$command" "$((SECONDS - start))" "$result"
  if ((result != 0)); then
    sed 's/^/    /' "$scratch/output" | tail -n 12
    status=1
  fi
done <<<"$examples"
((n > 0)) || {
  echo "There are no examples in $what."
  status=1
}
exit "$status"
