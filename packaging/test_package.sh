#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the package as a user gets it. It is unpacked to another place and run from there; then, as root and with
# debootstrap, it is installed into a bare Debian, tried there and removed without a trace.
#   packaging/test_package.sh [PACKAGE.deb]    made by packaging/package.sh when it is not given
set -euo pipefail
cd "$(dirname "$0")/.."

package=${1:-}
[ -n "$package" ] || package=$(packaging/package.sh | tail -n 1)
package=$(realpath "$package")
motion=$PWD/resources/motions/sample.bvh
folder=$(mktemp -d)
mounted=()
clean() {
    for place in "${mounted[@]}"; do umount "$place"; done
    rm -rf "$folder"
}
trap clean EXIT

fail() {
    echo "test_package: $1" >&2
    exit 1
}

films=yes # pictures need the graphics drivers of the system

# run PROGRAM...: the batch demo with the program `noctule` that the words before --batch start
demo() {
    local work=$1 film=()
    [ $films = no ] || film=(--video "$work/walk.avi")
    shift
    "$@" noctule --batch simulate --quiet --motion "$work/sample.bvh" --out "$work/walk_001.noctule" --duration 2
    "$@" noctule --batch process --quiet "$work/walk_001.noctule" --root given
    "$@" noctule --batch evaluate --quiet "$work/walk_001.noctule" --report "$work/report.html"
    "$@" noctule --batch export --quiet "$work/walk_001.noctule" --bvh "$work/walk.bvh" "${film[@]}"
}

check_results() {
    for name in walk_001.noctule report.html walk.bvh $([ $films = no ] || echo walk.avi); do
        [ -s "$1/$name" ] || fail "the demo left no $name"
    done
}

echo "== moved to another place"
mkdir -p "$folder/moved" "$folder/takes"
dpkg-deb --extract "$package" "$folder/moved"
for file in "$folder"/moved/usr/bin/* "$folder"/moved/usr/libexec/noctule/*; do
    ! ldd "$file" | grep -F "not found" || fail "$file lacks libraries"
done
cp "$motion" "$folder/takes/"
demo "$folder/takes" env PATH="$folder/moved/usr/bin:$PATH"
check_results "$folder/takes"
PATH=$folder/moved/usr/bin:$PATH noctule --version | grep -q "^noctule [0-9]" || fail "no version"
desktop=$folder/moved/usr/share/applications/noctule.desktop
if command -v desktop-file-validate >/dev/null; then desktop-file-validate "$desktop"; fi
if command -v appstreamcli >/dev/null; then
    appstreamcli validate --no-net "$folder"/moved/usr/share/metainfo/*.xml >/dev/null || fail "AppStream complains"
fi

if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null || ! command -v Xvfb >/dev/null; then
    echo "== a bare Debian: skipped, it needs root, debootstrap and Xvfb"
    exit 0
fi

echo "== a bare Debian"
root=$folder/root
mirror=$(sed -n 's/^URIs: *//p; s/^deb \(\[[^]]*\] \)\?\([^ ]*\) .*/\2/p' /etc/apt/sources.list \
    /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list 2>/dev/null | head -n 1 || true)
debootstrap --variant=minbase --include=man-db,desktop-file-utils,shared-mime-info,ca-certificates bookworm "$root" \
    "${mirror%% *}" >"$folder/debootstrap.log" || { tail "$folder/debootstrap.log" >&2; fail "debootstrap failed"; }
cp -a /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
for place in dev proc; do
    mount --rbind "/$place" "$root/$place"
    mount --make-rslave "$root/$place"
    mounted=("$root/$place" "${mounted[@]}")
done
umount_all() { for place in "${mounted[@]}"; do umount -R "$place"; done; mounted=(); rm -rf "$folder"; }
trap umount_all EXIT
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
names() { (cd "$root" && find etc usr opt var/lib/dpkg/info -name '*noctule*' | sort); }
inside apt-get -qq update
cp "$package" "$root/tmp/noctule.deb"
inside useradd --create-home user
as_user() { inside setpriv --reuid user --regid user --clear-groups env HOME="$(inside sh -c 'echo ~user')" "$@"; }
echo "-- the single file, where nothing is installed"
mkdir -m 777 "$root/tmp/single"
cp "$motion" "$root/tmp/single/"
cp "$(packaging/single_file.sh "$package")" "$root/usr/local/bin/noctule"
films=no
demo /tmp/single as_user
check_results "$root/tmp/single"
films=yes
rm "$root/usr/local/bin/noctule"
inside apt-get -qq install -y --no-install-recommends /tmp/noctule.deb >"$folder/install.log" 2>&1 ||
    { tail "$folder/install.log" >&2; fail "the package cannot be installed"; }
[ -e "$root/usr/share/qt5/translations/qtbase_de.qm" ] || fail "Qt's own dialogs would be English on a German screen"
mkdir -m 777 "$root/tmp/takes"
cp "$motion" "$root/tmp/takes/"
echo "-- the batch demo"
demo /tmp/takes as_user
check_results "$root/tmp/takes"
echo "-- manual pages"
inside man noctule | grep -q "noctule --batch simulate" || fail "man noctule shows nothing"
inside man noctule-virtual-suit | grep -q -- "--announce" || fail "man noctule-virtual-suit shows nothing"
inside man noctule-virtual-robot | grep -q -- "--refuse-beyond" || fail "man noctule-virtual-robot shows nothing"
echo "-- a take is known by its name and by what it holds"
grep -q "application/x-noctule-take=noctule.desktop" "$root/usr/share/applications/mimeinfo.cache" ||
    fail "a double click on a take opens nothing"
grep -q "x-noctule-take:\*.noctule" "$root/usr/share/mime/globs2" || fail "the MIME type has no ending"
echo "-- the studio with a take"
mkdir -p "$root/tmp/.X11-unix" "$root/tmp/run"
chmod 777 "$root/tmp/run"
Xvfb -displayfd 9 -screen 0 1440x900x24 +extension GLX -nolisten tcp 9>"$folder/display" >/dev/null 2>&1 &
server=$!
for _ in $(seq 600); do [ -s "$folder/display" ] && break; sleep 0.1; done
display=:$(cat "$folder/display")
mount --bind /tmp/.X11-unix "$root/tmp/.X11-unix"
mounted=("$root/tmp/.X11-unix" "${mounted[@]}")
as_user env DISPLAY="$display" XDG_RUNTIME_DIR=/tmp/run QT_LOGGING_RULES="noctule.startup=true" \
    noctule /tmp/takes/walk_001.noctule 2>"$folder/studio.log" &
studio=$!
for _ in $(seq 600); do grep -qs "first frame" "$folder/studio.log" && break; sleep 0.1; done
grep -s "first frame" "$folder/studio.log" || { cat "$folder/studio.log" >&2; fail "the studio showed no frame"; }
if command -v xwininfo >/dev/null; then
    DISPLAY=$display xwininfo -root -tree | grep -i noctule | head -n 3 || fail "the studio has no window"
fi
if command -v import >/dev/null; then
    sleep 15  # opening the take
    mkdir -p out/packages
    DISPLAY=$display import -window root out/packages/installed_studio.png
fi
kill "$studio" 2>/dev/null || true
wait "$studio" 2>/dev/null || true
kill "$server"
wait "$server" 2>/dev/null || true
echo "-- removed without a trace"
inside dpkg --purge noctule >/dev/null
left=$(names)
[ -z "$left" ] || fail "these were left: $left"
[ ! -e "$root/usr/libexec/noctule" ] && [ ! -e "$root/usr/share/noctule" ] || fail "folders were left"
echo "test_package: all of it works"
