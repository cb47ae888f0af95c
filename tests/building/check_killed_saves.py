#!/usr/bin/env python3
"""Kills a program in the middle of saving a map, many times, and looks at what is left.

  check_killed_saves.py SAVE_LOOP FAROL_CLI WORK_FOLDER [KILLS]

Each kill (SIGKILL) comes at a moment drawn evenly from one and a half times the measured length of a save: the new file
takes the old one's place at the very end, a save after a killed one takes longer, and that moment has to be among those
drawn. Afterwards the file must be the map before or a map after that save, whole: every row of one version, sound to SQLite, readable for farol-cli.
The next save begins from what was left, so what killed programs leave behind must not disturb it either.
"""
import json
import os
import random
import shutil
import sqlite3
import subprocess
import sys
import time
from pathlib import Path


def version_in(path):
    """The version of the file, or a text that says what is wrong with it."""
    with sqlite3.connect(f"file:{path}?mode=ro", uri=True) as file:
        if file.execute("PRAGMA integrity_check").fetchall() != [("ok",)]:
            return "SQLite finds the file damaged"
        version = int(file.execute("SELECT value FROM farol WHERE key = 'version'").fetchone()[0])
        title = file.execute("SELECT value FROM farol WHERE key = 'title'").fetchone()[0]
        rooms, least, most = file.execute("SELECT COUNT(*), MIN(version), MAX(version) FROM regions").fetchone()
        named = file.execute("SELECT COUNT(*) FROM regions WHERE name LIKE ?", (f"% of {version}",)).fetchone()[0]
    if (rooms, least, most, named, title) != (200 + version % 50, version, version, rooms, f"Version {version}"):
        return f"half of one version and half of another: {(version, rooms, least, most, named, title)}"
    return version


class Saver:
    def __init__(self, program, path):
        self.process = subprocess.Popen([program, path], stdout=subprocess.PIPE, text=True)

    def next(self, word):
        line = self.process.stdout.readline().split()
        if not line or line[0] != word:
            sys.exit(f"the saving program said {line}, not {word}")
        return int(line[1]), time.monotonic()

    def kill(self):
        self.process.kill()
        rest = self.process.stdout.read().split()
        self.process.wait()
        done = [int(rest[i + 1]) for i in range(0, len(rest) - 1, 2) if rest[i] == "done"]
        begun = [int(rest[i + 1]) for i in range(0, len(rest) - 1, 2) if rest[i] == "begin"]
        return begun, done


def length_of_a_save(program, path):
    """Of the first save of a program, as the ones that are killed are."""
    lengths = []
    for _ in range(5):
        saver = Saver(program, path)
        _, begun = saver.next("begin")
        _, done = saver.next("done")
        saver.kill()
        lengths.append(done - begun)
    return sorted(lengths)[2]


def main():
    program, farol_cli, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    kills = int(sys.argv[4]) if len(sys.argv) > 4 else 30
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    path = folder / "map.gpkg"
    length = length_of_a_save(program, path)
    chance = random.Random(20261122)
    old = new = failed = 0
    for number in range(kills):
        before = version_in(path)
        saver = Saver(program, path)
        version, begun = saver.next("begin")
        moment = begun + chance.random() * 1.5 * length
        while time.monotonic() < moment:
            pass
        more, done = saver.kill()
        last = max([version, *more])
        finished = max([before, *done])
        found = version_in(path)
        told = subprocess.run([farol_cli, "map", "info", path, "--json"], stdout=subprocess.PIPE, check=False)
        readable = told.returncode == 0 and json.loads(told.stdout)["regions"] == 200 + (found if isinstance(found, int) else 0) % 50
        if found not in range(finished, last + 1) or not readable:
            failed += 1
            print(f"kill {number}: version {finished} to {last} was to be there, {found} is; readable: {readable}")
        elif found == before:
            old += 1
        else:
            new += 1
    saver = Saver(program, path)  # one undisturbed save clears what the killed ones left
    saver.next("begin")
    saver.next("done")
    saver.kill()
    litter = [name for name in os.listdir(folder) if name != path.name and f"-{saver.process.pid}-" not in name]
    print(f"{kills} kills within saves of {length * 1000:.0f} ms: {old} left the old map, {new} the new one, "
          f"{failed} something else; files left beside it: {litter}")
    sys.exit(1 if failed or litter else 0)


if __name__ == "__main__":
    main()
