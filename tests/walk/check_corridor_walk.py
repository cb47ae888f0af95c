#!/usr/bin/env python3
"""The real walk, end to end: trains the corridor's library from the first lap and walks the second with farol-cli.

  check_corridor_walk.py FAROL_CLI REPOSITORY WORK_FOLDER

Checks what the first milestone promises: the right leg in 85 % of the frames from the first fix on, a first fix by
frame 46, a byte-exact replay (twice), landmarks named in 80 % of the frames that show one, none of another leg.
Exits with 77 (skipped) where the photographs are not on the machine.
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
# Last frame of each leg, both laps (the data's MANIFEST). One frame of slack at turns.
LEG_ENDS = [(6, "leg-a"), (19, "leg-b"), (25, "leg-c"), (39, "leg-d"), (46, "leg-a"), (59, "leg-b"), (65, "leg-c"),
            (80, "leg-d"), (84, "leg-a")]
# Frames that show no trained landmark at all: a blank wall.
SHOWS_NOTHING = {46}


def leg_of(frame):
    return next(leg for end, leg in LEG_ENDS if frame <= end)


def legs_allowed(frame):
    return {leg_of(max(1, frame - 1)), leg_of(frame), leg_of(min(84, frame + 1))}


def run(*words, **options):
    done = subprocess.run([str(w) for w in words], stdout=subprocess.PIPE, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: exit {done.returncode}")
    return done.stdout


def lines_of(output):
    return [json.loads(line) for line in output.decode().splitlines()]


class Check:
    def __init__(self):
        self.failed = 0

    def that(self, holds, text):
        print(("  ok    " if holds else "  FAILS ") + text)
        self.failed += 0 if holds else 1


def read_csv(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def trained_heights(example):
    """The height of each object in the picture it was trained from: the longer upright edge of its outline."""
    heights = {}
    for line in (example / "objects.txt").read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            words = line.split()
            x = [float(v) for v in words[4].split(",")]
            left = ((x[0] - x[6]) ** 2 + (x[1] - x[7]) ** 2) ** 0.5
            right = ((x[2] - x[4]) ** 2 + (x[3] - x[5]) ** 2) ** 0.5
            heights[words[0]] = max(heights.get(words[0], 0.0), left, right)
    return heights


def places(example):
    """frame of the first lap -> template"""
    rows = [line.split() for line in (example / "places.txt").read_text(encoding="utf-8").splitlines()
            if line.strip() and not line.startswith("#")]
    return {int(row[0]): (row[1], row[2]) for row in rows}


def check_walk(check, lines):
    names = [int(Path(line["name"]).stem) for line in lines if line["type"] == "frame"]
    fixes = [line for line in lines if line["type"] == "fix"]
    check.that(len(names) == 40 and len(fixes) == 40, f"{len(fixes)} fixes for {len(names)} frames")
    known = [(frame, fix) for frame, fix in zip(names, fixes) if fix["region"]]
    first = known[0][0] if known else None
    check.that(first is not None and first <= 46, f"first fix at frame {first} (at the latest 46)")
    after = [(frame, fix) for frame, fix in zip(names, fixes) if first is not None and frame >= first]
    right = [frame for frame, fix in after if fix["region"] in legs_allowed(frame)]
    strict = sum(fix["region"] == leg_of(frame) for frame, fix in after)
    share = len(right) / max(1, len(after))
    check.that(share >= 0.85, f"right leg in {len(right)} of {len(after)} frames ({share:.1%}; without slack {strict})")
    wrong = [(frame, fix["region"]) for frame, fix in after if frame not in right]
    if wrong:
        print(f"          wrong: {wrong}")
    arrivals = [line for line in lines if line["type"] == "cue" and line["kind"] == "arrived"]
    check.that(len(arrivals) >= 1 and all(names[a["frame"]] in range(59, 67) for a in arrivals),
               f"arrival announced at frames {[names[a['frame']] for a in arrivals]} (leg-c is 60 to 65)")


def check_recognition(check, output, example, names_leg):
    heights, shown = trained_heights(example), {}
    for row in read_csv(example / "lap2_labels.csv"):
        if row["whole"] == "yes" and float(row["height_px"]) >= 0.5 * heights.get(row["template"], 1e9):
            shown.setdefault(int(row["frame"]), set()).add(row["template"])
    first_lap = places(example)
    named, pairs_named, pairs, foreign = [], 0, 0, []
    for line in lines_of(output):
        frame = int(Path(line["file"]).stem)
        found = {d["template"] for d in line["detections"]}
        # The spot seen again: the picture of the first lap taken there, give or take two steps.
        spots = {first_lap[k][0] for k in range(frame - 42, frame - 37) if k in first_lap}
        expected = shown.get(frame, set()) | spots
        pairs += len(shown.get(frame, set()))
        pairs_named += len(shown.get(frame, set()) & found)
        if frame not in SHOWS_NOTHING and expected & found:
            named.append(frame)
        foreign += [(frame, t) for t in sorted(found) if not names_leg[t] & legs_allowed(frame)]
    total = 40 - len(SHOWS_NOTHING)
    check.that(len(named) >= 0.8 * total, f"{len(named)} of {total} frames that show a trained landmark name it")
    print(f"          objects at half their trained size or more, whole: {pairs_named} of {pairs} named; not named at all: "
          f"{sorted(set(range(41, 81)) - SHOWS_NOTHING - set(named))}")
    check.that(not foreign, f"landmarks of another leg named: {foreign or 'none'}")


def main(cli, top, work):
    data = Path(os.environ.get("FAROL_DATA") or top / ".." / "shared" / "data")
    photographs = data / "images" / "corridor_walk"
    if not photographs.is_dir():
        print(f"skipped: the photographs {photographs} are not on this machine")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    lap2 = work / "lap2"
    lap2.mkdir(parents=True)
    for frame in range(41, 81):
        (lap2 / f"{frame}.jpg").symlink_to((photographs / f"{frame}.jpg").resolve())
    example, library = top / "resources" / "examples" / "corridor", work / "library.gpkg"
    environment = dict(os.environ, FAROL_CLI=str(cli), FAROL_DATA=str(data))
    run("bash", example / "train.sh", library, env=environment)
    names_leg = {}
    with sqlite3.connect(example / "corridor.gpkg") as database:
        for template, leg in database.execute("select template, region_id from landmarks where template is not null"):
            names_leg.setdefault(template, set()).add(leg)
    trained = {entry["template"] for entry in json.loads(run(cli, "library", "list", library, "--json"))["templates"]}

    check = Check()
    check.that(trained <= set(names_leg), f"every trained template stands in the map: {sorted(trained - set(names_leg)) or 'yes'}")
    walk = [cli, "run", "--map", example / "corridor.gpkg", "--library", library, "--source", lap2, "--fps", "1", "--to",
            "leg-c", "--json-lines"]
    output = run(*walk)
    check_walk(check, lines_of(output))
    recorded = run(*walk, "--record", work / "recording")
    check.that(recorded == output, "the same walk again gives the same lines")
    for _ in range(2):
        check.that(run(cli, "replay", work / "recording", "--json-lines") == output, "replay gives the same bytes")
    check_recognition(check, run(cli, "recognise", library, lap2, "--json-lines"), example, names_leg)
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()))
