#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The main job end to end on real human motion: a boxer wears the simulated suit; its sound and inertia become
# joint angles, which are compared with the truth and exported. Everything lands in out/demo/.
#   packaging/demo.sh [--seconds N]    N: only so much of the motion
set -euo pipefail
cd "$(dirname "$0")/.."

duration=()
case "${1:-}" in
    "") ;;
    --seconds) duration=(--duration "${2:?demo.sh: --seconds needs a number}") ;;
    *) echo "usage: packaging/demo.sh [--seconds N]" >&2; exit 2 ;;
esac

motion=/usr/share/assimp/models/BVH/Boxing_Toes.bvh
out=out/demo
take=$out/boxer_001.noctule

times=()
step() {
    local name=$1 begin=$SECONDS
    shift
    "$@"
    times+=("$(printf '%5d s  %s' $((SECONDS - begin)) "$name")")
}

# The studio and devices are left out, two thirds of the whole build. Who has configured build/release keeps it as it is.
build() {
    [ -e build/release/bin/noctule ] || echo "Building for the first time: ten to twelve minutes of one core."
    if [ ! -e build/release/CMakeCache.txt ]; then
        packaging/configure.sh jobs
    elif [ ! -e build/release/build.ninja ]; then  # a configuration that broke off
        cmake build/release
    fi
    cmake --build build/release --parallel "$(nproc)" --target noctule
}
step "packages" packaging/dependencies.sh jobs
step "build" build
mkdir -p "$out"

noctule() {
    echo "+ noctule --batch $*" >&2
    build/release/bin/noctule --batch "$@"
}
step "simulate: the sound of the suit" noctule simulate --motion "$motion" --out "$take" --scenario nominal --level signal --seed 1 \
    "${duration[@]}" --overwrite
step "process: from sound to poses" noctule process "$take" --sensors AGD --root given --estimator manifold
evaluate() {
    noctule evaluate "$take" --report "$out/report.html" --overwrite --json >"$out/evaluation.json"
}
step "evaluate: against the truth" evaluate
step "export" noctule export "$take" --bvh "$out/boxer.bvh" --csv "$out/boxer.csv" --overwrite

echo
echo "Where the time went"
printf '%s\n' "${times[@]}"
echo
python3 -B packaging/acceptance/table1.py "$out/evaluation.json"
cat <<END

Take       $PWD/$take
Report     $PWD/$out/report.html
Animation  $PWD/$out/boxer.bvh
Positions  $PWD/$out/boxer.csv
END
if grep -q '^NOCTULE_QUICK:BOOL=ON' build/release/CMakeCache.txt; then
    echo
    echo "This build is for the demo: it has no studio, and calibration, import and reports are slower in it."
    echo "For work: packaging/package.sh, or cmake --preset release."
fi
