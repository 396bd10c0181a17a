#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs on Debian 12 what a part of the work needs; quick when all of it is there.
#   packaging/dependencies.sh [jobs|package|all|examples]    jobs: building `noctule --batch` and the demo; package: building
#   the package too; all (default): tests, benchmarks and checks too; examples: R, Octave and zsh alone, which some tests
#   leave out without them (300 MB)
# The comments name what CMakeLists.txt asks for; tests/architecture.py compares the two.
set -euo pipefail

jobs_need=(
    g++ cmake ninja-build
    clang                # builds in four fifths of the time of GCC, which builds the preset dev
    python3              # Python3: the checks and the tables of figures, standard library only
    pkg-config           # PkgConfig
    libeigen3-dev        # Eigen3
    nlohmann-json3-dev   # nlohmann_json
    libsqlite3-dev       # SQLite3
    libzstd-dev          # libzstd
    zlib1g-dev           # ZLIB
    libexpat1-dev        # EXPAT
    qtbase5-dev          # Qt5
    libqt5serialport5-dev # Qt5: SerialPort
    libqt5websockets5-dev # Qt5: WebSockets
    libepoxy-dev         # epoxy
    liburdfdom-dev       # urdfdom: robots; brings tinyxml and console_bridge
    libegl-dev           # epoxy: pictures without a screen
    libgl1-mesa-dri      # OpenGL without a graphics card
    libassimp-dev        # assimp
    libopencv-dev        # OpenCV: markers in photographs, films
    libopencv-contrib-dev # OpenCV: ArUco
    assimp-testmodels    # real human motion for tests, demo and figures
)
package_needs=(
    dpkg-dev             # dpkg-shlibdeps: what the package depends on
    libqt5svg5-dev       # Qt5: Svg
    qttools5-dev         # Qt5: LinguistTools
    qttools5-dev-tools   # Qt5: lupdate, lrelease
    libqt5texttospeech5-dev # Qt5: TextToSpeech, spoken cues
    qttranslations5-l10n # Qt's own words in German: its dialogs, menus and keys
    libqwt-qt5-dev       # Qt5Qwt6
    libqt5opengl5-dev    # Qt5Qwt6 asks for it
    fonts-roboto-unhinted # the studio's type
)
tests_need=(
    ccache clang-format
    xvfb                 # a screen for the studio's tests
    xauth                # xvfb-run needs it
    libgtest-dev         # GTest
    libgmock-dev         # GTest: its CMake configuration names both
    libbenchmark-dev     # benchmark
    liborocos-kdl-dev    # orocos_kdl: kinematics to compare ours with
    libkdl-parser-dev    # its reader of URDF
    libroscpp-dev        # roscpp: noctule-ros-bridge
    libsensor-msgs-dev   # sensor_msgs
    libtrajectory-msgs-dev # trajectory_msgs
    python3-rosmaster python3-rostopic python3-sensor-msgs # a master, and programs of ROS that hear us
)
examples_need=(
    r-base-core r-cran-rsqlite r-cran-jsonlite # resources/docs/examples/read_take.R
    octave               # resources/docs/examples/read_positions.m
    zsh                  # reads its completion
)

fail() {
    echo "dependencies: $1" >&2
    exit 1
}

case "${1:-all}" in
    jobs) packages=("${jobs_need[@]}") ;;
    package) packages=("${jobs_need[@]}" "${package_needs[@]}") ;;
    all) packages=("${jobs_need[@]}" "${package_needs[@]}" "${tests_need[@]}") ;;
    examples) packages=("${examples_need[@]}") ;;
    *) fail "usage: packaging/dependencies.sh [jobs|package|all|examples]" ;;
esac

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
