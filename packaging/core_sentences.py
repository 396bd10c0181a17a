#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Brings the sentences of core and devices into resources/translations/core_de.ts, and takes out those that are gone.
Of the studio's own sources those of its errors and of a job's progress, where they are not translated by tr().

Core speaks English and knows no language of a screen. A sentence there is a chain of texts and values,
`path + ": is no take"`; here it becomes a pattern, "%1: is no take". The studio finds the pattern that a sentence came
from and shows its translation (ui/language/core_words.h).

  packaging/core_sentences.py            bring the file up to date
  packaging/core_sentences.py --check    say what is missing, and fail
"""
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml
from xml.sax.saxutils import escape

ROOT = pathlib.Path(__file__).resolve().parent.parent
FILE = ROOT / "resources" / "translations" / "core_de.ts"
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<d>[^(]*)\(.*?\)(?P=d)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\])+\''
                   r"|[A-Za-z_]\w*|\d[\w.']*|::|->|<<|>>|&&|\|\||[-+*/<>=!]=|\s+|.", re.S)
CLOSING = {"(": ")", "{": "}", "[": "]"}
ENDS_CHAIN = set(", ; = return ? : << && || == != < > <= >= += case".split())
# What is never shown: broken promises of our own, what a table or a statement of a file says.
SKIPPED_CALLS = {"require", "static_assert", "NOCTULE_REQUIRE", "tr", "translate"}
NO_SENTENCE = re.compile(r"[<>{}$]|SELECT|CAST\(|ORDER BY|INSERT|CREATE|DELETE|PRAGMA|ATTACH|DROP|UPDATE|http|^\s*--|^#|\w+,\w+,|_[a-z]|::|\\")
SKIPPED_FILES = re.compile(r"parameters?\.(cpp|h)$|_json\.cpp$|_csv\.cpp$")  # parameters are told by --batch alone
# Rooms whose single words stand on the screen: heads of tables and labels of plots.
ROOMS_OF_WORDS = {"core/report"}

# The calls in which the studio's sources speak as core does; all else there is translated by tr().
STUDIO_SPEAKS = {"Error", "progress"}
# The calls that name a stage of a job, with a single word too: "Writing", "Drawing %1".
TELL_OF_WORK = {"progress", "RowProgress"}

# What the sources put together of parts: grades, and joints and segments with their sides (core/body/text.cpp).
GRADES = ("Good", "Usable", "Not usable")
MIDDLE = ("Pelvis", "Lower back", "Abdomen", "Upper back", "Chest", "Base of the neck", "Neck", "Head")
SIDED = ("clavicle", "shoulder", "upper arm", "elbow", "forearm", "wrist", "hand", "hip", "thigh", "knee", "shin", "ankle",
         "foot", "toes", "arm", "leg")
FATES = ("used", "rejected by the gate", "heard but unused", "hidden by the body", "missing")
# What is said of a motion's figure and of its zero pose (core/figure).
OF_A_FIGURE = ("unit %1", "1 unit = %1 m", "%1 joints by name", "%1 by the bone map", "%1 by the bone map by name",
               "%1 of them by shape", "T pose", "A pose", "arms down", "sitting", "bent trunk", "not a standing pose")
# How a system says why a file or an address cannot be had (strerror).
OF_THE_SYSTEM = ("Permission denied", "Operation not permitted", "No such file or directory", "Not a directory",
                 "Is a directory", "File exists", "File name too long", "Directory not empty", "No space left on device",
                 "Disk quota exceeded", "Read-only file system", "Input/output error", "Device or resource busy",
                 "Too many open files", "No such device", "Invalid argument", "Connection refused",
                 "Connection reset by peer", "Connection timed out", "Network is unreachable", "No route to host",
                 "Address already in use", "Cannot assign requested address", "Broken pipe")
COMPOSED = (*OF_THE_SYSTEM, *GRADES, *MIDDLE, *(f"{side} {part}" for side in ("Left", "Right") for part in SIDED),
            *(f"{fate} %1" for fate in FATES), "root given", "source %1", "board %1", *OF_A_FIGURE)
# text::plural(count, "frame", "frames") says "%1 frames".
PLURAL = re.compile(r'\bplural\([^;]*?,\s*"([a-z][^"]*)",\s*"([a-z][^"]*)"\)')


def unescaped(token):
    body = token[1:-1] if not token.startswith("R") else token[token.index("(") + 1:token.rindex(")")]
    body = re.sub(r"\\u([0-9a-fA-F]{4})", lambda m: chr(int(m[1], 16)), body)
    return re.sub(r"\\([nt\"'])", lambda m: {"n": "\n", "t": "\t"}.get(m[1], m[1]), body)


class Chains:
    """Every chain of texts and values joined by + in one source, or in its calls of the names `within`."""

    def __init__(self, source, within=None):
        source = re.sub(r"^\s*#.*$", "", source, flags=re.M)
        self.tokens = [m.group() for m in TOKEN.finditer(source)
                       if not m.group().isspace() and not m.group().startswith(("//", "/*"))]
        self.found = []
        if within is None:
            self.walk(0, len(self.tokens))
            return
        for at, (name, opens) in enumerate(zip(self.tokens, self.tokens[1:])):
            if name in within and opens in CLOSING:
                self.walk(at + 2, self.end_of(at + 1, len(self.tokens)) - 1)

    def end_of(self, at, end):
        depth, at = 1, at + 1
        while at < end and depth:
            depth += (self.tokens[at] in CLOSING) - (self.tokens[at] in CLOSING.values())
            at += 1
        return at

    def walk(self, at, end):
        term, parts, alternative = [], [], False

        def end_term():
            nonlocal term
            texts = [t for t in term if t.startswith(('"', 'R"'))]
            if term and len(texts) == len(term):
                parts.append("".join(map(unescaped, term)))
            elif len(texts) == 1 and term[:3] == ["std", "::", "string"] and len(term) == 6:
                parts.append(unescaped(texts[0]))
            elif term:
                parts.append(None)
            term = []

        def end_chain():
            nonlocal parts
            end_term()
            if any(parts):
                self.found.append((parts, alternative))
            parts = []

        while at < end:
            token = self.tokens[at]
            if token in CLOSING:
                after = self.end_of(at, end)
                if not (term and term[-1] in SKIPPED_CALLS):
                    self.walk(at + 1, after - 1)
                if token == "{" and not (term and term[-1] == "string"):
                    end_chain()
                else:
                    term += self.tokens[at:after]
                at = after
                continue
            if token in ENDS_CHAIN:
                end_chain()
                alternative = token in "?:"
            elif token == "+":
                end_term()
            else:
                term.append(token)
            at += 1
        end_chain()


def pattern(parts):
    count, text = 0, ""
    for part in parts:
        if part is None:
            count += 1
        text += f"%{count}" if part is None else part
    return text


def texts_of(text):
    """The text itself, or of a piece of a page what stands between its tags."""
    if "<" not in text or ">" not in text:
        return [text.strip()]
    found = []
    for piece in re.findall(r'(?<=>)[^<>]+(?=<|$)|(?<=aria-label=\\")[^"]+(?=\\")', text):
        values = iter(range(1, 100))
        found.append(re.sub(r"%\d+", lambda _: f"%{next(values)}", piece).strip())
    return found


def is_sentence(text, alternative, room):
    plain = re.sub(r"%\d+", "", text)
    if NO_SENTENCE.search(plain) or not text.replace("\u00a0", " ").isprintable() or re.search(r"[^\x00-\u2fff]", plain):
        return False
    words = re.findall(r"[A-Za-z]{2,}", plain)
    if (alternative and plain.strip()[:1].islower()) or (room in ROOMS_OF_WORDS and plain[:1].isupper()):
        return bool(words) and len(plain) > 2
    if room in ROOMS_OF_WORDS and " " in text and len("".join(words)) > 3 and not re.search("[=;]", plain) and re.search(r"%\d", text):
        return True
    if room in ROOMS_OF_WORDS and re.fullmatch("[a-z]{3,}, (mm|m|s|ms|µs|°)", text):  # head of a column: "height, m"
        return True
    return len(words) >= 2 and " " in plain.strip() and any(word.islower() for word in words)


def sentences():
    """Room of each pattern, in the order of the sources."""
    listed = subprocess.run(["git", "ls-files", *(f"{room}/*.{kind}" for room in ("core", "devices", "ui", "app/studio")
                                                  for kind in ("cpp", "h"))],
                            cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    found = {}
    for name in listed:
        if SKIPPED_FILES.search(name):
            continue
        room = str(pathlib.Path(name).parent)
        source = (ROOT / name).read_text()
        is_studio = not name.startswith(("core/", "devices/"))
        for counted in PLURAL.findall(source):
            for word in counted:
                found.setdefault(f"%1 {word}", "core/body")
        for parts, _ in Chains(source, TELL_OF_WORK).found:
            for text in texts_of(pattern(parts)):
                if re.fullmatch("[A-Za-z]+( %1)?", text):
                    found.setdefault(text, room)
        for parts, alternative in Chains(source, STUDIO_SPEAKS if is_studio else None).found:
            for text in texts_of(pattern(parts)):
                if is_sentence(text, alternative, room):
                    found.setdefault(text, room)
    for text in COMPOSED:
        found.setdefault(text, "core/body")
    return found


def translations():
    if not FILE.exists():
        return {}
    return {message.findtext("source"): message.findtext("translation") or ""
            for message in xml.parse(FILE).getroot().iter("message")}


def written(found, known):
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", '<TS version="2.1" language="de_DE">']
    for room in sorted(set(found.values())):
        lines += ["<context>", f"    <name>{room}</name>"]
        for text in sorted(text for text, of in found.items() if of == room):
            german = known.get(text, "")
            state = "" if german else ' type="unfinished"'
            lines += ["    <message>", f"        <source>{escape(text)}</source>",
                      f"        <translation{state}>{escape(german)}</translation>", "    </message>"]
        lines.append("</context>")
    return "\n".join(lines) + "\n</TS>\n"


def main():
    found, known = sentences(), translations()
    if sys.argv[1:] == ["--check"]:
        lacking = [text for text in found if not known.get(text)]
        gone = [text for text in known if text not in found]
        for text in lacking:
            print(f"no German for: {text}")
        for text in gone:
            print(f"no longer said: {text}")
        sys.exit("Run packaging/translations.sh, then translate." if lacking or gone else 0)
    FILE.write_text(written(found, known))
    print(f"{FILE.relative_to(ROOT)}: {len(found)} sentences, {sum(not known.get(text) for text in found)} to translate")


if __name__ == "__main__":
    main()
