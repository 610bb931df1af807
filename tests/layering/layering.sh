#!/usr/bin/env bash
# layering.sh ROOT: do the sources below ROOT keep the rules of the house? Each breach is a line `file:line: ...`.
# Rules: who may include whom; includes written from the root; no CGAL, Ipopt or Bullet in a header; no
# using-directive in a header; #pragma once in every header; no source over 600 lines; a folder's README.md has at
# most 25 lines; a link of a text leads somewhere.
set -euo pipefail
cd "$1"

rooms=()
for room in algebra enumerators robot provers cli benchmarks tests examples; do
  if [[ -d $room ]]; then rooms+=("$room"); fi
done
((${#rooms[@]})) || { echo "$1: expected algebra/ and its like, found none"; exit 1; }
mapfile -d '' -t sources < <(find "${rooms[@]}" \( -name '*.h' -o -name '*.cc' \) -print0 | sort -z)
((${#sources[@]})) || { echo "$1: expected sources, found none"; exit 1; }
mapfile -d '' -t texts < <(find . -maxdepth 1 -name '*.md' -printf '%f\0'; find "${rooms[@]}" -name '*.md' -print0)
status=0

if ((${#texts[@]})); then
  for text in "${texts[@]}"; do
    folder=.
    if [[ $text == */* ]]; then folder=${text%/*}; fi
    mapfile -t lines <"$text"
    if [[ $text == */README.md ]] && ((${#lines[@]} > 25)); then
      echo "$text:${#lines[@]}: ${#lines[@]} lines, at most 25"
      status=1
    fi
    for ((i = 0; i < ${#lines[@]}; i++)); do
      rest=${lines[i]}
      while [[ $rest =~ \]\(([^\)#:]+)\)(.*) ]]; do
        rest=${BASH_REMATCH[2]}
        [[ -e $folder/${BASH_REMATCH[1]} ]] && continue
        echo "$text:$((i + 1)): the link ${BASH_REMATCH[1]} leads nowhere"
        status=1
      done
    done
  done
fi

awk '
function breach(what) { printf "%s:%d: %s\n", FILENAME, FNR, what; breaches++ }
function exists(path,   line, status) { status = (getline line < path); close(path); return status >= 0 }

# The room of a path; the checker is a room of its own.
function room(path) { return path ~ /^provers\/check\// ? "provers/check" : substr(path, 1, index(path, "/") - 1) }

BEGIN {
  may["algebra"] = " algebra "
  may["enumerators"] = " algebra enumerators "
  may["robot"] = " algebra robot "
  may["provers"] = " algebra enumerators robot provers "
  may["provers/check"] = " provers/check "
  may["cli"] = " algebra enumerators robot provers provers/check cli "
  all = " algebra enumerators robot provers provers/check cli "
  may["benchmarks"] = all "benchmarks "
  may["tests"] = all "benchmarks tests "
  may["examples"] = all "examples "
}

function end_of_file() {
  if (previous ~ /\.h$/ && !once) { printf "%s:1: a header without #pragma once\n", previous; breaches++ }
  if (lines > 600) { printf "%s:%d: %d lines, at most 600\n", previous, lines, lines; breaches++ }
}
FNR == 1 { if (previous != "") end_of_file(); previous = FILENAME; once = 0; here = room(FILENAME); header = FILENAME ~ /\.h$/ }
{ lines = FNR }
/^[[:space:]]*#[[:space:]]*pragma[[:space:]]+once/ { once = 1 }
header && /^[[:space:]]*using[[:space:]]+namespace[[:space:]]/ { breach("a using-directive in a header") }
/^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]/ {
  path = $0
  sub(/^[^<"]*/, "", path)
  quoted = path ~ /^"/
  path = substr(path, 2)
  sub(/[>"].*/, "", path)
  if (header && path ~ /^(CGAL|coin|coin-or|bullet)\/|^Ip[A-Z]|^bt[A-Z]|^Bullet/) breach("<" path "> in a header; it belongs in a .cc")
  there = room(path)
  if (there in may && !quoted) breach("<" path "> is ours: write it in quotes")
  if (quoted && !exists(path)) breach("\"" path "\" is not written from the root of the tree")
  if (there in may && index(may[here], " " there " ") == 0) breach(here " may not include " there " (\"" path "\")")
}
END { end_of_file(); exit breaches > 0 }
' "${sources[@]}" || status=1
exit "$status"
