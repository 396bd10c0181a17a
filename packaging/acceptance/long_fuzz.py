# SPDX-License-Identifier: Apache-2.0
"""Damaged motions and takes for the built program: it may refuse them, with a documented exit code and a message,
but never crash, hang, call it an internal error, leave half a file or change what it refused."""
import collections
import concurrent.futures
import pathlib
import random
import shutil
import subprocess
import tempfile

import studio

DOCUMENTED = {0, 3, 4}
SECONDS_AT_MOST = 60


def short_motion():
    """The first 40 frames of a real motion."""
    lines = (studio.REAL_MOTIONS / "01_01.bvh").read_bytes().splitlines(keepends=True)
    first = next(i for i, line in enumerate(lines) if line.startswith(b"Frame Time")) + 1
    header = [b"Frames: 40\n" if line.startswith(b"Frames") else line for line in lines[:first]]
    return b"".join(header + lines[first:first + 40])


def damaged(data, rng):
    data = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 8, 64))):
        at = rng.randrange(len(data))
        length = min(len(data) - at, rng.choice((1, 2, 16, 512)))
        kind = rng.randrange(5)
        if kind == 0:
            data[at] ^= 1 << rng.randrange(8)
        elif kind == 1:
            data[at:at + length] = rng.randbytes(length)
        elif kind == 2:
            del data[at:at + length]
        elif kind == 3:
            data[at:at] = data[at:at + length]
        else:
            data[at:at] = rng.choice((b" nan ", b" inf ", b" -1 ", b" 1e999 ", b"}", b"{", b"\x00", b"99999999999"))
        if not data:
            return b""
    return bytes(data[:rng.randrange(len(data) + 1)] if rng.random() < 0.1 else data)


def complaint(arguments, victim, output):
    """What is wrong with how the program took this input, or None."""
    before = victim.read_bytes()
    command = [str(studio.BUILD / "noctule"), "--batch", *map(str, arguments)]
    try:
        done = subprocess.run(command, capture_output=True, timeout=SECONDS_AT_MOST)
    except subprocess.TimeoutExpired:
        return f"no end after {SECONDS_AT_MOST} s"
    if done.returncode not in DOCUMENTED:
        return f"exit code {done.returncode}: {done.stderr.decode(errors='replace').strip()[-300:]}"
    if done.returncode != 0 and not done.stderr.strip():
        return f"exit code {done.returncode} without a message"
    if done.returncode != 0 and victim.read_bytes() != before:
        return f"exit code {done.returncode}, but the file is changed"
    left = {path.name for path in victim.parent.iterdir()} - {victim.name}
    allowed = {output.name} if done.returncode == 0 and output else set()
    return f"left {sorted(left - allowed)}" if left - allowed else None


def one_input(seed, motion, take):
    """(seed, complaint or None); a bad input is kept."""
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if seed % 2:
            victim, output = folder / "input.bvh", folder / "output.noctule"
            victim.write_bytes(damaged(motion, rng))
            arguments = ["simulate", "--motion", victim, "--out", output, "--level", "readings", "--duration", 0.2,
                         "--rest-seconds", 0.1, "--quiet"]
        else:
            victim, output = folder / "input.noctule", None
            victim.write_bytes(damaged(take, rng))
            arguments = [("inspect", victim, "--json"), ("process", victim, "--sensors", "AGD", "--root", "given"),
                         ("evaluate", victim, "--json")][rng.randrange(3)]
        found = complaint(arguments, victim, output)
        if found:
            kept = studio.OUT / "long-fuzz" / f"{seed}{victim.suffix}"
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(victim, kept)
            found = f"{' '.join(map(str, arguments[:1]))} {kept.relative_to(studio.ROOT)}: {found}"
        return found


def figure(options):
    motion = short_motion()
    take = (studio.ROOT / "tests" / "data" / "takes" / "tiny_take.noctule").read_bytes()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        seeds = range(options.fuzz_seed, options.fuzz_seed + options.fuzz_inputs)
        found = [text for text in pool.map(lambda seed: one_input(seed, motion, take), seeds) if text]
    verbs = collections.Counter(text.split()[0] for text in found)
    text = (f"{options.fuzz_inputs} damaged motions and takes from seed {options.fuzz_seed}: {len(found)} complaints"
            f"{' ' + str(dict(verbs)) if verbs else ''}.\n\n")
    return text + "".join(f"- {line}\n" for line in found[:50]) + ("\n" if found else "")
