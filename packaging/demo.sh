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

packaging/dependencies.sh
cmake --preset release >/dev/null
cmake --build --preset release --parallel "$(nproc)" --target noctule
mkdir -p "$out"

noctule() {
    echo "+ noctule --batch $*" >&2
    build/release/bin/noctule --batch "$@"
}
noctule simulate --motion "$motion" --out "$take" --scenario nominal --level signal --seed 1 \
    "${duration[@]}" --overwrite
noctule process "$take" --sensors AGD --root given --estimator manifold
noctule evaluate "$take" --report "$out/report.html" --overwrite --json >"$out/evaluation.json"
noctule export "$take" --bvh "$out/boxer.bvh" --csv "$out/boxer.csv" --overwrite

echo
python3 -B packaging/acceptance/table1.py "$out/evaluation.json"
cat <<END

Take       $PWD/$take
Report     $PWD/$out/report.html
Animation  $PWD/$out/boxer.bvh
Positions  $PWD/$out/boxer.csv
END
