# SPDX-License-Identifier: Apache-2.0
"""Every benchmark program of the build, as it prints itself."""
import subprocess

import studio


def figure(options):
    text = ""
    for program in sorted(studio.BUILD.glob("bench_*")):
        done = subprocess.run([program], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=studio.ROOT)
        if done.returncode != 0:
            raise RuntimeError(f"{program.name}: exit code {done.returncode}")
        text += f"### {program.name}\n\n```\n{done.stdout.strip()}\n```\n\n"
    if not text:
        raise RuntimeError(f"no bench_* program in {studio.BUILD}")
    return text
