#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The manual pages and the completion, as the build writes them, against the help of the built programs: bash completes
what is asked here, zsh (where it is installed) takes its file. Arguments: noctule-write-help, noctule, and the folder of
noctule-virtual-suit and noctule-virtual-robot."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

WRITE_HELP, NOCTULE = sys.argv[1:3]
SKIPPED = 77  # tests/CMakeLists.txt names it to CTest
wrong = []


def check(what, is_right):
    if not is_right:
        wrong.append(what)


def output(*command):
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ran.returncode:
        sys.exit(f"{' '.join(map(str, command))} ended with {ran.returncode}:\n{ran.stdout}{ran.stderr}")
    return ran.stdout


def completed(file, function, *words):
    """What bash offers for the last word."""
    script = """set -eu
        source "$1"; function=$2; shift 2
        COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
        "$function"
        printf '%s\\n' "${COMPREPLY[@]+"${COMPREPLY[@]}"}" """
    return output("bash", "-c", script, "bash", file, function, *words).split()


def options_of(help_text):
    return set(re.findall(r"^  (--[a-z0-9-]+)", help_text, re.MULTILINE))


def verbs():
    """`calibrate` has further words: each of them is a verb of its own."""
    listed = re.findall(r"^  ([a-z][a-z-]*(?: [a-z-]+)?)  ", output(NOCTULE, "--help"), re.MULTILINE)
    return [verb for verb in listed if verb != "calibrate"]


def manual_section(manual, verb):
    begin = manual.index(f"\n.SS {verb}\n".replace("-", "\\-"))
    return manual[begin:re.search(r"\n\.S[SH] ", manual[begin + 5:]).start() + begin + 5]


def options_in_manual(text):
    return {option.replace("\\-", "-") for option in re.findall(r"^\.B (\\-\\-(?:[a-z0-9]|\\-)+)", text, re.MULTILINE)}


def options_for_zsh(text, name):
    function = re.search(rf"^_noctule_{name}\(\) \{{\n(.*?)^\}}", text, re.MULTILINE | re.DOTALL)
    return set(re.findall(r"^ +'(--[a-z0-9-]+)\[", function[1], re.MULTILINE)) if function else set()


def check_verbs(folder):
    manual, zsh = (folder / "noctule.1").read_text(), (folder / "_noctule").read_text()
    common = options_in_manual(manual[manual.index(".SH OPTIONS AFTER"):manual.index(".SH VERBS")])
    found = verbs()
    check(f"verbs of --help: {found}", len(found) > 10 and "process" in found and "calibrate sources" in found)
    for verb in found:
        wanted = options_of(output(NOCTULE, "--batch", *verb.split(), "--help"))
        check(f"{verb} --help lacks the options of every verb", wanted >= common)
        in_bash = completed(folder / "noctule.bash", "_noctule", "noctule", "--batch", *verb.split(), "-")
        for where, there in (("manual page", options_in_manual(manual_section(manual, verb)) | common),
                             ("file for zsh", options_for_zsh(zsh, verb.replace(" ", "_"))),
                             ("completion of bash", set(in_bash))):
            check(f"{verb}: the {where} lacks {sorted(wanted - there)} and has {sorted(there - wanted)} more",
                  wanted == there)


def check_words(folder):
    def bash(*words):
        return completed(folder / "noctule.bash", "_noctule", "noctule", *words)

    for words, wanted in ((("--batch", "pro"), ["process"]), (("--batch", "calibrate", "sour"), ["sources"]),
                          (("--batch", "process", "--root", ""), ["free", "given"]),
                          (("--batch", "process", "t.noctule", "--run-n"), ["--run-name"]), (("--ver",), ["--version"])):
        check(f"noctule {' '.join(words)}: {bash(*words)} instead of {wanted}", set(bash(*words)) == set(wanted))
    first = {verb.split()[0] for verb in verbs()}
    check("every verb is offered", set(bash("--batch", "")) == first | {"--help"})


def check_virtual(folder):
    """The virtual suit and robot: their pages and both completions have the options of their help."""
    for name, in_zsh in (("suit", "suit"), ("robot", "stand_in_robot")):
        program = pathlib.Path(sys.argv[3]) / f"noctule-virtual-{name}"
        wanted = options_of(output(program, "--help"))
        check(f"{program.name} --help has options", len(wanted) > 3)
        for there in (options_in_manual((folder / f"{program.name}.1").read_text()),
                      options_for_zsh((folder / "_noctule").read_text(), in_zsh),
                      set(completed(folder / "noctule.bash", f"_noctule_virtual_{name}", program.name, "-"))):
            check(f"{program.name}: {sorted(wanted ^ there)} stand in one only", wanted == there)


def main():
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        output(WRITE_HELP, folder)
        check_verbs(folder)
        check_words(folder)
        check_virtual(folder)
        zsh = shutil.which("zsh")
        if zsh:
            output(zsh, "-n", folder / "_noctule")
    if wrong:
        sys.exit("\n".join(wrong))
    print("manual pages and completion say what the help says")
    if not zsh:
        print("help_files.py: Skipped\nzsh reading its completion: zsh is not installed")
        sys.exit(SKIPPED)


if __name__ == "__main__":
    main()
