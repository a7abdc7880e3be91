#!/bin/sh
# Checks that every option and command that --help of an installed program shows is in its manual
# page and its completions, and that shells which are there can read those.
# usage: check_documents.sh PREFIX MAN-FOLDER DATA-FOLDER
set -eu
cd "$1"
man_folder=$2/man1 data=$3 problems=0

complain() {
  echo "$1" >&2
  problems=$((problems + 1))
}

# The words in the second line of an option, and names of commands, are indented by two spaces.
options_of() { grep -oE '^  (-[a-zA-Z],)?--[a-z-]+' | grep -oE -e '--[a-z-]+'; }
commands_of() { sed -n '/^\(Subcommands\|Commands\):/,/^$/s/^  \([a-z]\{1,\}\) .*/\1/p'; }

for program in bin/mdbd-*; do
  name=$(basename "$program")
  commands=$("$program" --help | commands_of)
  words=$({
    "$program" --help | options_of
    for command in $commands; do "$program" "$command" --help | options_of; done
  } | sort -u)
  gzip -dc "$man_folder/$name.1.gz" | sed 's/\\-/-/g; s/\\f[BIR]/ /g' >page.txt
  for word in $words $commands; do
    grep -qE -e " $word( |,|\$)" page.txt || complain "$name: $word is not in the manual page"
    for file in "$data/bash-completion/completions/$name" "$data/zsh/vendor-completions/_$name"; do
      grep -qE -e "(^|[^a-z-])$word([^a-z-]|\$)" "$file" || complain "$name: $word is not in $file"
    done
    grep -qE -e "-[la] ${word#--} " "$data/fish/vendor_completions.d/$name.fish" ||
      complain "$name: $word is not completed by fish"
  done
  [ "$(echo "$words" | wc -l)" -ge 3 ] || complain "$name: options are not found in --help"
  if command -v bash >/dev/null; then bash -n "$data/bash-completion/completions/$name"; fi
  if command -v zsh >/dev/null; then zsh -n "$data/zsh/vendor-completions/_$name"; fi
  if command -v fish >/dev/null; then fish -n "$data/fish/vendor_completions.d/$name.fish"; fi
  if command -v mandoc >/dev/null; then mandoc -T lint -W error "$man_folder/$name.1.gz"; fi
done

# What bash offers.
if command -v bash >/dev/null; then
  bash -c '
    . "$0/mdbd-query" && . "$0/mdbd-db"
    offer() { COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); "_${1//-/_}"; echo "${COMPREPLY[*]}"; }
    [ "$(offer mdbd-query --sig)" = --signature ] &&
    [ "$(offer mdbd-query --signature mdbd-f)" = mdbd-fused ] &&
    [ "$(offer mdbd-query --db x)" = "" ] &&
    [ "$(offer mdbd-db ver)" = verify ] &&
    [ "$(offer mdbd-db export vectors "")" = "" ]
  ' "$data/bash-completion/completions" || complain "bash offers something else"
fi
[ "$problems" = 0 ]
