#!/usr/bin/env bash
# process.sh TACT [RELATIONS]: the whole program from outside. Median time of `TACT dof FILE` over 51 runs, at most
# 20 ms; and, over a stream of RELATIONS (a million unless told), the peak of its memory early on and at the end:
# it may grow by 1 MiB at most. Exit 1 if a bound is missed or the stream is not answered line for line.
set -euo pipefail
tact=${1:?expected the path of the tact program}
relations=${2:-1000000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# Contacts on the faces of a box; the numbers change from line to line.
stream() {
  awk -v n="$1" 'BEGIN {
    for (i = 0; i < n; i++) {
      printf "{\"contacts\":["
      for (k = 0; k < 8; k++) {
        s = k % (i % 5 + 1) ? 1 : -1
        a = k < i % 9 ? i % 3 : int(i / 3 + k / 2) % 3
        point[0] = (i * 7 + k * 13) % 41 - 20
        point[1] = (i * 5 + k * 29) % 37 - 18
        point[2] = (i * 3 + k * 17) % 31 - 15
        normal[0] = normal[1] = normal[2] = 0
        point[a] = s * 25
        normal[a] = -s
        printf "%s{\"point\":[%d,%d.5,\"%d/3\"],", k ? "," : "", point[0], point[1], point[2]
        printf "\"planes\":[[%d,%d,%d]]}", normal[0], normal[1], normal[2]
      }
      print "]}"
    }
  }'
}

stream 1 >"$work/relation.json"
for ((i = 0; i < 51; i++)); do
  start=${EPOCHREALTIME/[.,]/}
  "$tact" dof "$work/relation.json" >"$work/answer"
  end=${EPOCHREALTIME/[.,]/}
  echo $((end - start))
done | sort -n >"$work/times"
median=$(sed -n 26p "$work/times")
echo "tact dof FILE: median $((median / 1000)).$(printf %03d $((median % 1000))) ms of 51 runs (at most 20 ms)"
if ((median > 20000)); then status=1; fi

mkfifo "$work/pipe"
stream "$relations" >"$work/pipe" &
start=${EPOCHREALTIME/[.,]/}
"$tact" dof --json - <"$work/pipe" >"$work/answers" &
pid=$!
while grep -s VmHWM "/proc/$pid/status" | tr -dc '0-9\n' >>"$work/peaks"; do sleep 0.05; done
wait "$pid"
end=${EPOCHREALTIME/[.,]/}
answers=$(wc -l <"$work/answers")
kinds=$(sort -u "$work/answers" | wc -l)
samples=$(wc -l <"$work/peaks")
early=$(sed -n "$((samples / 10 + 1))p" "$work/peaks")
late=$(tail -n 1 "$work/peaks")
echo "$answers answers ($kinds different) in $(((end - start) / 1000)) ms; peak memory $early KiB early on, $late KiB at the end"
if ((answers != relations)); then echo "expected $relations answers" && status=1; fi
if ((late - early > 1024)); then echo "memory grows" && status=1; fi
exit "$status"
