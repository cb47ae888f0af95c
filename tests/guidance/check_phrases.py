#!/usr/bin/env python3
"""Fails on a phrase that stands in no golden text: a sentence that nobody has read.

check_phrases.py ROOT: every text of ui/speech/phrasebook*.cpp has to appear in the English files of
tests/guidance/golden or tests/ui/golden.
"""
import re
import sys
from pathlib import Path

CALL = re.compile(r'\btr\(\s*((?:"(?:[^"\\\\]|\\\\.)*"\s*)+)')
PART = re.compile(r'"((?:[^"\\\\]|\\\\.)*)"')


def phrases(root):
    found = set()
    for file in sorted(root.glob("ui/speech/phrasebook*.cpp")):
        for call in CALL.finditer(file.read_text(encoding="utf-8")):
            found.add("".join(PART.findall(call[1])))
    return found


def pattern(phrase):
    """What is said of it: any name or number for a place marker, one or several of what is counted."""
    text = re.escape(phrase)
    text = text.replace(r"foot\(feet\)", "(foot|feet)").replace(r"\(s\)", "s?")
    text = re.sub(r"%n", r"\\d+", text)
    return re.compile(r"(?<!\w)" + re.sub(r"%\d", r".+?", text) + r"(?!\w)", re.IGNORECASE)


def main():
    root = Path(sys.argv[1])
    files = sorted(root.glob("tests/guidance/golden/*.en.txt")) + [root / "tests/ui/golden/cues_en.txt"]
    read = "\n".join(file.read_text(encoding="utf-8") for file in files)
    known = phrases(root)
    unread = [phrase for phrase in sorted(known) if not pattern(phrase).search(read)]
    for phrase in unread:
        print(f"no golden text shows: {phrase!r}")
    if len(known) < 200:
        print(f"only {len(known)} phrases found: has the phrasebook moved?")
    return 1 if unread or len(known) < 200 else 0


if __name__ == "__main__":
    sys.exit(main())
