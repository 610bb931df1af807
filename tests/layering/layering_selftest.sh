#!/usr/bin/env bash
# layering_selftest.sh SCRIPT: the layering script must accept a clean tree and refuse every planted breach by name.
set -eu
script=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
cases=0

for room in algebra/a enumerators/e robot/r provers/p provers/check cli benchmarks tests; do
  mkdir -p "$work/$room"
  printf '#pragma once\n#include <string>\n' >"$work/$room/${room##*/}.h"
done
printf '#include "cli/cli.h"\n' >"$work/cli/main.cc"
printf '# cli\n[the header](cli.h), [a place](https://example.org/), [above](../README.md)\n' >"$work/cli/README.md"
printf '# all\n[cli](cli)\n' >"$work/README.md"

# with FILE TEXT: output and status of the script for the clean tree with TEXT added to FILE; lines is FILE's length.
with() {
  local original
  original=$(<"$work/$1")
  printf '%s\n' "$2" >>"$work/$1"
  mapfile -t lines <"$work/$1"
  status=0
  output=$("$script" "$work") || status=$?
  printf '%s\n' "$original" >"$work/$1"
  cases=$((cases + 1))
}

accepted() {  # accepted FILE TEXT: TEXT added to FILE breaks no rule
  with "$1" "$2"
  ((status)) || return 0
  failures=$((failures + 1))
  echo "$1 with '$2': expected to be accepted, got: $output"
}

refused() {  # refused FILE TEXT WORDS: TEXT added to FILE is refused in one line that names FILE, its line and WORDS
  with "$1" "$2"
  [[ $status != 1 || $output != "$1:${#lines[@]}: "*"$3"* || $output == *$'\n'* ]] || return 0
  failures=$((failures + 1))
  echo "$1 with '$2': expected status 1 and one line '$1:${#lines[@]}: ...$3...', got status $status: $output"
}

declare -A header=([algebra]=algebra/a/a.h [enumerators]=enumerators/e/e.h [robot]=robot/r/r.h [provers]=provers/p/p.h
  [provers/check]=provers/check/check.h [cli]=cli/cli.h [benchmarks]=benchmarks/benchmarks.h [tests]=tests/tests.h)
declare -A may=([algebra]='algebra' [enumerators]='algebra enumerators' [robot]='algebra robot'
  [provers]='algebra enumerators robot provers' [provers/check]='provers/check'
  [cli]='algebra enumerators robot provers provers/check cli'
  [benchmarks]='algebra enumerators robot provers provers/check cli benchmarks'
  [tests]='algebra enumerators robot provers provers/check cli benchmarks tests')

# Every pair of rooms, in both directions.
for from in "${!header[@]}"; do
  for to in "${!header[@]}"; do
    include="#include \"${header[$to]}\""
    if [[ " ${may[$from]} " == *" $to "* ]]; then
      accepted "${header[$from]}" "$include"
    else
      refused "${header[$from]}" "$include" "$from may not include $to "
    fi
  done
done

refused algebra/a/a.h '#  include "cli/cli.h"  // spaced' 'algebra may not include cli '
refused robot/r/r.h '#include <algebra/a/a.h>' 'write it in quotes'
refused algebra/a/a.h '#include "a.h"' 'not written from the root'
refused algebra/a/a.h '#include "algebra/a/absent.h"' 'not written from the root'
refused robot/r/r.h '#include <CGAL/Surface_mesh.h>' 'belongs in a .cc'
refused robot/r/r.h '#include <coin/IpTNLP.hpp>' 'belongs in a .cc'
refused robot/r/r.h '#include <IpIpoptApplication.hpp>' 'belongs in a .cc'
refused robot/r/r.h '#include <btBulletDynamicsCommon.h>' 'belongs in a .cc'
refused robot/r/r.h '#include <bullet/btBulletCollisionCommon.h>' 'belongs in a .cc'
refused robot/r/r.h 'using namespace std;' 'using-directive'
accepted cli/main.cc 'using namespace std;'
accepted cli/main.cc '#include <CGAL/Surface_mesh.h>'
accepted algebra/a/a.h '// using namespace std;'
refused cli/main.cc "$(yes '//' | head -n 600)" '601 lines'
accepted cli/main.cc "$(yes '//' | head -n 599)"

accepted README.md "$(yes | head -n 30)"
accepted cli/README.md "$(yes | head -n 23)"
refused cli/README.md "$(yes | head -n 24)" '26 lines, at most 25'
refused cli/README.md '[this](cli.h) and [that](absent.h)' 'the link absent.h leads nowhere'
refused README.md '[checker](provers/check) and [that](absent)' 'the link absent leads nowhere'

cases=$((cases + 1))
printf '#include <string>\n' >"$work/robot/r/r.h"
if output=$("$script" "$work") || [[ $output != 'robot/r/r.h:1: a header without #pragma once' ]]; then
  failures=$((failures + 1))
  echo "a header without #pragma once: expected to be refused by name, got: $output"
fi

echo "$cases cases, $failures failures"
((failures == 0))
