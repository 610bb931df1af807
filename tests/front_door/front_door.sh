#!/usr/bin/env bash
# front_door.sh TACT: tries a copy of the script TACT in a tree of its own, against stand-ins for dpkg-query, apt-get,
# cmake, ninja and ctest that write each call to `calls` and keep the installed packages in `installed`.
# shellcheck disable=SC2016
set -eu
unset TACT_JOBS
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/tree
failures=0
mkdir -p "$work/bin" "$tree"
cp "$1" "$tree/tact"
printf '# comment\nalpha run\nbeta  run\ngamma test\n' >"$tree/packages.txt"
echo '{}' >"$tree/CMakePresets.json"

# Each stand-in reads all of its standard input, which must not be the user's.
stand_in() { printf '#!/usr/bin/env bash\ncd %q\ncat >/dev/null\n%s\n' "$work" "$2" >"$work/bin/$1"; }
stand_in dpkg-query 'cat installed; exit 1'
stand_in apt-get 'echo "apt-get $*" >>calls
case "$*" in
  *update*) touch updated ;;
  *install*) [[ -f updated ]] || exit 100
    for word; do [[ $word == @(alpha|beta|gamma) ]] && echo "installed $word" >>installed; done; true ;;
esac'
stand_in cmake 'echo "cmake $*" >>calls
[[ ! -f broken-cmake ]] || { echo "CMake Error: broken"; exit 1; }
mkdir -p tree/build/release/cli
{ echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD/tree"
  for word; do [[ $word == -D* ]] && echo "${word#-D}" | sed "s/=/:BOOL=/"; done; } >tree/build/release/CMakeCache.txt
echo >tree/build/release/build.ninja'
stand_in ninja 'echo "ninja ${*: -1}" >>calls
[[ ! -f broken-ninja ]] || { echo "[1/2] Building x"; echo "x.cc:1: error: broken"; exit 1; }
program=tree/build/release/cli/tact
[[ ! -f $program ]] || { echo "ninja: no work to do."; exit 0; }
echo "[1/1] Linking"
printf "#!/usr/bin/env bash\necho \"\$PWD|\$*|\$(cat)\"; exit 7\n" >$program; chmod +x $program'
stand_in ctest 'echo "ctest $*" >>calls; exit 8'
chmod +x "$work"/bin/*
export PATH=$work/bin:$PATH

expect() {  # expect WHAT WANTED GOT; WANTED is a pattern
  # shellcheck disable=SC2053
  [[ $3 == $2 ]] && return
  failures=$((failures + 1))
  printf '%s: expected\n%s\ngot\n%s\n\n' "$1" "$2" "$3"
}
# run ARGUMENT...: sets status, out, err and calls.
run() {
  : >"$work/calls"
  status=0
  out=$(cd "$work/elsewhere" && echo text | "${as[@]}" "$tree/tact" "$@" 2>"$work/err") || status=$?
  err=$(<"$work/err")
  calls=$(<"$work/calls")
}
mkdir "$work/elsewhere"
echo 'installed alpha' >"$work/installed"
as=()
off='-DTACT_BUILD_TESTS=OFF -DTACT_BUILD_BENCHMARKS=OFF'
on='-DTACT_BUILD_TESTS=ON -DTACT_BUILD_BENCHMARKS=ON'

chmod -R a+rwX "$work"
somebody=(setpriv --reuid=65534 --regid=65534 --clear-groups)
if ((EUID != 0)) || "${somebody[@]}" test -w "$tree"; then
  ((EUID != 0)) || as=("${somebody[@]}")
  run dof x
  expect 'without root: status' 4 "$status"
  expect 'without root: the line to run' '*run: sudo apt-get update && sudo apt-get install --no-install-recommends beta' "$err"
  expect 'without root: nothing is called' '' "$calls"
  as=()
  rm -rf "$tree/build"
fi
if ((EUID == 0)); then
  run dof 'a b'
  expect 'first run: only the missing package, update after a refusal, only the program' \
    "apt-get *install --no-install-recommends beta
apt-get *update
apt-get *install --no-install-recommends beta
cmake --preset release $off
ninja cli/tact" "$calls"
  expect 'first run: folder, arguments and standard input reach the program' "$work/elsewhere|dof a b|text" "$out"
  expect 'first run: the status is the program'"'s" 7 "$status"
  expect 'first run: says what it does' $'tact: installing beta\ntact: configuring *\ntact: building *' "$err"
else
  printf 'installed beta\ninstalled gamma\n' >>"$work/installed"
  run dof 'a b'
  expect 'first run' "cmake --preset release $off"$'\nninja cli/tact' "$calls"
fi

run dof
expect 'second run: only ninja is asked' 'ninja cli/tact' "$calls"
expect 'second run: nothing is said' '' "$err"

ln -s "$tree/tact" "$work/elsewhere/link"
out=$(cd "$work/elsewhere" && echo text | ./link modes) || true
expect 'through a link' "$work/elsewhere|modes|text" "$out"

run test --label quick -R Cone
((EUID != 0)) || gamma="apt-get *install --no-install-recommends gamma"$'\n'
expect 'test: its packages, everything, the label' "${gamma:-}cmake --preset release $on
ninja all
ctest *-j * -R Cone -L ^quick\$" "$calls"
expect 'test: the status is that of ctest' 8 "$status"
run test
expect 'test again: all labels, nothing configured' $'ninja all\nctest *-j *[0-9]' "$calls"
run test --label slow
expect 'test: a label that is none' "2 tact: --label: expected quick, full, robot or all, got 'slow'" "$status $err"
expect 'test: a label that is none runs nothing' '' "$calls"
run dof
expect 'the tests stay configured' 'ninja cli/tact' "$calls"
run fuzz soon
expect 'fuzz: no number' "2 tact: fuzz: expected a number of seconds, got 'soon'" "$status $err"

touch "$work/broken-ninja"
run dof
expect 'a broken build' '4 *x.cc:1: error: broken*tact: building failed in build/release' "$status $err"
rm "$work/broken-ninja"
run dof
expect 'mended' '7 ' "$status $err"

sed -i 's|=/.*|=/another/tree|' "$tree/build/release/CMakeCache.txt"
run dof
expect 'a build folder of another tree is made afresh' "cmake --preset release $off"$'\nninja cli/tact' "$calls"

touch "$work/broken-cmake"
rm "$tree/build/release/build.ninja"
run dof
expect 'a refusing cmake' '4 *CMake Error: broken*tact: cmake refused*' "$status $err"

((failures == 0)) && echo "the front door keeps its word"
