# SPDX-License-Identifier: Apache-2.0
"""A screen, a home folder and settings of their own for programs with windows."""
import contextlib
import os
import pathlib
import subprocess
import tempfile

SCREEN = "1440x900x24"  # what the main window opens in


@contextlib.contextmanager
def own_screen():
    """Starts Xvfb on a free number and yields its name, ":7"."""
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", SCREEN, "+extension", "GLX",
                               "-nolisten", "tcp"], pass_fds=[write], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start; packaging/dependencies.sh installs it")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


@contextlib.contextmanager
def own_home(display, **more):
    """The environment of a program that has never run on this machine."""
    with tempfile.TemporaryDirectory(prefix="noctule-") as folder:
        runtime = pathlib.Path(folder) / "runtime"
        runtime.mkdir(mode=0o700)
        kept = {key: value for key, value in os.environ.items()
                if not key.startswith(("XDG_", "QT_", "NOCTULE_", "WAYLAND_", "DBUS_"))}
        yield {**kept, "DISPLAY": display, "HOME": folder, "XDG_RUNTIME_DIR": str(runtime), "LC_ALL": "C.UTF-8", **more}
