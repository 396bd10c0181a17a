#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes one file that runs on other Linux systems without installing: out/packages/noctule-VERSION-ARCHITECTURE.run. It
# holds the Debian package's programs with their libraries, Qt's plugins and Qt's words in German. The first start unpacks
# it into the user's cache. Not inside: the C and C++ libraries and the drivers of the graphics card, which belong to the
# system; glibc must not be older than the one of the system that it was made on. (An AppImage proper needs a start
# program that Debian does not have.)
#   packaging/single_file.sh [PACKAGE.deb]    made by packaging/package.sh when it is not given
set -euo pipefail
cd "$(dirname "$0")/.."

package=${1:-}
[ -n "$package" ] || package=$(packaging/package.sh | tail -n 1)
version=$(dpkg-deb --field "$package" Version)
name=noctule-$version-$(uname -m).run
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
dpkg-deb --extract "$package" "$folder"
usr=$folder/usr

plugins=$(qtpaths --plugin-dir 2>/dev/null || qmake -query QT_INSTALL_PLUGINS)
mkdir -p "$usr/lib/plugins"
for kind in platforms imageformats iconengines xcbglintegrations platforminputcontexts platformthemes texttospeech; do
    [ ! -d "$plugins/$kind" ] || cp -r "$plugins/$kind" "$usr/lib/plugins/"
done
translations=$(qmake -query QT_INSTALL_TRANSLATIONS)
mkdir "$usr/lib/translations"
cp "$translations"/qt{base,serialport,websockets}_de.qm "$usr/lib/translations/"
printf '[Paths]\nPrefix=..\nPlugins=lib/plugins\nTranslations=lib/translations\n' | tee "$usr/bin/qt.conf" >"$usr/libexec/noctule/qt.conf"

of_the_system='/(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|stdc\+\+|gcc_s|drm|gbm|GLX_.*|EGL_.*))\.so'
find "$usr" -type f \( -perm -u+x -o -name '*.so*' \) -exec ldd {} + 2>/dev/null |
    awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | sort -u | grep -vE "$of_the_system" |
    xargs -I{} cp -Ln {} "$usr/lib/"

cat >"$folder/start" <<'START'
#!/bin/sh
here=$(dirname "$(readlink -f "$0")")/usr
export LD_LIBRARY_PATH="$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
exec "$here/bin/noctule" "$@"
START
chmod +x "$folder/start"

mkdir -p out/packages
rm -f out/packages/noctule-*.run
cat >"out/packages/$name" <<HEADER
#!/bin/sh
# Noctule $version. Unpacks itself once into the user's cache and starts: ./$name [--batch VERB ...]
version=$version
HEADER
cat >>"out/packages/$name" <<'HEADER'
folder=${XDG_CACHE_HOME:-$HOME/.cache}/noctule/$version
if [ ! -x "$folder/start" ]; then
    aside=$folder.$$
    mkdir -p "$aside" && tail -n +15 "$0" | tar -xz -C "$aside" || {
        rm -rf "$aside"
        echo "noctule: cannot unpack into $folder. Free some space there, or set XDG_CACHE_HOME to another folder." >&2
        exit 6
    }
    mv -T "$aside" "$folder" 2>/dev/null || rm -rf "$aside"
fi
exec "$folder/start" "$@"
HEADER
[ "$(wc -l <"out/packages/$name")" -eq 14 ] || { echo "single_file: the header has another length" >&2; exit 1; }
tar -cz --owner=0 --group=0 -C "$folder" start usr >>"out/packages/$name"
chmod +x "out/packages/$name"
ls "out/packages/$name"
