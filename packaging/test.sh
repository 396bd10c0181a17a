#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds everything and runs every test, from a bare Debian 12: the main job on a few seconds of motion, then all tests of
# the release build. Under sanitizers, with assertions, with the other compiler: packaging/nightly.sh.
set -euo pipefail
cd "$(dirname "$0")/.."

jobs=$(nproc)
times=()
step() {
    local name=$1 begin=$SECONDS
    shift
    echo "== $name"
    "$@"
    times+=("$(printf '%5d s  %s' $((SECONDS - begin)) "$name")")
}

build_release() {
    packaging/configure.sh release
    cmake --build --preset release --parallel "$jobs"
}

step "packages" packaging/dependencies.sh
step "build, release" build_release
step "the main job, five seconds of motion" packaging/demo.sh --seconds 5
printf '== times\n'
printf '%s\n' "${times[@]}"
echo "== all tests, release"
# Three more than processors: the tests on screens wait for most of their time.
result=0
ctest --preset release --parallel $((jobs + 3)) --no-tests=error || result=$?
# A suite is one test of CTest: its single tests that failed, with what they said, are told last.
failed=$(awk '/^\[ RUN / { said = "" } { said = said $0 "\n" } /^\[  FAILED  \] .* \([0-9]+ ms\)$/ { print said }' \
    build/release/Testing/Temporary/LastTest.log)
left_out=$(grep -A1 ': Skipped$' build/release/Testing/Temporary/LastTest.log | grep -v -e ': Skipped$' -e '^--$' | sort | uniq -c || true)
[ -z "$left_out" ] || printf '== tests left out, how many and why\n%s\n' "$left_out"
[ -z "$failed" ] || printf '== single tests that failed\n%s\n' "$(tail -n 200 <<<"$failed")"
exit $result
