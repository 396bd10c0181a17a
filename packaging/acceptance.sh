#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The full figures, by name, as in packaging/acceptance.sh table1 accuracy partial referee drift bounds ground benchmarks
# speed studio live record accessibility blender calibration cast rooms real robot kills beside motions hostile
# hostile-sanitized fuzz sanitizers long-fuzz (or all).
# They go into out/acceptance/YYYY-MM-DD.md, which packaging/acceptance/results.md is taken from.
set -euo pipefail
cd "$(dirname "$0")/.."

packaging/dependencies.sh
python3 -B packaging/acceptance --check "$@"
packaging/configure.sh release
cmake --build --preset release --parallel "$(nproc)" --target all benchmarks
exec python3 -B packaging/acceptance "$@"
