#!/usr/bin/env bash
# layering_selftest.sh SCRIPT: the layering script must accept a clean tree and refuse every planted breach by name.
set -eu
script=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
cases=0

clean_tree() {
  rm -rf "$work/tree"
  local room
  for room in algebra/a enumerators/e robot/r provers/p provers/check cli benchmarks tests; do
    mkdir -p "$work/tree/$room"
    printf '#pragma once\n#include <string>\n' >"$work/tree/$room/${room##*/}.h"
  done
  printf '#include "cli/cli.h"\n' >"$work/tree/cli/main.cc"
}

accepted() {  # accepted FILE LINE: LINE added to FILE breaks no rule
  cases=$((cases + 1))
  clean_tree
  printf '%s\n' "$2" >>"$work/tree/$1"
  if ! output=$("$script" "$work/tree"); then
    failures=$((failures + 1))
    echo "$1 with '$2': expected to be accepted, got: $output"
  fi
}

refused() {  # refused FILE LINE WORDS: LINE added to FILE is refused, naming FILE, its line and WORDS
  cases=$((cases + 1))
  clean_tree
  printf '%s\n' "$2" >>"$work/tree/$1"
  local line
  line=$(wc -l <"$work/tree/$1")
  if output=$("$script" "$work/tree"); then
    failures=$((failures + 1))
    echo "$1 with '$2': expected to be refused, was accepted"
  elif [[ $output != "$1:$line: "*"$3"* || $output == *$'\n'* ]]; then
    failures=$((failures + 1))
    echo "$1 with '$2': expected one line '$1:$line: ...$3...', got: $output"
  fi
}

declare -A header=([algebra]=algebra/a/a.h [enumerators]=enumerators/e/e.h [robot]=robot/r/r.h [provers]=provers/p/p.h
  [provers/check]=provers/check/check.h [cli]=cli/cli.h [benchmarks]=benchmarks/benchmarks.h [tests]=tests/tests.h)
declare -A may=([algebra]='algebra' [enumerators]='algebra enumerators' [robot]='algebra robot'
  [provers]='algebra enumerators robot provers' [provers/check]='provers/check'
  [cli]='algebra enumerators robot provers provers/check cli'
  [benchmarks]='algebra enumerators robot provers provers/check cli benchmarks'
  [tests]='algebra enumerators robot provers provers/check cli tests')

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

cases=$((cases + 1))
clean_tree
printf '#include <string>\n' >"$work/tree/robot/r/r.h"
if output=$("$script" "$work/tree") || [[ $output != 'robot/r/r.h:1: a header without #pragma once' ]]; then
  failures=$((failures + 1))
  echo "a header without #pragma once: expected to be refused by name, got: $output"
fi

echo "$cases cases, $failures failures"
((failures == 0))
