# SPDX-License-Identifier: Apache-2.0
"""What the studio asks of the one who waits for it: how long until it is there."""
import re
import statistics
import subprocess
import time

import screen
import studio

STARTS = 7
LONGEST_START_MS = 1500
FIRST_FRAME = re.compile(rb"first frame (\d+) ms after the start of the process")
PATIENCE_S = 60


def first_frame_ms(display):
    """Of one start in a home folder without settings; by the program's own word (noctule.startup)."""
    with screen.own_home(display, QT_LOGGING_RULES="noctule.startup=true") as environment:
        program = subprocess.Popen([studio.BUILD / "noctule"], stderr=subprocess.PIPE, env=environment,
                                   stdout=subprocess.DEVNULL)
        try:
            begin = time.monotonic()
            for line in program.stderr:
                if found := FIRST_FRAME.search(line):
                    return int(found[1])
                if time.monotonic() - begin > PATIENCE_S:
                    break
            raise RuntimeError("the studio did not tell when its first frame was there")
        finally:
            program.kill()
            program.wait()
            program.stderr.close()


def startup(missed):
    with screen.own_screen() as display:
        times = [first_frame_ms(display) for _ in range(STARTS)]
    middle, worst = statistics.median(times), max(times)
    if middle > LONGEST_START_MS:
        missed.append(f"the first frame takes {middle:.0f} ms in the middle of {STARTS} starts")
    return ("### Start\n\nFrom the start of the process to the first painted frame with a running event loop, under Xvfb, "
            f"each time with a new home folder; at most {LONGEST_START_MS} ms in the middle of {STARTS} starts.\n\n" +
            studio.markdown_table(["starts", "median, ms", "worst, ms", "all, ms"],
                                  [[STARTS, f"{middle:.0f}", worst, ", ".join(map(str, times))]]))


def figure(_):
    missed = []
    parts = [startup(missed)]
    text = "\n".join(parts)
    if missed:
        raise studio.Missed(missed, text)
    return text
