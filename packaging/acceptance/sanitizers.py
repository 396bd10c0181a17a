# SPDX-License-Identifier: Apache-2.0
"""All unit tests of the core and of the devices under every check of the asan-ubsan preset."""
import os
import re
import subprocess

import studio

ENVIRONMENT = {"ASAN_OPTIONS": "detect_stack_use_after_return=1:check_initialization_order=1",
               "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1"}


def run(*command):
    done = subprocess.run(command, cwd=studio.ROOT, env={**os.environ, **ENVIRONMENT}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: exit code {done.returncode}\n{done.stdout[-4000:]}")
    return done.stdout


def figure(options):
    run("cmake", "--preset", "asan-ubsan")
    targets = re.findall(r"^(test_(?:core|devices)_\w+): phony$", run("ninja", "-C", "build/asan-ubsan", "-t", "targets", "all"),
                         re.MULTILINE)
    run("cmake", "--build", "--preset", "asan-ubsan", "--parallel", str(options.jobs), "--target", *targets)
    summary = run("ctest", "--preset", "asan-ubsan", "--parallel", str(options.jobs), "--no-tests=error",
                  "--tests-regex", "^(core|devices)_")
    return re.search(r"\d+% tests passed.*", summary).group(0) + f" ({len(targets)} programs).\n"
