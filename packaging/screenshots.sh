#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fresh pictures of every page of the studio, dark and light, at 1280x800, 1440x900 and 1920x1080, into out/screenshots/.
#   packaging/screenshots.sh [TAKE]    TAKE: a processed take to show; a short simulated one when not given
# NOCTULE_SCREENSHOT_LANGUAGE=de: in German.
set -euo pipefail
cd "$(dirname "$0")/.."

out=$PWD/out/screenshots
packaging/dependencies.sh
packaging/configure.sh release
cmake --build --preset release --parallel "$(nproc)" --target test_ui_main_window noctule
rm -rf "$out"
mkdir -p "$out"
runtime=$(mktemp -d)
trap 'rm -rf "$runtime"' EXIT
build/release/bin/noctule --batch simulate --quiet --motion resources/motions/sample.bvh --duration 20 \
    --out "$runtime/suit.noctule"
cat >"$runtime/pair.json" <<EOF
{"shared_clock": true, "subjects": [
  {"name": "A", "motion": "$PWD/resources/motions/sample.bvh", "place": {"x_m": 0, "z_m": -1, "yaw_deg": 0}},
  {"name": "B", "motion": "$PWD/resources/motions/sample.bvh", "place": {"x_m": 0, "z_m": 1, "yaw_deg": 180}}]}
EOF
build/release/bin/noctule --batch simulate --quiet --cast "$runtime/pair.json" --level signal --duration 20 \
    --out "$runtime/pair.noctule"
NOCTULE_SCREENSHOTS=$out NOCTULE_SCREENSHOT_PAIR=$runtime/pair.noctule NOCTULE_SCREENSHOT_SUIT=$runtime/suit.noctule \
    NOCTULE_SCREENSHOT_TAKE=${1:+$(realpath "$1")} XDG_RUNTIME_DIR=$runtime LC_ALL=C.UTF-8 \
    xvfb-run -a -s "-screen 0 1920x1080x24 +extension GLX" \
    build/release/bin/test_ui_main_window --gtest_filter='Screenshots.*:ConnectPictures.*:RecordPictures.*:WizardPictures.*:TwoSuitsPictures.*'
ls "$out"
