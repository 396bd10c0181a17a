#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds everything and runs every test, from a bare Debian 12: unit tests of what reads bytes from outside under
# sanitizers, the main job on a few seconds of motion, then all tests of the release build.
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

# The rooms that handle bytes from outside; all rooms and all checks of the asan-ubsan preset would take three times
# as long and are the figure "sanitizers" of packaging/acceptance.sh.
sanitized_rooms=(core_job core_suit core_inertial core_acoustics core_recording core_formats devices_driver_box)
sanitizers=address,bool,bounds,enum,float-cast-overflow,integer-divide-by-zero,return,shift
sanitizers+=,signed-integer-overflow,unreachable
sanitized_build=build/sanitized

build_release() {
    packaging/configure.sh release
    cmake --build --preset release --parallel "$jobs"
}

build_sanitized() {
    cmake --preset asan-ubsan -B "$sanitized_build" -D NOCTULE_SANITIZE="$sanitizers" \
        -D CMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" >/dev/null
    cmake --build "$sanitized_build" --parallel "$jobs" --target "${sanitized_rooms[@]/#/test_}"
}

run_sanitized() {
    ASAN_OPTIONS=detect_stack_use_after_return=1:check_initialization_order=1:strict_string_checks=1 \
        UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 \
        ctest --test-dir "$sanitized_build" --parallel "$jobs" --no-tests=error --output-on-failure --timeout 300 \
        --tests-regex "^($(IFS='|'; echo "${sanitized_rooms[*]}"))/"
}

step "packages" packaging/dependencies.sh
step "build, release" build_release
step "build, sanitized" build_sanitized
step "unit tests, sanitized" run_sanitized
step "the main job, five seconds of motion" packaging/demo.sh --seconds 5
printf '== times\n'
printf '%s\n' "${times[@]}"
echo "== all tests, release"
# Two more than processors: the tests on screens wait for most of their time.
exec ctest --preset release --parallel $((jobs + 2)) --no-tests=error
