#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Configures by a preset: packaging/configure.sh PRESET. In a folder that another compiler was used in, CMake forgets the
# preset, CMakeLists.txt refuses, and the second call begins anew.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:?configure.sh: which preset?}
cmake --preset "$preset" >/dev/null 2>&1 || cmake --preset "$preset" >/dev/null
