#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
#
# autotest/run.sh [--quick|--full]
#
# Installs the test packages (Debian 12, Ubuntu), builds, and runs every test. The last line is
# "N passed, N failed", with ", N skipped" where tests were; the exit code is 0 only if none failed.
#   --quick  unit tests and the tests of the commands only
#   --full   also the whole matrix of real DEMs and profiles
# QMESH_TEST_DATA names a folder of real DEMs (default ../shared/data beside this tree); without it the tests that
# need them are skipped and say so. What each stage printed is kept in build/test-logs. All builds share one compiler
# cache (ccache). Stages that compile run beside those that use the commands.
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1
. utils/packages.sh

mode=default
case ${1-} in
  "") ;;
  --quick | --full) mode=${1#--} ;;
  *) echo "usage: autotest/run.sh [--quick|--full]" >&2; exit 2 ;;
esac

logs=$root/build/test-logs
cores=$(nproc)
passed=0 failed=0 skipped=0
export QMESH_TEST_DATA=${QMESH_TEST_DATA:-$root/../shared/data}
export QMESH_BIN=$root/build/bin/gdal2qmesh
if [ "$mode" = full ]; then export QMESH_FULL=1; fi
# For new build folders: the others keep what they were made with.
export CMAKE_GENERATOR=Ninja CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# ---- Counting -------------------------------------------------------------------------------------

add() {
  passed=$((passed + $1)) failed=$((failed + $2)) skipped=$((skipped + $3))
}

# The sum of the first numbers of all lines of a file that match.
sum_of() {
  grep -oE "$2" "$1" | awk '{ for (i = 1; i <= NF; ++i) if ($i ~ /^[0-9]+$/) { n += $i; break } } END { print n + 0 }'
}

# Test cases of GoogleTest programs run by `ctest -V`. A program that fails without naming a failed case (a crash, a
# time limit) counts as one failure.
count_ctest() {
  local log=$1 status=$2 ok bad missed programs named
  ok=$(sum_of "$log" '\[  PASSED  \] [0-9]+ tests?')
  bad=$(sum_of "$log" '\[  FAILED  \] [0-9]+ tests?, listed below')
  missed=$(sum_of "$log" '\[  SKIPPED \] [0-9]+ tests?, listed below')
  programs=$(sum_of "$log" '[0-9]+ tests failed out of')
  named=$(grep -cE '\[  FAILED  \] [0-9]+ tests?, listed below' "$log")
  if [ "$programs" -gt "$named" ]; then bad=$((bad + programs - named)); fi
  if [ "$status" != 0 ] && [ "$bad" = 0 ]; then bad=1; fi
  if [ "$ok" = 0 ] && [ "$bad" = 0 ]; then bad=1; fi
  add "$ok" "$bad" "$missed"
}

# The last line of pytest: "1 failed, 20 passed, 2 skipped in 3.45s".
count_pytest() {
  local log=$1 status=$2 last ok bad missed
  last=$(grep -E '(passed|failed|skipped|error|errors|no tests ran).* in [0-9.]+s' "$log" | tail -n 1)
  ok=$(sum_of <(echo "$last") '[0-9]+ passed')
  bad=$(($(sum_of <(echo "$last") '[0-9]+ failed') + $(sum_of <(echo "$last") '[0-9]+ errors?')))
  missed=$(sum_of <(echo "$last") '[0-9]+ skipped')
  if [ "$status" != 0 ] && [ "$bad" = 0 ]; then bad=1; fi
  add "$ok" "$bad" "$missed"
}

# A stage that is one check of its own.
count_one() {
  if [ "$2" = 0 ]; then add 1 0 0; else add 0 1 0; fi
}

# A stage that only prepares: nothing but its failure counts.
count_none() {
  if [ "$2" != 0 ]; then add 0 1 0; fi
}

# ---- Stages ---------------------------------------------------------------------------------------

# stage COUNTER NAME MINUTES COMMAND...: runs a command with a time limit, keeps its output in a log, counts, and
# prints the result; if it failed, also the end of the log. Returns the command's status.
stage() {
  local counter=$1 name=$2 minutes=$3 log status started=$SECONDS before_ok=$passed before_bad=$failed
  shift 3
  log=$logs/${name// /-}.log
  if declare -F "$1" >/dev/null; then "$@" >"$log" 2>&1 </dev/null
  else timeout --kill-after=20 "${minutes}m" "$@" >"$log" 2>&1 </dev/null; fi
  status=$?
  "$counter" "$log" "$status"
  echo "$(describe $((SECONDS - started)) $((passed - before_ok)) $((failed - before_bad)))"
  return "$status"
}

# What stage prints, at once: lines of two lanes do not mix. Uses the variables of stage.
describe() {
  printf '%-34s %5d s   %d passed, %d failed\n' "$name" "$1" "$2" "$3"
  grep -hE '^SKIPPED|^\[  SKIPPED \] [^0-9]|^Real DEMs not found' "$log" | sort -u | head -n 20 | sed 's/^/    /'
  if [ "$3" -gt 0 ]; then
    [ "$status" != 124 ] || echo "    stopped after $minutes minutes"
    echo "---- the end of $log"
    tail -n 120 "$log"
    echo "----"
  fi
}

# lane FUNCTION: runs a function that calls stages beside the rest of the script; join FUNCTION... waits and counts.
lane() {
  rm -f "$logs/$1.counts"
  (
    passed=0 failed=0 skipped=0
    "$1"
    echo "$passed $failed $skipped" >"$logs/$1.counts"
  ) &
}

join() {
  local name ok bad missed
  wait
  for name in "$@"; do
    if [ ! -e "$logs/$name.counts" ]; then echo "$name ended early"; add 0 1 0; continue; fi
    read -r ok bad missed <"$logs/$name.counts"
    add "$ok" "$bad" "$missed"
  done
}

# Ends what a process has started. Ctrl-C does not reach lanes by itself.
end_children() {
  local child
  for child in $(cat "/proc/$1/task/$1/children"); do
    end_children "$child"
    kill "$child"
  done 2>/dev/null
}
trap 'end_children $$; exit 130' INT TERM

# The build tree of a preset, its unit tests included.
build_preset() {
  cmake --preset "$1" && cmake --build --preset "$1" --parallel "$cores"
}

unit_tests() {
  timeout --kill-after=20 25m ctest --test-dir "$1" --parallel "$cores" --timeout 1200 -V
}

bench_programs() {
  local program count=0
  for program in build/bin/bench_*; do
    [ -x "$program" ] || continue
    count=$((count + 1))
    timeout 3m "$program" --benchmark_min_time=0.01 || return 1
  done
  [ "$count" -gt 0 ] || { echo "no benchmark program was built"; return 1; }
}

# Reproducible and checked by the hashes in package-lock.json; again only when that file changed.
node_packages() {
  local stamp=autotest/clients/node_modules/.installed
  if cmp -s autotest/clients/package-lock.json "$stamp"; then return 0; fi
  (cd autotest/clients && timeout 10m npm ci --no-audit --no-fund --ignore-scripts) &&
    cp autotest/clients/package-lock.json "$stamp"
}

python_with_gdal() {
  local python
  for python in python3 /usr/bin/python3; do
    if "$python" -c 'import numpy, pytest, osgeo.gdal' 2>/dev/null; then echo "$python"; return; fi
  done
  return 1
}

finish() {
  local tail=""
  if [ "$skipped" -gt 0 ]; then tail=", $skipped skipped"; fi
  echo "$passed passed, $failed failed$tail"
  [ "$failed" = 0 ]
  exit
}

# ---- The run --------------------------------------------------------------------------------------

mkdir -p "$logs"
if [ -d "$QMESH_TEST_DATA" ]; then
  echo "Real DEMs: $QMESH_TEST_DATA"
else
  echo "No real DEMs in $QMESH_TEST_DATA: the tests that need them are skipped (set QMESH_TEST_DATA)."
fi

stage count_none "packages" 15 qmesh_install "${QMESH_BUILD_PACKAGES[@]}" "${QMESH_TEST_PACKAGES[@]}" || finish
stage count_none "build" 15 build_preset developer || finish
stage count_ctest "unit tests" 15 unit_tests build

python=$(python_with_gdal) || {
  echo "No Python here imports numpy, pytest and osgeo.gdal."
  add 0 1 0
  finish
}
pytest=("$python" -m pytest -rs -q -p no:cacheprovider)
system_pytest=(/usr/bin/python3 -m pytest -rs -q -p no:cacheprovider)
# A file of tests stays in one process: its tests share tilesets.
spread=()
if "$python" -c 'import xdist' 2>/dev/null; then spread=(-n "$cores" --dist loadfile); fi

# What needs the commands and the driver of build/.
programs() {
  stage count_pytest "commands" "$([ "$mode" = full ] && echo 120 || echo 20)" \
    "${pytest[@]}" "${spread[@]}" autotest/utils
  stage count_pytest "driver" 10 "${pytest[@]}" "${spread[@]}" autotest/driver
  [ "$mode" != quick ] || return 0
  stage count_none "node packages" 10 node_packages &&
    stage count_pytest "clients" 15 "${pytest[@]}" autotest/clients
  stage count_none "documentation packages" 10 \
    qmesh_install "${QMESH_DOCS_PACKAGES[@]}" "${QMESH_DOCS_TEST_PACKAGES[@]}" &&
    stage count_pytest "documentation" 15 "${system_pytest[@]}" autotest/docs
  stage count_pytest "install" 10 "${system_pytest[@]}" autotest/install
  stage count_none "QGIS packages" 10 qmesh_install "${QMESH_QGIS_PACKAGES[@]}" &&
    stage count_pytest "QGIS" 10 "${system_pytest[@]}" autotest/qgis
}

# All unit tests but those that take minutes without optimization. They run in the other builds.
quick_cases="-PointSets.*:Seams.*:Compared.*:Determinism.*:Inherit.Every*:*EveryTerrainAndPlace:*OnTheGlobe/*"
quick_cases+=":PointSetBorder.*:*OnLargeTiles/*:*KeepsFinalEdges*:Quadtree.IsAMesh*:*/wlop:*/collapse:RealDems.*"

# What compiles, and runs what it compiled.
builds() {
  stage count_one "benchmark programs" 5 bench_programs
  stage count_one "newest GDAL headers" 8 autotest/driver/newest_gdal.sh
  stage count_none "build without CGAL" 15 build_preset without-cgal &&
    stage count_ctest "unit tests without CGAL" 15 unit_tests build-without-cgal &&
    stage count_pytest "methods without CGAL" 10 \
      env QMESH_BIN="$root/build-without-cgal/bin/gdal2qmesh" "${pytest[@]}" autotest/utils/test_methods.py
  stage count_none "build without optimization" 15 build_preset debug &&
    GTEST_FILTER=$quick_cases stage count_ctest "unit tests without optimization" 15 unit_tests build-debug
  stage count_none "build with sanitizers" 15 build_preset sanitize &&
    stage count_ctest "unit tests with sanitizers" 15 unit_tests build-sanitize
  stage count_one "fuzzing" 8 autotest/fuzz/run.sh build-fuzz 20
}

stage count_pytest "lint" 10 "${pytest[@]}" autotest/lint
if [ "$mode" = quick ]; then
  programs
else
  lane builds
  lane programs
  join builds programs
fi
finish
