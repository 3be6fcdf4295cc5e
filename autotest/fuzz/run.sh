#!/bin/sh
# SPDX-License-Identifier: MIT
# Fuzzes every decoder for a short while with address and undefined-behaviour sanitizers.
# usage: run.sh BUILD_DIR [SECONDS_PER_TARGET]      needs clang with libFuzzer (Debian: clang,
# libclang-rt-dev). Exit code 0: nothing found; else the input that failed lies in BUILD_DIR/findings.
set -eu
if [ $# -lt 1 ]; then
  echo "usage: $0 BUILD_DIR [SECONDS_PER_TARGET]" >&2
  exit 2
fi
source_dir=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
build_dir=$1
seconds=${2:-30}
targets="fuzz_decode fuzz_gunzip fuzz_layer_json fuzz_surface"

cmake -S "$source_dir" -B "$build_dir" -DCMAKE_CXX_COMPILER="${CXX:-clang++}" \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DQMESH_BUILD_FUZZERS=ON -DQMESH_BUILD_TESTS=OFF \
  "-DQMESH_SANITIZE=address,undefined,fuzzer-no-link" >/dev/null
# shellcheck disable=SC2086
cmake --build "$build_dir" --parallel 2 --target $targets fuzz_seeds
build_dir=$(CDPATH= cd -- "$build_dir" && pwd)

mkdir -p "$build_dir/corpus" "$build_dir/findings"
"$build_dir/bin/fuzz_seeds" "$build_dir/corpus"
failed=0
for target in $targets; do
  echo "== $target, $seconds s"
  if "$build_dir/bin/$target" -max_total_time="$seconds" -max_len=4096 -timeout=10 \
    -rss_limit_mb=1024 -print_final_stats=1 -artifact_prefix="$build_dir/findings/$target-" \
    "$build_dir/corpus/$target" >"$build_dir/$target.log" 2>&1; then
    grep 'stat::number_of_executed_units' "$build_dir/$target.log"
  else
    failed=1
    tail -n 40 "$build_dir/$target.log" >&2
  fi
done
exit $failed
