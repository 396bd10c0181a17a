#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves that the sources keep to the layout of the house: arrows point down (app -> ui -> devices -> core, among
core's rooms as core/CMakeLists.txt links them, among a room's parts as they are listed), core knows no Qt, threads,
clocks or environment, a library stays in its room, every file carries its licence, no two headers define one type
name in one namespace, every test that tests/usability.md names is there.

  architecture.py               checks this tree; exit code 1 and one line per complaint
  architecture.py --self-test   breaks every rule once, in memory, and sees that it is noticed
"""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

TOP_LEVEL = {"CMakeLists.txt", "app", "core", "devices", "ui", "resources", "tests", "packaging", "README.md",
             "CMakePresets.json", "LICENSE", "CHANGELOG.md"}
LAYERS = {"app": {"app", "ui", "devices", "core"}, "ui": {"ui", "devices", "core"}, "devices": {"devices", "core"},
          "core": {"core"}}
ONLY_IN = {"assimp": {"core/formats", "core/mesh"}, "opencv2": {"core/film", "core/media", "core/vision"}}
PURE = ("core", "devices/driver_box")  # values in, values out: no Qt, no threads, no clocks
APART = "simulation"  # what the estimator is judged by: no other room of core may know it

ESTIMATORS_KINEMATICS = "core/body/kinematics.h"  # the simulation has its own, so that errors cannot cancel

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)
QT_HEADER = re.compile(r"Qt?[A-Z]\w*(/.*)?|q[a-z]\w*\.h")
QT_SCREEN = re.compile(r"Qt(Gui|Widgets|Svg|OpenGL)(/.*)?|Q(Widget|Application|GuiApplication|MainWindow|Dialog"
                       r"|Painter|Image|Pixmap|Color|Font|Icon|Window|OpenGL\w*)")
NOT_IN_CORE = re.compile(r"std::(jthread|thread|async|cout|cerr|random_device|time|clock)\b|\bpthread_\w+"
                         r"|\b(system|steady|high_resolution|utc)_clock\b|\b(gettimeofday|clock_gettime|getenv)\b")
HEADERS_NOT_IN_CORE = {"thread", "future", "pthread.h", "iostream"}
ROOM_LINE = re.compile(r"^noctule_library\((\w+)(?:\s+(?:QT|COLD))*(?:\s+PARTS\s+([\w\s]+?))?"
                       r"(?:\s+LINK\s+([^)]*))?\)", re.MULTILINE)
QT_SCREEN_LIBRARY = re.compile(r"\bQt5::(Gui|Widgets|Svg|OpenGL\w*|PrintSupport)\b")
QT_OF_BASE = {"Core", "Gui", "Widgets", "Network", "Test"}  # come with the package of Qt5 itself
# A number or a key that is written past ui/style/words.h, and so is English on a German screen.
WRITTEN_BY_HAND = re.compile(r"""\bQString::(?:number|asprintf)\([^;]*'[efgEG]'|\.arg\([^;]*, '[efgEG]'|\bstd::format\("""
                             r"""|QKeySequence::NativeText|\btr\((?:"[^"]*"\s*)*"[^"]*\b(?:Ctrl|Shift|Alt)\+""")
WRITES = "ui/style/words.cpp"
FLAGS = re.compile(r"\b(add_compile_options|target_compile_options|CMAKE_CXX_FLAGS)\b")
# Spelled in pieces, so that this file does not complain about itself.
FORBIDDEN_WORDS = re.compile(r"\b(TO" r"DO|FIX" r"ME)\b|(?<![\w.])/(wo" r"rk|ro" r"ot|ho" r"me)/\w")
NAMESPACE = re.compile(r"\bnamespace\s+([\w:]+)?\s*\{")
TYPE = re.compile(r"(?:\btemplate\s*<[^;{]*>\s*)?\b(enum\s+class|enum|struct|class|union)\s+([\w:]+)(?<!:)\s*(?:final\s*)?"
                  r"(?::[^;{]*)?\{")
USABILITY = "tests/usability.md"
TESTS_NAMED = re.compile(r"`([\w/]+\.cpp): ([^`]*)`")  # `ui/style/theme_test.cpp: ThemeTest.ringGoes, ThemeTest.popups`
LICENCE = "SPDX-License-Identifier: Apache-2.0"
SOURCE_SUFFIXES = {".h", ".cpp"}
SCRIPT_SUFFIXES = {".py", ".sh"}


def room_of(path):
    """core/math/rotation.cpp -> core/math; core/CMakeLists.txt -> core."""
    return "/".join(path.split("/")[:2]) if path.count("/") > 1 else path.split("/")[0]


def suffix(path):
    return pathlib.PurePosixPath(path).suffix


def without_comments(text):
    return re.sub(r"//.*|/\*[\s\S]*?\*/", "", text)


def sources(files, folder):
    return {path: text for path, text in files.items() if path.startswith(folder + "/") and suffix(path) in
            SOURCE_SUFFIXES}


def library_of(layer, room):
    """The library's name without noctule_: math, devices_driver_box, ui_views."""
    return room if layer == "core" else f"{layer}_{room}"


def reached_libraries(files, complaints):
    """{library: all libraries whose headers it may include}, from the noctule_library lines."""
    reach = {}
    for layer in ("core", "devices", "ui"):
        lines = f"{layer}/CMakeLists.txt"
        for line in ROOM_LINE.finditer(files.get(lines, "")):
            library = line.group(1)
            links = re.findall(r"\bnoctule_(\w+)", line.group(3) or "")
            for link in links:
                if link not in reach:
                    complaints.append(f"{lines}: {library} links {link}, which does not stand above it")
            reach[library] = {library}.union(*(reach.get(link, {link}) for link in links))
            if library != APART and APART in reach[library]:
                complaints.append(f"{lines}: {library} links {APART}")
    return reach


def check_rooms(files, complaints):
    reach = reached_libraries(files, complaints)
    for layer in ("core", "devices", "ui"):
        for path, text in sources(files, layer).items():
            room = path.split("/")[1]
            library = library_of(layer, room)
            if library not in reach:
                complaints.append(f"{path}: {layer}/CMakeLists.txt has no line for the room {room}")
                continue
            for header in INCLUDE.findall(text):
                target = re.match(r"(core|devices|ui)/(\w+)/", header)
                if room == APART and header == ESTIMATORS_KINEMATICS:
                    complaints.append(f"{path}: {APART} includes the estimator's kinematics")
                if target and library_of(*target.groups()) not in reach[library]:
                    complaints.append(f"{path}: {room} does not link {target.group(2)}, but includes {header}")
                if layer != "core" and header.startswith(f"core/{APART}/"):
                    complaints.append(f"{path}: {layer} knows {APART}")


def check_parts(files, complaints):
    """A room's folders: each may include the room's own files and the parts before it, the room none of them."""
    for layer in ("core", "devices", "ui"):
        for line in ROOM_LINE.finditer(files.get(f"{layer}/CMakeLists.txt", "")):
            room = f"{layer}/{line.group(1).removeprefix(layer + '_')}"
            parts = (line.group(2) or "").split()
            for path, text in sources(files, room).items():
                part = path.removeprefix(room + "/").rpartition("/")[0]
                if part and part not in parts:
                    if path.removeprefix(layer + "/") not in files[f"{layer}/CMakeLists.txt"]:  # a library of its own
                        complaints.append(f"{path}: {room} has no part {part}")
                    continue
                allowed = parts[:parts.index(part) + 1] if part else []
                for header in INCLUDE.findall(text):
                    target = header.removeprefix(room + "/").rpartition("/")[0]
                    if header.startswith(room + "/") and target and target not in allowed:
                        complaints.append(f"{path}: {part or 'the room itself'} includes the part {target}")


def check_purity(files, complaints):
    for place in PURE:
        for path, text in sources(files, place).items():
            for header in INCLUDE.findall(text):
                if QT_HEADER.fullmatch(header):
                    complaints.append(f"{path}: {place} includes the Qt header {header}")
                if header in HEADERS_NOT_IN_CORE:
                    complaints.append(f"{path}: {place} includes <{header}>")
            for use in NOT_IN_CORE.finditer(without_comments(text)):
                complaints.append(f"{path}: {place} uses {use.group(0)}")
    if "Qt5" in files["core/CMakeLists.txt"]:
        complaints.append("core/CMakeLists.txt: core links Qt")
    for line in ROOM_LINE.finditer(files.get("devices/CMakeLists.txt", "")):
        if "devices/" + line.group(1).removeprefix("devices_") in PURE and "Qt5" in (line.group(3) or ""):
            complaints.append(f"devices/CMakeLists.txt: {line.group(1)} links Qt")
    for library in QT_SCREEN_LIBRARY.finditer(files.get("devices/CMakeLists.txt", "")):
        complaints.append(f"devices/CMakeLists.txt: devices link {library.group(0)}, which belongs to the screen")


def check_layers(files, complaints):
    for layer, allowed in LAYERS.items():
        for path, text in sources(files, layer).items():
            for header in INCLUDE.findall(text):
                target = header.split("/")[0]
                if header.startswith(".") or "/../" in header:
                    complaints.append(f"{path}: {header} is not relative to the top of the sources")
                if target in {*LAYERS, "tests"} and target not in allowed:
                    complaints.append(f"{path}: {layer} includes {header}")
                if layer == "devices" and QT_SCREEN.fullmatch(header):
                    complaints.append(f"{path}: devices includes {header}, which belongs to the screen")


def check_libraries(files, complaints):
    for layer in LAYERS:
        for path, text in sources(files, layer).items():
            for header in INCLUDE.findall(text):
                homes = ONLY_IN.get(header.split("/")[0])
                if homes and room_of(path) not in homes:
                    complaints.append(f"{path}: {header} may be included in {' and '.join(sorted(homes))} only")


def check_licences(files, complaints):
    for path, text in files.items():
        first = text.split("\n", 2)
        if suffix(path) in SOURCE_SUFFIXES and first[0] != f"// {LICENCE}":
            complaints.append(f"{path}: the first line is not // {LICENCE}")
        if suffix(path) in SCRIPT_SUFFIXES and f"# {LICENCE}" not in first[:2]:
            complaints.append(f"{path}: the first two lines do not hold # {LICENCE}")


def check_words(files, complaints):
    for path, text in files.items():
        for number, line in enumerate(text.split("\n"), 1):
            word = FORBIDDEN_WORDS.search(line)
            if word:
                complaints.append(f"{path}:{number}: {word.group(0)}")


def check_writing(files, complaints):
    for path, text in sources(files, "ui").items():
        for match in WRITTEN_BY_HAND.finditer(text) if path != WRITES else ():
            number = text.count("\n", 0, match.start()) + 1
            complaints.append(f"{path}:{number}: numbers and keys of a screen are written by ui/style/words.h")


def check_top_level(files, complaints):
    for name in sorted({path.split("/")[0] for path in files}):
        if name not in TOP_LEVEL and not name.startswith("."):
            complaints.append(f"{name}: does not belong at the top level")


def check_build(files, complaints):
    """Flags stand in one place; what the build looks for is what the set-up script installs."""
    for path, text in files.items():
        if path.endswith("CMakeLists.txt") and path != "CMakeLists.txt" and FLAGS.search(text):
            complaints.append(f"{path}: compiler flags stand in the top CMakeLists.txt only")
    wanted = set()
    for path, text in files.items():
        if path.endswith("CMakeLists.txt"):
            wanted.update(re.findall(r"\bfind_package\((\w+)", text))
            for modules in re.findall(r"\bpkg_check_modules\(\w+ ([^)]*)\)", text):
                wanted.update(set(modules.split()) - {"REQUIRED", "IMPORTED_TARGET"})
    installed = set(re.findall(r"^ +\S+ +# (\w+)", files["packaging/dependencies.sh"], re.MULTILINE))
    components = re.findall(r"\bfind_package\(Qt5\b[^)]*\bCOMPONENTS ([^)]*)\)", files["CMakeLists.txt"])
    parts = set(re.findall(r"^ +\S+ +# Qt5: (\w+)", files["packaging/dependencies.sh"], re.MULTILINE))
    for name in sorted(set(" ".join(components).split()) - QT_OF_BASE - parts):
        complaints.append(f"packaging/dependencies.sh: no package for Qt5's {name}, which the build looks for")
    for name in sorted(wanted - installed):
        complaints.append(f"packaging/dependencies.sh: no package for {name}, which the build looks for")


def types_of(text):
    """Types that a header defines outside of functions and other types, with their namespaces: noctule::Pose."""
    text = re.sub(r'"(?:\\.|[^"\\\n])*"', '""', without_comments(text))
    found, scopes, at = [], [], 0
    while at < len(text):
        opens = NAMESPACE.match(text, at) or TYPE.match(text, at)
        if opens and not (at and (text[at - 1].isalnum() or text[at - 1] in "_:")):
            is_type = opens.re is TYPE
            name = opens.group(2 if is_type else 1) or "(anonymous)"
            if is_type and all(scope and scope[0] == "namespace" for scope in scopes):
                found.append("::".join([scope[1] for scope in scopes] + [name]))
            scopes.append(("type" if is_type else "namespace", name))
            at = opens.end()
            continue
        if text[at] == "{":
            scopes.append(None)
        elif text[at] == "}" and scopes:
            scopes.pop()
        at += 1
    return found


def check_type_names(files, complaints):
    """Two layouts under one name are undefined behaviour, and no compiler says so."""
    homes = {}
    for path, text in files.items():
        if suffix(path) == ".h" and path.split("/")[0] in LAYERS:
            for name in types_of(text):
                homes.setdefault(name, set()).add(path)
    for name, paths in sorted(homes.items()):
        if len(paths) > 1:
            complaints.append(f"{name} is defined in {' and in '.join(sorted(paths))}")


def check_usability(files, complaints):
    for path, names in TESTS_NAMED.findall(files.get(USABILITY, "")):
        for name in names.split(", "):
            test = re.escape(name).replace(r"\.", r",\s*")
            if not re.search(rf"^TEST(_F|_P)?\(\s*{test}\s*\)", files.get(f"tests/{path}", ""), re.MULTILINE):
                complaints.append(f"{USABILITY}: tests/{path} has no test {name}")


CHECKS = (check_rooms, check_parts, check_purity, check_layers, check_libraries, check_licences, check_words,
          check_writing, check_top_level, check_build, check_type_names, check_usability)


def complaints_about(files):
    complaints = []
    for check in CHECKS:
        check(files, complaints)
    return complaints


def paths_of_the_tree():
    """What git would hold; without git everything but hidden folders and what is built."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True) if (ROOT / ".git").exists() else None
    if listed and listed.returncode == 0:
        return [path for path in listed.stdout.split("\0") if path and (ROOT / path).is_file()]
    found = []
    for folder, folders, names in os.walk(ROOT):
        top = pathlib.Path(folder) == ROOT
        folders[:] = [name for name in folders if name != "__pycache__" and not (top and name in {".git", "build",
                                                                                                    "out"})]
        found += [(pathlib.Path(folder) / name).relative_to(ROOT).as_posix() for name in names]
    return found


def read_tree():
    """{path: text}; what is no text counts as empty."""
    files = {}
    for path in paths_of_the_tree():
        data = (ROOT / path).read_bytes()
        try:
            files[path] = "" if b"\0" in data else data.decode()
        except UnicodeDecodeError:
            files[path] = ""
    return files


TREE_OF_THE_SELF_TEST = {"CMakeLists.txt", "core/CMakeLists.txt", "devices/CMakeLists.txt", "ui/CMakeLists.txt",
                         "packaging/dependencies.sh"}


def broken_trees(files):
    """(what is broken, the changed files, what a complaint must say)."""
    licence = f"// {LICENCE}\n"
    rooms = files["core/CMakeLists.txt"]
    devices = files["devices/CMakeLists.txt"]
    build = files["CMakeLists.txt"]

    def source(path, line):
        return {path: licence + line + "\n"}

    return [
        ("Qt in core", source("core/math/a.cpp", "#include <QString>"), "Qt header QString"),
        ("Qt module in core", source("core/math/a.h", "#include <QtCore/QObject>"), "Qt header QtCore/QObject"),
        ("old Qt header in core", source("core/math/a.h", "# include <qglobal.h>"), "Qt header qglobal.h"),
        ("Qt linked by core", {"core/CMakeLists.txt": rooms.replace("noctule_job", "noctule_job Qt5::Core", 1)},
         "core links Qt"),
        ("thread in core", source("core/live/a.cpp", "#include <thread>"), "includes <thread>"),
        ("clock in core", source("core/live/a.cpp", "auto t = std::chrono::steady_clock::now();"), "steady_clock"),
        ("environment in core", source("core/live/a.cpp", 'auto t = getenv("TUNE");'), "uses getenv"),
        ("output in core", source("core/live/a.cpp", "void f() { std::cout << 1; }"), "std::cout"),
        ("arrow up in core", source("core/math/a.h", '#include "core/body/skeleton.h"'), "math does not link body"),
        ("sideways", source("core/formats/a.h", '#include "core/suit/suit.h"'), "formats does not link suit"),
        ("truth seen by the estimator", source("core/estimation/a.cpp", '#include "core/simulation/world.h"'),
         "estimation does not link simulation"),
        ("one kinematics for both", source("core/simulation/a.cpp", '#include "core/body/kinematics.h"'),
         "the estimator's kinematics"),
        ("room without a line", source("core/attic/a.cpp", ""), "no line for the room attic"),
        ("link to a later room", {"core/CMakeLists.txt": rooms.replace("LINK noctule_job", "LINK noctule_live", 1)},
         "does not stand above it"),
        ("simulation linked", {"core/CMakeLists.txt": rooms + "noctule_library(x LINK noctule_simulation)\n"},
         "x links simulation"),
        ("core includes ui", source("core/math/a.cpp", '#include "ui/main_window.h"'), "core includes ui/"),
        ("devices include ui", source("devices/replay/a.cpp", '#include "ui/main_window.h"'), "devices includes ui/"),
        ("devices draw", source("devices/replay/a.cpp", "#include <QWidget>"), "belongs to the screen"),
        ("ui includes app", source("ui/views/a.cpp", '#include "app/batch/verb.h"'), "ui includes app/"),
        ("product includes tests", source("app/a.cpp", '#include "tests/support/x.h"'), "app includes tests/"),
        ("relative include", source("core/math/a.cpp", '#include "../body/skeleton.h"'), "not relative to the top"),
        ("assimp in the wrong room", source("core/body/a.cpp", "#include <assimp/scene.h>"), "core/formats and core/"),
        ("OpenCV in ui", source("ui/views/a.cpp", "#include <opencv2/core.hpp>"), "core/film and core/media and core/vision only"),
        ("source without licence", {"core/math/a.cpp": "int a;\n"}, "first line is not"),
        ("script without licence", {"packaging/a.sh": "#!/bin/sh\n"}, "first two lines"),
        ("word", source("ui/views/a.cpp", "// TO" "DO later"), "ui/views/a.cpp:2: TO"),
        ("path of a machine", {"README.md": "see /ho" "me/me/x\n"}, "README.md:1: /ho"),
        ("number with a point", source("ui/views/a.cpp", "auto t = QString::number(x, 'f', 2);"), "written by ui/style/words.h"),
        ("sentence with a point", source("ui/views/a.cpp", "auto t = tr(\"%1 s\").arg(x, 0, 'f', 1);"),
         "written by ui/style/words.h"),
        ("key by hand", source("ui/views/a.cpp", 'auto t = tr("Undo with " "Ctrl+Z");'), "written by ui/style/words.h"),
        ("arrow up in ui", source("ui/style/a.cpp", '#include "ui/views/page.h"'), "style does not link views"),
        ("room of ui without a line", source("ui/attic/a.cpp", ""), "no line for the room attic"),
        ("room of devices without a line", source("devices/attic/a.cpp", ""), "no line for the room attic"),
        ("devices include a room of core they do not link",
         source("devices/driver_box/a.cpp", '#include "core/recording/rows.h"'), "does not link recording"),
        ("simulation in devices", source("devices/driver_box/a.cpp", '#include "core/simulation/world.h"'),
         "devices knows simulation"),
        ("Qt in the pure link", source("devices/driver_box/a.h", "#include <QTcpSocket>"), "Qt header QTcpSocket"),
        ("Qt linked by the pure link",
         {"devices/CMakeLists.txt": devices.replace("noctule_suit", "noctule_suit Qt5::Core", 1)},
         "devices_driver_box links Qt"),
        ("Qt of the screen linked by devices",
         {"devices/CMakeLists.txt": devices.replace("Qt5::Network", "Qt5::Widgets", 1)}, "devices link Qt5::Widgets"),
        ("Qt of the screen in devices", source("devices/device/a.cpp", "#include <QWidget>"), "belongs to the screen"),
        ("device includes what it does not link",
         source("devices/device/a.cpp", '#include "devices/discovery/found_list.h"'), "does not link discovery"),
        ("clock in the pure link", source("devices/driver_box/a.cpp", "auto t = std::chrono::steady_clock::now();"),
         "devices/driver_box uses steady_clock"),
        ("thread in the pure link", source("devices/driver_box/a.cpp", "#include <thread>"), "includes <thread>"),
        ("a page includes a later one", source("ui/views/record/a.cpp", '#include "ui/views/export/export_page.h"'),
         "record includes the part export"),
        ("a room includes its part", source("ui/views/a.cpp", '#include "ui/views/export/export_page.h"'),
         "the room itself includes the part export"),
        ("a part that nobody compiles", source("ui/views/attic/a.cpp", ""), "ui/views has no part attic"),
        ("a part of a part", source("ui/views/record/a/b.cpp", ""), "ui/views has no part record/a"),
        ("simulation on the screen", source("ui/views/a.cpp", '#include "core/simulation/world.h"'),
         "ui knows simulation"),
        ("stray file", {"notes.txt": ""}, "notes.txt: does not belong"),
        ("flags elsewhere", {"app/CMakeLists.txt": "add_compile_options(-O3)\n"}, "compiler flags"),
        ("dependency without package", {"CMakeLists.txt": build + "find_package(Ceres REQUIRED)\n"}, "for Ceres"),
        ("part of Qt without package", {"CMakeLists.txt": build.replace("SerialPort", "Bluetooth", 1)},
         "for Qt5's Bluetooth"),
        ("two types of one name",
         {**source("core/math/a.h", "namespace noctule { struct Twin { int a; }; }"),
          **source("core/suit/b.h", "namespace noctule { template <class T>\nclass Twin : public T { T b; }; }")},
         "noctule::Twin is defined in core/math/a.h and in core/suit/b.h"),
        ("two enumerations of one name",
         {**source("core/math/a.h", "namespace noctule { enum class Twin { kA }; }"),
          **source("ui/style/b.h", "namespace noctule { enum class Twin : int { kB }; }")}, "noctule::Twin is defined"),
        ("test that is none", {**source("tests/ui/a_test.cpp", "TEST(Menus, AreOpened) {}"),
                               "tests/usability.md": "`ui/a_test.cpp: Menus.AreOpened, Menus.Open`"}, "no test Menus.Open"),
        ("module without package", {"CMakeLists.txt": build + "pkg_check_modules(E REQUIRED flite)\n"}, "for flite"),
    ]


def self_test(files):
    unnoticed = 0
    files = {path: text for path, text in files.items() if path in TREE_OF_THE_SELF_TEST}
    before = set(complaints_about(files))
    cases = broken_trees(files)
    for name, changes, expected in cases:
        new = [text for text in complaints_about({**files, **changes}) if text not in before]
        if not any(expected in text for text in new):
            unnoticed += 1
            print(f"self-test: {name} went unnoticed; new complaints: {new}")
    harmless = {"core/math/a.cpp": f'// {LICENCE}\n#include <vector>\n#include "core/job/result.h"\n// std::cout\n'}
    twin = "struct Inner { int a; };"
    harmless |= {"core/math/a.h": f"// {LICENCE}\nnamespace noctule {{ struct Pair; struct A {{ {twin} }}; {twin} }}\n",
                 "core/suit/b.h": f"// {LICENCE}\nnamespace noctule::suits {{ struct Pair; class B {{ {twin} }}; {twin} }}"}
    for text in set(complaints_about({**files, **harmless})) - before:
        unnoticed += 1
        print(f"self-test: a harmless file is complained about: {text}")
    print(f"architecture self-test: {len(cases)} broken trees, {unnoticed} failures")
    return unnoticed


def main():
    files = read_tree()
    if sys.argv[1:] == ["--self-test"]:
        return 1 if self_test(files) else 0
    if sys.argv[1:]:
        print(__doc__, file=sys.stderr)
        return 2
    complaints = complaints_about(files)
    for text in complaints:
        print(text)
    rooms = len(ROOM_LINE.findall(files["core/CMakeLists.txt"]))
    print(f"architecture: {len(files)} files, {rooms} rooms of core, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
