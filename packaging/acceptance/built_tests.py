# SPDX-License-Identifier: Apache-2.0
"""Built tests as figures: a few of their cases, told by the environment to do more than in a test run."""
import os
import re
import subprocess

import studio


def run(program, cases, wanted, inherited=os.environ, **environment):
    """What the cases print about themselves, one line each. `wanted`: what such a line looks like."""
    command = [str(studio.BUILD / program), f"--gtest_filter={cases}"]
    done = subprocess.run(command, env={**inherited, **environment}, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    lines = [line for line in done.stdout.splitlines() if re.search(wanted, line)]
    text = "".join(f"- {line}\n" for line in lines)
    if done.returncode != 0 or not lines:
        raise studio.Missed([f"{program} {cases}: exit code {done.returncode}"],
                            f"{text}\n```\n{done.stdout[-3000:]}\n```\n")
    return text
