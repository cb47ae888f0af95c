#!/usr/bin/env python3
"""Fails on an untranslated or unfinished text.

Every language but English: every message is translated, none is unfinished, and none is a silent copy of the English
unless the allow-list says that both languages really use the same word. English: every plural form is filled in. Place
markers (%1, %n) must be the same on both sides. What is spoken may not be much longer than in English: it is heard while
walking.
"""
import re
import sys
import xml.etree.ElementTree as tree
from pathlib import Path

# The same in both languages: names, symbols and keys.
SAME = {"Farol", "%1 – Farol", "Tab", "Page Up, Page Down", "OK", "%1", "%1 %", "%1 m", "%1x", "%1×", "%1: %2", "Total", "Local", "PDF", "PDF (%1)", "Alt"}
# The same in English and in this one.
SAME_IN = {
    "de": {"minus %1", "&Name:", "text", "Name", "Text", "Region", "Region %1", "Start", "Plan", "Kiosk", "Esc", "normal"},
    "es": {"&No", "Error", "General", "Ctrl", "Esc", "normal"},
    "fr": {"Halls", "hall", "destination", "Destination", "Directions", "Distances", "Pages", "Plan", "&Pause", "passage", "Ctrl"},
    "pt": {"Ctrl", "Shift", "Esc", "normal"},
}
# Spoken, from a key or on the way. The sentences that are put together are checked by ui/message_lint.
SPOKEN = {"farol::ui::Phrasebook", "farol::ui::KioskMachine", "farol::ui::KioskWords", "farol::ui::KioskPlaces",
          "farol::ui::SpeechQueue"}


def is_long(source, form):
    return len(form.split()) > 1.5 * len(source.split()) + 4


def forms(message):
    node = message.find("translation")
    plural = node.findall("numerusform") if node is not None else []
    return [form.text or "" for form in plural] if plural else [(node.text or "") if node is not None else ""]


def problems(path, language):
    is_english = language == "en"
    for context in tree.parse(path).getroot().findall("context"):
        name = context.findtext("name")
        for message in context.findall("message"):
            source = message.findtext("source") or ""
            node = message.find("translation")
            kind = node.get("type") if node is not None else "unfinished"
            if kind in {"vanished", "obsolete"}:
                yield f"{name}: vanished text left behind: {source!r}"
                continue
            plural = message.get("numerus") == "yes"
            if is_english and not plural:
                continue
            if kind == "unfinished":
                yield f"{name}: unfinished: {source!r}"
            for form in forms(message):
                if not form.strip():
                    yield f"{name}: empty translation: {source!r}"
                elif not is_english and form == source and source not in SAME and source not in SAME_IN.get(language, set()) and re.search(r"[A-Za-z]{3}", source):
                    yield f"{name}: still English: {source!r}"
                elif name in SPOKEN and is_long(source, form):
                    yield f"{name}: too long to be heard: {source!r} / {form!r}"
                elif not plural and sorted(re.findall(r"%\d|%L\d|%n", source)) != sorted(re.findall(r"%\d|%L\d|%n", form)):
                    yield f"{name}: markers differ: {source!r} / {form!r}"


root = Path(sys.argv[1])
bad = []
for path in sorted((root / "translations").glob("farol_*.ts")):
    bad += [f"{path.name}: {text}" for text in problems(path, path.stem.removeprefix("farol_"))]
print("\n".join(bad))
sys.exit(1 if bad else 0)
