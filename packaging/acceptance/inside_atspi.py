# SPDX-License-Identifier: Apache-2.0
"""Runs within a D-Bus session and on a screen of its own: starts the studio as a screen reader meets it, goes to
every page by keyboard, and prints one JSON line: what was looked at, what has no name, what could not be reached.

  inside_atspi.py PROGRAM"""
import json
import os
import subprocess
import sys
import time

ROOT = "/org/a11y/atspi/accessible/root"
BUS = ["/usr/libexec/at-spi-bus-launcher", "--launch-immediately"]
# What the window's title begins with, and the keys.
PAGES = [("Connect", ["ctrl+1"]), ("Calibrate", ["ctrl+2"]), ("Record", ["ctrl+3"]), ("Review", ["ctrl+4"]),
         ("Export", ["ctrl+5"]), ("Performer and suit", ["alt+s", "Return"]), ("Start", ["ctrl+0"])]
DIALOGS = [("Preferences", ["ctrl+comma"]), ("Shortcuts", ["F1"])]
SAMPLE = "Try it with the virtual suit"
PRESSED = {"Press", "Toggle", "ShowMenu", "click", "press"}
PATIENCE_S, SAMPLE_PATIENCE_S = 30, 240


def take_news(seconds):
    """The library learns what changes in the tree from messages, which are read here only."""
    from gi.repository import GLib

    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if not GLib.MainContext.default().iteration(False):
            time.sleep(0.02)


def wait_for(look, patience_s=PATIENCE_S):
    end = time.monotonic() + patience_s
    while time.monotonic() < end:
        if found := look():
            return found
        take_news(0.1)
    return None


def fresh(item):
    """Not as the library remembers it."""
    item.clearCache()
    return item


def studio_of(desktop):
    fresh(desktop)
    for i in range(desktop.childCount):
        child = desktop.getChildAtIndex(i)
        if child and fresh(child).name.lower() == "noctule" and child.childCount:
            return child
    return None


def windows_of(application):
    return [window for i in range(fresh(application).childCount) if (window := application.getChildAtIndex(i))]


def title(application):
    """Of the main window, as far as it names the page."""
    name = fresh(application.getChildAtIndex(0)).name
    return "Start" if name == "Noctule" else name.split(" – ")[0]


def focus(window):
    """What a window manager would do, at the start and after a dialog."""
    subprocess.run(["xdotool", "windowfocus", window], check=True)
    take_news(0.3)


def press(keys):
    """As from the keyboard, to the window that has the focus."""
    for key in keys:
        subprocess.run(["xdotool", "key", "--clearmodifiers", key], check=True)
        take_news(0.3)


class Walk:
    def __init__(self, atspi):
        self.atspi = atspi
        self.seen = self.asked = 0
        self.nameless = []

    def wants_name(self, item):
        states = item.getState()
        if not states.contains(self.atspi.STATE_SHOWING) or item.getRole() == self.atspi.ROLE_SCROLL_BAR:
            return False
        if states.contains(self.atspi.STATE_FOCUSABLE):
            return True
        try:
            action = item.queryAction()
        except NotImplementedError:
            return False
        return any(action.getName(i) in PRESSED for i in range(action.nActions))

    def look(self, item, place, path):
        self.seen += 1
        path = [*path, f"{item.getRoleName()} '{item.name}'"]
        if self.wants_name(item):
            self.asked += 1
            if not item.name.strip():
                self.nameless.append(f"{place}: {' > '.join(path[-5:])}")
        for i in range(item.childCount):
            child = item.getChildAtIndex(i)
            if child and fresh(child).getState().contains(self.atspi.STATE_SHOWING):
                self.look(child, place, path)


def find(item, name):
    if item.name == name:
        return item
    for i in range(item.childCount):
        child = item.getChildAtIndex(i)
        if child and (found := find(child, name)):
            return found
    return None


def visit_pages(application, walk, state, rows, unreached):
    for name, keys in PAGES:
        press(keys)
        if not wait_for(lambda: title(application) == name):
            unreached.append(f"{name}, {state}: {' '.join(keys)} leads to {title(application)}")
            continue
        take_news(1)
        seen, asked = walk.seen, walk.asked
        walk.look(application.getChildAtIndex(0), f"{name}, {state}", [])
        rows.append([name, state, walk.seen - seen, walk.asked - asked])


def visit_dialogs(application, window, walk, rows, unreached):
    for name, keys in DIALOGS:
        before = len(windows_of(application))
        press(keys)
        if not wait_for(lambda: len(windows_of(application)) > before):
            unreached.append(f"{name}: {' '.join(keys)} opens nothing")
            continue
        take_news(0.5)
        seen, asked = walk.seen, walk.asked
        walk.look(windows_of(application)[-1], name, [])
        rows.append([name, "dialog", walk.seen - seen, walk.asked - asked])
        press(["Escape"])
        if not wait_for(lambda: len(windows_of(application)) == before):
            unreached.append(f"{name}: Escape does not close it")
        focus(window)


def open_sample(application):
    """The sample take, opened by a screen reader's own press."""
    press(["ctrl+0"])
    button = find(application, SAMPLE)
    if not button:
        return f"nothing is called \"{SAMPLE}\""
    button.queryAction().doAction(0)
    opened = wait_for(lambda: title(application) == "Review", SAMPLE_PATIENCE_S)
    take_news(3)  # report and curves
    return None if opened else f"pressing \"{SAMPLE}\" opens no take"


def look_at(atspi):
    window = subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "Noctule"],
                            capture_output=True, text=True, check=True).stdout.split()[-1]
    focus(window)
    application = wait_for(lambda: studio_of(atspi.Registry.getDesktop(0)))
    if not application:
        raise RuntimeError("the studio does not appear on the accessibility bus")
    walk, rows, unreached = Walk(atspi), [], []
    visit_pages(application, walk, "nothing open", rows, unreached)
    visit_dialogs(application, window, walk, rows, unreached)
    if problem := open_sample(application):
        unreached.append(problem)
    visit_pages(application, walk, "a take open", rows, unreached)
    return {"rows": rows, "nameless": walk.nameless, "unreached": unreached}


def main():
    import dbus

    bus = subprocess.Popen(BUS)
    session = dbus.SessionBus()
    if not wait_for(lambda: session.name_has_owner("org.a11y.Bus")):
        raise RuntimeError("the accessibility bus does not start")
    address = str(dbus.Interface(session.get_object("org.a11y.Bus", "/org/a11y/bus"), "org.a11y.Bus").GetAddress())
    registry = dbus.Interface(dbus.bus.BusConnection(address).get_object("org.a11y.atspi.Registry", ROOT),
                              "org.a11y.atspi.Accessible")
    registry.GetChildren()  # starts it; a program tells of itself once, and somebody must listen then
    time.sleep(1)
    program = subprocess.Popen([sys.argv[1]], env={**os.environ, "AT_SPI_BUS_ADDRESS": address})
    try:
        # The library looks once and remembers; so it is read when there is something to see.
        if not wait_for(registry.GetChildren):
            raise RuntimeError("the studio does not tell the accessibility bus of itself")
        import pyatspi

        print("LOOKED " + json.dumps(look_at(pyatspi)))
    finally:
        for process in (program, bus):  # asked, the bus takes its own children along
            process.terminate()
            process.wait()


if __name__ == "__main__":
    main()
