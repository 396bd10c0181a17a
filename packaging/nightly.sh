#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The slow checks, which .ci/run leaves out. Any of the names, or all:
#   packaging/nightly.sh [debug|asan|tsan|gcc|jobs|tidy|odr|package|busy|examples]...
# debug: Eigen's assertions, matrices begin as NaN. asan: address and undefined over core and devices. tsan: the threads
# of devices and jobs. gcc: all tests with the other compiler. jobs: the smallest build, which says what it lacks.
# tidy: clang-tidy on what differs from the main branch (NOCTULE_BASE). odr: one definition in the whole program, seen at
# link time. package: packaging/test_package.sh. busy: all tests beside four loops that take the processors.
# examples: what reads takes in R and Octave, and completion for zsh; both are installed for it.
# What was run, with its result and time, ends in out/nightly/YYYY-MM-DD.md.
set -uo pipefail
cd "$(dirname "$0")/.."

all=(debug asan tsan gcc jobs tidy odr package busy examples)
chosen=("${@:-all}")
[ "${chosen[0]}" != all ] || chosen=("${all[@]}")
jobs=$(nproc)
mkdir -p out/nightly
log=out/nightly/$(date -u +%F).md
export ASAN_OPTIONS=detect_stack_use_after_return=1:check_initialization_order=1:strict_string_checks=1
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
export TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1

# The test programs whose names match, of a build folder.
test_targets() {
    cmake --build "$1" --target help | grep -oP "^test_$2\w*(?=: phony)" | sort -u
}

# Folder, pattern of the tests, more for ctest.
build_and_test() {
    local folder=$1 pattern=$2
    shift 2
    mapfile -t targets < <(test_targets "$folder" "$pattern")
    cmake --build "$folder" --parallel "$jobs" --target "${targets[@]}" &&
        ctest --test-dir "$folder" --parallel "$jobs" --no-tests=error --output-on-failure --timeout 1800 \
            --tests-regex "^$pattern" "$@"
}

run_debug() {
    # -O1: without it the fits of calibrations take ten times as long; assertions and NaN do not depend on it.
    cmake --preset dev -B build/debug -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ -D CMAKE_UNITY_BUILD=ON \
        -D CMAKE_UNITY_BUILD_BATCH_SIZE=0 -D CMAKE_CXX_FLAGS_DEBUG="-O1 -g1 -Wno-pass-failed" -D NOCTULE_STUDIO=OFF >/dev/null &&
        build_and_test build/debug "(core|devices)_"
}
run_asan() {
    cmake --preset asan-ubsan -D NOCTULE_STUDIO=OFF >/dev/null && build_and_test build/asan-ubsan "(core|devices)_"
}
run_tsan() {
    # Qt is not instrumented: what its event queue hands to another thread (TriggeredTake) looks like a race. Nor is
    # GDAL, which OpenCV opens to write pictures (WornExport): its locks look like a deadlock.
    cmake --preset tsan -D NOCTULE_STUDIO=OFF >/dev/null &&
        build_and_test build/tsan "(core_job|core_live|core_processing|devices_live)" --exclude-regex "TriggeredTake|WornExport"
}
run_gcc() {
    cmake --preset release -B build/gcc -D CMAKE_C_COMPILER=gcc -D CMAKE_CXX_COMPILER=g++ >/dev/null &&
        cmake --build build/gcc --parallel "$jobs" &&
        ctest --test-dir build/gcc --parallel "$jobs" --no-tests=error --output-on-failure
}
run_jobs() {
    cmake --fresh --preset jobs -B build/jobs >/dev/null &&
        cmake --build build/jobs --parallel "$jobs" --target noctule || return 1
    build/jobs/bin/noctule --batch record 2>&1 | grep "left out of this build"
    [ "${PIPESTATUS[*]}" = "2 0" ] && build/jobs/bin/noctule --batch estimators >/dev/null
}
run_tidy() {
    local base=${NOCTULE_BASE:-origin/main}
    cmake --preset dev -B build/tidy -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ \
        -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null || return 1
    mapfile -t files < <(git diff --name-only --diff-filter=d "$base" -- 'core/*.cpp' 'devices/*.cpp' 'app/*.cpp')
    [ ${#files[@]} -gt 0 ] || { echo "no source differs from $base"; return 0; }
    clang-tidy -p build/tidy --quiet --warnings-as-errors='*' "${files[@]}"
}
run_odr() {
    cmake --fresh --preset package -B build/odr -D CMAKE_C_COMPILER=gcc -D CMAKE_CXX_COMPILER=g++ \
        -D CMAKE_CXX_FLAGS="-flto=auto -Wodr -Werror=odr" \
        -D CMAKE_AR="$(command -v gcc-ar)" -D CMAKE_RANLIB="$(command -v gcc-ranlib)" >/dev/null &&
        cmake --build build/odr --parallel "$jobs" --target noctule noctule-virtual-suit
}
run_package() { packaging/test_package.sh; }
run_busy() {
    local loops=()
    for _ in 1 2 3 4; do (while :; do :; done) & loops+=($!); done
    packaging/configure.sh release && cmake --build --preset release --parallel "$jobs" &&
        ctest --preset release --parallel $((jobs + 3)) --no-tests=error --output-on-failure
    local result=$?
    kill "${loops[@]}"
    return $result
}
# What is skipped without R, Octave or zsh has to run here.
run_examples() {
    packaging/dependencies.sh examples && python3 tests/examples.py && packaging/configure.sh release &&
        cmake --build --preset release --parallel "$jobs" --target noctule noctule-write-help noctule-virtual-suit noctule-virtual-robot &&
        python3 tests/help_files.py build/release/bin/{noctule-write-help,noctule,}
}

packaging/dependencies.sh all || exit 1
echo "# $(date -u +'%F %H:%M') UTC, $(git describe --always --dirty 2>/dev/null || echo 'no git')" >>"$log"
failed=0
for name in "${chosen[@]}"; do
    declare -F "run_$name" >/dev/null || { echo "nightly: unknown part $name; choose ${all[*]}" >&2; exit 2; }
    begin=$SECONDS
    echo "== $name"
    "run_$name" && result=passed || { result=FAILED; failed=1; }
    echo "- $name: $result, $((SECONDS - begin)) s" | tee -a "$log"
done
exit $failed
