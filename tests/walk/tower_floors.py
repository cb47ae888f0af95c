#!/usr/bin/env python3
"""Eight floors that look alike (images/tower): is a wrong one ever stated? Places from every clip but the `alt` passes,
then these, walked the other way from an unknown start.

  tower_floors.py FAROL_CLI REPOSITORY WORK_FOLDER [--develop | --halves] [--keep]

--develop asks the surveyed hallways instead, each with its own places taken out: choices are made on these.
--halves surveys every other picture of the hallways and asks those between: what is stated where the way was surveyed in
the same direction (one pass, so it flatters).
--keep uses the library that is already in the work folder. Exits with 77 where the photographs are not on the machine.
"""
import csv
import json
import os
import shutil
import sqlite3
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
SURE = 0.8


def run(*words, **options):
    done = subprocess.run([str(w) for w in words], stdout=subprocess.PIPE, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: exit {done.returncode}")
    return done.stdout.decode()


def plan(example, kind):
    for line in (example / "tower.txt").read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words and words[0] == kind:
            yield words[1:]


class Clips:
    def __init__(self, tower, work):
        self.work, self.frames = work, {}
        with open(tower / "frames.csv", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                self.frames.setdefault(row["clip"], []).append((tower / row["image"]).resolve())

    def folder(self, clip, half=None):
        """All pictures of a clip, or every other one from the first or the second on."""
        folder = self.work / "clips" / (clip if half is None else f"{clip}-{half}")
        if not folder.is_dir():
            folder.mkdir(parents=True)
            for number, picture in enumerate(self.frames[clip]):
                if half is None or number % 2 == half:
                    (folder / f"{number + 1}.jpg").symlink_to(picture)
        return folder


def rate(half):
    """The pictures were taken a second apart."""
    return 1.0 if half is None else 0.5


def survey(cli, example, clips, building, library, half):
    shutil.copy(example / "tower.gpkg", building)
    library.unlink(missing_ok=True)
    for clip, _, _ in plan(example, "spot"):
        # Pictures with too few features are refused, one by one, in words.
        run(cli, "train", library, "--template", clip, "--kind", "place", *clips.frames[clip], stderr=subprocess.DEVNULL)
    for clip, level, *way in plan(example, "walk"):
        along = ",".join(f"{spot},{level}" for spot in way)
        report = run(cli, "survey", building, library, "--source", clips.folder(clip, half), "--fps", rate(half), "--along",
                     along, "--prefix", clip, stderr=subprocess.DEVNULL)
        print(f"  {clip}: {report.strip()}")


def without(clip, building, library, work):
    """Map and library that have never seen this clip."""
    other, books = work / "other.gpkg", work / "other-library.gpkg"
    shutil.copy(building, other)
    shutil.copy(library, books)
    with sqlite3.connect(other) as data:
        data.execute("delete from landmarks where template like ?", (clip + "%",))
    with sqlite3.connect(books) as data:
        for table in ("views", "templates"):
            data.execute(f"delete from {table} where template like ?", (clip + "%",))
    return other, books


def fixes(text):
    return [line for line in map(json.loads, text.splitlines()) if line.get("type", "fix") == "fix"]


def ask(cli, building, library, source, work, name, fps):
    """Fixes with everything, and with what was read left out."""
    told = run(cli, "run", "--map", building, "--library", library, "--source", source, "--fps", fps, "--localiser", "bayes",
               "--json-lines")
    (work / f"{name}.jsonl").write_text(told, encoding="utf-8")
    lines = [json.loads(line) for line in told.splitlines()]
    log = work / f"{name}-without-text.jsonl"
    log.write_text("".join(json.dumps(line) + "\n" for line in lines
                           if not (line["type"] == "detection" and line["kind"] == "text")), encoding="utf-8")
    silent = run(cli, "locate", building, log, "--localiser", "bayes", "--every", 1.0 / fps, "--json-lines")
    return {"with text": fixes(told), "without text": fixes(silent)}


class Tally:
    def __init__(self):
        self.asked = self.right = self.wrong = self.near_wrong = self.near_right = self.likeliest = 0

    def add(self, said, level):
        for fix in said:
            self.asked += 1
            here = fix["level"] == level
            self.likeliest += here
            if fix["confidence"] >= SURE:
                self.right += here
                self.wrong += not here
            if fix["near_confidence"] >= SURE:
                self.near_right += here
                self.near_wrong += not here

    def line(self, name):
        share = [100.0 * n / max(1, self.asked) for n in
                 (self.wrong, self.right, self.near_wrong, self.near_right, self.likeliest)]
        return f"  {name:42s} {self.asked:4d} " + " ".join(f"{value:8.1f}" for value in share)


def main(cli, top, work, flags):
    data = Path(os.environ.get("FAROL_DATA") or top / ".." / "shared" / "data")
    tower, example = data / "images" / "tower", top / "resources" / "examples" / "tower"
    if not tower.is_dir():
        print(f"skipped: the photographs {tower} are not on this machine")
        return SKIPPED
    work.mkdir(parents=True, exist_ok=True)
    clips = Clips(tower, work)
    develop, half = "--develop" in flags, 0 if "--halves" in flags else None
    name = "tower" if half is None else "halves"
    building, library = work / f"{name}.gpkg", work / f"{name}-library.gpkg"
    if "--keep" not in flags or not library.is_file():
        survey(cli, example, clips, building, library, half)
    asked = [words[:2] for words in plan(example, "asked" if not develop and half is None else "walk")]
    print(f"  {'% of time, sure is .8 or more':42s} asked    wrong    right  near wr.  near r. likeliest")
    sums = {}
    for clip, level in asked:
        here, books = without(clip, building, library, work) if develop else (building, library)
        source = clips.folder(clip, None if half is None else 1)
        for how, said in ask(cli, here, books, source, work, clip, rate(half)).items():
            one = Tally()
            for tally in (one, sums.setdefault(how, Tally())):
                tally.add(said, float(level))
            print(one.line(f"{clip}, {how}"))
    for how, tally in sums.items():
        print(tally.line(f"all, {how}"))
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve(), sys.argv[4:]))
