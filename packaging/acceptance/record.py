# SPDX-License-Identifier: Apache-2.0
"""A take of a live suit through the studio's windows: how many clicks it takes from launch to an exported file, how
late the live body is on the screen, and whether the interface answers meanwhile."""
import re
import subprocess

import live
import screen
import studio

SECONDS = 20
PLAYED_S = 40  # again and again
MOST_CLICKS = 12
CLICKS = re.compile(r"^(\d+) clicks from launch", re.MULTILINE)
LIVE = re.compile(r"^live: (\d+) pictures, sample to screen (\d+) ms in the median, (\d+) ms at the 95th percentile; "
                  r"longest gap (\d+) ms, of it ours (\d+) ms", re.MULTILINE)


def figure(_):
    take, _ = live.worn_take(PLAYED_S)
    with screen.own_screen() as display, screen.own_home(display, NOCTULE_RECORD_S=str(SECONDS),
                                                         NOCTULE_RECORD_TAKE=str(take),
                                                         NOCTULE_ALONE="1") as environment:
        done = subprocess.run([studio.BUILD / "test_ui_main_window", "--gtest_filter=RecordFlow.*"],
                              capture_output=True, text=True, env=environment)
    clicks, pictures = CLICKS.search(done.stdout), LIVE.search(done.stdout)
    if not clicks or not pictures:
        raise RuntimeError(f"RecordFlow: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    text = (f"From launch to an exported take of {SECONDS} s, recorded from a box with 18 boards over TCP: {clicks[1]} clicks, "
            f"at most {MOST_CLICKS}. Sample to screen: from the newest sample that the box has sampled to the picture that "
            "shows it; the limits are 100 ms at the 95th percentile and 50 ms for a gap.\n\n" +
            studio.markdown_table(["pictures", "median, ms", "95th percentile, ms", "longest gap, ms", "of it ours, ms"],
                                  [list(pictures.groups())]))
    if done.returncode != 0:
        raise studio.Missed([f"RecordFlow: exit code {done.returncode}"], text)
    return text
