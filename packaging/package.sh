#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Debian package, without tests and screens, into out/packages/.
#   packaging/package.sh [BUILD]    BUILD: a configured build folder to take the programs from, such as build/release;
#                                   build/package, made when it is missing, unless given
set -euo pipefail
cd "$(dirname "$0")/.."

packaging/dependencies.sh package
build=${1:-build/package}
if [ $# -eq 0 ]; then
    packaging/configure.sh package
else
    cmake "$build" >/dev/null    # asks for the version again
fi
cmake --build "$build" --parallel "$(nproc)" --target installed
rm -rf "$build/packages"
(cd "$build" && cpack --config CPackConfig.cmake >packages.log) || { cat "$build/packages.log" >&2; exit 1; }
mkdir -p out/packages
rm -f out/packages/noctule_*.deb
cp "$build"/packages/noctule_*.deb out/packages/
ls out/packages/noctule_*.deb
