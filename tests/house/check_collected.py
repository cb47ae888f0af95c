#!/usr/bin/env python3
"""Fails when a text of ui/ or app/, or a sentence of core, is not in translations/*.ts, or one there is used no more.

Usage: check_collected.py ROOT LUPDATE. Collects into a copy; the .ts files of the repository are only read. What to do
about a failure: ./dev translate, then fill in what is unfinished in translations/farol_*.ts.
"""
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree
from pathlib import Path


def texts(path):
    found = set()
    for context in tree.parse(path).getroot().findall("context"):
        for message in context.findall("message"):
            kind = (message.find("translation").get("type") or "") if message.find("translation") is not None else ""
            if kind not in {"vanished", "obsolete"}:
                found.add((context.findtext("name"), message.findtext("source"), message.findtext("comment")))
    return found


root, lupdate = Path(sys.argv[1]), sys.argv[2]
bad = []
for kept in sorted((root / "translations").glob("farol_*.ts")):
    only = ["-pluralonly"] if kept.stem == "farol_en" else []
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / kept.name
        shutil.copy(kept, fresh)
        command = [lupdate, "-silent", "-recursive", "-I", str(root), "-locations", "none", "-no-obsolete", *only,
                   "-tr-function-alias", "QT_TRANSLATE_NOOP+=SAID,QT_TRANSLATE_N_NOOP+=SAID_OF_MANY",
                   "ui", "app", "core/base/base_sayings.cpp", "core/building/sentence_table.cpp",
                   "core/capture/sayings.cpp", "core/recognition/sayings.cpp", "core/session/sayings.cpp", "-ts", str(fresh)]
        done = subprocess.run(command, cwd=root, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr or f"{lupdate} failed")
        old, new = texts(kept), texts(fresh)
    bad += [f"{kept.name}: not collected: {name}: {source!r}" for name, source, _ in sorted(new - old, key=str)]
    bad += [f"{kept.name}: used no more: {name}: {source!r}" for name, source, _ in sorted(old - new, key=str)]
print("\n".join(bad + (["run ./dev translate"] if bad else [])))
sys.exit(1 if bad else 0)
