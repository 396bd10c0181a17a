# SPDX-License-Identifier: Apache-2.0
"""The running studio as a screen reader sees it, from outside, over AT-SPI: has everything that takes the focus or can
be pressed a name, and does the keyboard lead to every page?"""
import json
import pathlib
import shutil
import subprocess

import screen
import studio

INSIDE = pathlib.Path(__file__).with_name("inside_atspi.py")
PYTHON = "/usr/bin/python3"  # the one that Debian's pyatspi belongs to
# The figure's own dependencies: what needs them, and the package.
NEEDED = {"/usr/libexec/at-spi-bus-launcher": "at-spi2-core", "dbus-run-session": "dbus-daemon", "xdotool": "xdotool"}


def check_dependencies():
    missing = [package for program, package in NEEDED.items() if not shutil.which(program)]
    if subprocess.run([PYTHON, "-c", "import pyatspi"], capture_output=True).returncode != 0:
        missing.append("python3-pyatspi")
    if missing:
        packages = " ".join(missing)
        raise RuntimeError(f"{packages} missing: apt-get install --no-install-recommends {packages}")


def looked():
    with screen.own_screen() as display, screen.own_home(display, QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1") as environment:
        said = pathlib.Path(environment["HOME"]) / "said"  # no pipe: a bus that lives on would keep it open
        with said.open("w") as file:
            subprocess.run(["dbus-run-session", "--", PYTHON, "-B", INSIDE, studio.BUILD / "noctule"], stdout=file,
                           stderr=file, env=environment)
        text = said.read_text()
    lines = [line for line in text.splitlines() if line.startswith("LOOKED ")]
    if len(lines) != 1:
        raise RuntimeError(f"the studio could not be looked at:\n{text[-2000:]}")
    return json.loads(lines[0].removeprefix("LOOKED "))


def figure(_):
    check_dependencies()
    found = looked()
    text = studio.markdown_table(["page", "state", "things seen", "of them to focus or press"], found["rows"])
    problems = [f"no name: {what}" for what in found["nameless"]] + found["unreached"]
    if problems:
        text += "\n" + "".join(f"- {problem}\n" for problem in problems)
        raise studio.Missed([f"{len(found['nameless'])} without a name, {len(found['unreached'])} not reached"], text)
    return text + "\nEverything that takes the focus or can be pressed has a name, and the keyboard leads everywhere.\n"
