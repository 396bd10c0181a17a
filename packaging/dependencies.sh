#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs on Debian 12 what building, testing and the demo need; quick when all of it is there.
# The comments name what CMakeLists.txt asks for; tests/architecture.py compares the two.
set -euo pipefail

packages=(
    g++ cmake ninja-build ccache clang-format
    python3              # Python3: the checks and the tables of figures, standard library only
    pkg-config           # PkgConfig
    libeigen3-dev        # Eigen3
    nlohmann-json3-dev   # nlohmann_json
    libsqlite3-dev       # SQLite3
    libzstd-dev          # libzstd
    zlib1g-dev           # ZLIB
    qtbase5-dev          # Qt5
    libqt5svg5-dev       # Qt5: Svg
    libqt5serialport5-dev # Qt5: SerialPort
    qttools5-dev         # Qt5: LinguistTools
    qttools5-dev-tools   # Qt5: lupdate, lrelease
    libqwt-qt5-dev       # Qt5Qwt6
    libqt5opengl5-dev    # Qt5Qwt6 asks for it
    libepoxy-dev         # epoxy
    libegl-dev           # epoxy: pictures without a screen
    libgl1-mesa-dri      # OpenGL without a graphics card
    fonts-roboto-unhinted # the studio's type
    xvfb                 # a screen for the studio's tests
    xauth                # xvfb-run needs it
    libgtest-dev         # GTest
    libgmock-dev         # GTest: its CMake configuration names both
    libbenchmark-dev     # benchmark
    libassimp-dev        # assimp
    libopencv-dev        # OpenCV: markers in photographs, films
    libopencv-contrib-dev # OpenCV: ArUco
    assimp-testmodels    # real human motion for tests, demo and figures
)

fail() {
    echo "dependencies: $1" >&2
    exit 1
}

installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null) || true
missing=()
for package in "${packages[@]}"; do
    grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

command -v apt-get >/dev/null ||
    fail "this is no Debian; install what these Debian 12 packages hold by hand: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "neither root nor sudo; let root run: apt-get install ${missing[*]}"
    as_root=(sudo)
fi

echo "dependencies: installing ${missing[*]}"
"${as_root[@]}" apt-get -qq update || fail "apt-get update failed; is the network there?"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq install -y --no-install-recommends "${missing[@]}" >/dev/null ||
    fail "apt-get could not install ${missing[*]}; on another Debian than 12 the names may differ"
