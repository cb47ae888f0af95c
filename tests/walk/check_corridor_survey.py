#!/usr/bin/env python3
"""The corridor surveyed on its first lap and walked again: is the filter on the right leg, and how far from the truth?

  check_corridor_survey.py FAROL_CLI REPOSITORY WORK_FOLDER [--develop] [--check]

The first lap is walked with `farol-cli survey` along the corners of the loop, at 2 s a picture (a walker's pace for
pictures some 1.9 m apart). Then lap 2 is walked from an unknown start with the filter; truth is where the frame of lap 1
was taken that samples_GT.bmp matches, the frames evenly spaced along the drawn loop. --develop never touches lap 2: it
surveys every other frame of lap 1 and asks those between, both ways round. --check fails where the goal is missed.
Exits with 77 where the photographs are not on the machine.
"""
import json
import os
import shutil
import sqlite3
import struct
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
SURE = 0.8
STEP, FIRST, WIDTH, HEIGHT = 1.9, 2.0, 12.4, 25.6  # of the drawn loop: resources/examples/corridor/draw.py
LAP = 40
LEG_ENDS = [(6, "leg-a"), (19, "leg-b"), (25, "leg-c"), (39, "leg-d"), (46, "leg-a"), (59, "leg-b"), (65, "leg-c"),
            (80, "leg-d"), (84, "leg-a")]
CORNERS = [(WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT), (0.0, 0.0)]


def run(*words, **options):
    done = subprocess.run([str(w) for w in words], stdout=subprocess.PIPE, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: exit {done.returncode}")
    return done.stdout.decode()


def legs_allowed(frame):
    """Turns may be off by one frame (the data's MANIFEST)."""
    return {next(leg for end, leg in LEG_ENDS if min(84, max(1, frame + k)) <= end) for k in (-1, 0, 1)}


def spot(frame):
    """Where a frame of the first lap was taken, evenly spaced along the loop."""
    arc = (FIRST + (frame - 1) * STEP) % (2 * (WIDTH + HEIGHT))
    for length, start, way in ((WIDTH, (0, 0), (1, 0)), (HEIGHT, (WIDTH, 0), (0, 1)), (WIDTH, (WIDTH, HEIGHT), (-1, 0)),
                               (HEIGHT, (0, HEIGHT), (0, -1))):
        if arc <= length:
            return start[0] + way[0] * arc, start[1] + way[1] * arc
        arc -= length
    return 0.0, 0.0


def matched(path):
    """frame -> frame of the first lap: the middle of the five that the ground truth matches (bands are cut at the first
    frame, so counted back from their ends)."""
    data = path.read_bytes()
    start, = struct.unpack_from("<I", data, 10)
    width, height = struct.unpack_from("<ii", data, 18)
    stride = (width + 3) // 4 * 4
    middles = {}
    for i in range(height):
        row = data[start + (height - 1 - i) * stride:][:width]
        bright = [j + 1 for j in range(width) if row[j]]
        if bright:
            middles[i + 1] = (bright[-1] - 2 - 1) % LAP + 1
    return middles


class Walk:
    def __init__(self, cli, top, work, photographs, environment):
        self.cli, self.work, self.photographs, self.environment = cli, work, photographs, environment
        self.example = top / "resources" / "examples" / "corridor"

    def folder(self, name, frames):
        folder = self.work / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for frame in frames:
            (folder / f"{frame}.jpg").symlink_to((self.photographs / f"{frame}.jpg").resolve())
        return folder

    def survey(self, name, frames, seconds):
        """The example's map and objects with the places of these frames only, and none of its own."""
        building, library = self.work / f"{name}.gpkg", self.work / f"{name}-library.gpkg"
        library.unlink(missing_ok=True)
        shutil.copy(self.example / "corridor.gpkg", building)
        building.chmod(0o644)
        with sqlite3.connect(building) as data:
            data.execute("delete from landmarks where kind = 'place'")
        way = [spot(frames[0])] + CORNERS[:-1] + [spot(frames[-1]) if frames[-1] < LAP else CORNERS[-1]]
        along = ",".join(f"{x:g},{y:g},0" for x, y in way)
        report = json.loads(run(self.cli, "survey", building, library, "--source", self.folder(name, frames), "--fps",
                                1.0 / seconds, "--along", along, "--json", stderr=subprocess.DEVNULL))
        off = sorted(distance(p["position"], spot(frames[p["frame"]])) for p in report["places"])
        print(f"  {name}: {len(off)} places along {report['length_m']:.1f} m, median {off[len(off) // 2]:.1f} m, at most "
              f"{off[-1]:.1f} m from even spacing")
        run("bash", self.example / "train.sh", library, "objects", env=self.environment, stderr=subprocess.DEVNULL)
        return building, library

    def ask(self, building, library, name, frames, seconds, *more):
        told = run(self.cli, "run", "--map", building, "--library", library, "--source", self.folder(name, frames), "--fps",
                   1.0 / seconds, "--localiser", "bayes", "--json-lines", *more)
        (self.work / f"{name}.jsonl").write_text(told, encoding="utf-8")
        return [json.loads(line) for line in told.splitlines()]


def distance(a, b):
    return ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5


class Score:
    def __init__(self):
        self.first, self.asked, self.right, self.strict, self.sure, self.surely_wrong = None, 0, 0, 0, 0, 0
        self.errors, self.wrong = [], []

    def add(self, lines, frames, truth):
        """From the first frame on in which something on the map was recognised: before it there is only a guess."""
        seen = [line["frame"] for line in lines if line["type"] == "detection" and line["template"]]
        first = min(seen, default=len(frames))
        self.first = frames[first] if first < len(frames) else None
        for line in lines:
            if line["type"] != "fix" or line["frame"] < first:
                continue
            frame, region = frames[line["frame"]], line["region"]
            self.asked += 1
            right = region in legs_allowed(frame)
            self.right += right
            self.strict += region == next(leg for end, leg in LEG_ENDS if frame <= end)
            self.sure += line["confidence"] >= SURE
            self.surely_wrong += line["confidence"] >= SURE and not right
            if not right:
                self.wrong.append((frame, region, line["confidence"]))
            if line["position"] and frame in truth:
                self.errors.append(distance(line["position"], spot(truth[frame])))

    def show(self, name):
        off = sorted(self.errors)
        at = lambda share: off[min(len(off) - 1, int(share * len(off)))] if off else float("nan")
        print(f"  {name:34s} first fix at {self.first}, right leg {self.right} of {self.asked} ({self.share():.1%}; without "
              f"slack {self.strict}), sure {self.sure}, surely wrong {self.surely_wrong}, metres off: median {at(0.5):.2f}, "
              f"90 % {at(0.9):.2f}")
        if self.wrong:
            print(f"      wrong: {self.wrong}")
        return at(0.5)

    def share(self):
        return self.right / max(1, self.asked)


def develop(walk):
    """Choices are made on these: every other frame surveyed, those between asked."""
    for name, first in (("odd", 1), ("even", 2)):
        surveyed, asked = list(range(first, LAP + 1, 2)), list(range(3 - first, LAP + 1, 2))
        building, library = walk.survey(name, surveyed, 4.0)
        for seconds in (4.0, 2.0):
            score = Score()
            score.add(walk.ask(building, library, f"{name}-asked", asked, seconds), asked, {f: f for f in asked})
            score.show(f"{name} surveyed, {seconds:g} s a picture")
    return 0


def again(walk, check):
    building, library = walk.survey("lap1", list(range(1, LAP + 1)), 2.0)
    frames = list(range(41, 85))
    truth = matched(walk.photographs / "samples_GT.bmp")
    good = True
    for name, seconds, more in (("lap 2, 2 s a picture", 2.0, ()), ("lap 2, 1.5 s a picture", 1.5, ()),
                                ("lap 2, 1 s a picture", 1.0, ())):
        score = Score()
        score.add(walk.ask(building, library, "lap2", frames, seconds, *more), frames, truth)
        median = score.show(name)
        if seconds == 2.0:
            good = score.share() >= 0.97 and median <= 2.0 and score.surely_wrong == 0
    return 1 if check and not good else 0


def main(cli, top, work, flags):
    data = Path(os.environ.get("FAROL_DATA") or top / ".." / "shared" / "data")
    photographs = data / "images" / "corridor_walk"
    if not photographs.is_dir():
        print(f"skipped: the photographs {photographs} are not on this machine")
        return SKIPPED
    work.mkdir(parents=True, exist_ok=True)
    walk = Walk(cli, top, work, photographs, dict(os.environ, FAROL_CLI=str(cli), FAROL_DATA=str(data)))
    return develop(walk) if "--develop" in flags else again(walk, "--check" in flags)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve(), sys.argv[4:]))
