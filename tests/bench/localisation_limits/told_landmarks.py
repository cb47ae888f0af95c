#!/usr/bin/env python3
"""The walks of `evaluate localisation` with each detection's landmark told: where does the filter's limit lie?

    tests/bench/localisation_limits/told_landmarks.py ../shared/data OUT
    build/release/bin/farol-cli evaluate localisation --data OUT

Each detection is given to the landmark that fits it best from where the user truly stood and looked (kind,
range, bearing, text); it becomes that landmark's trained template, with the right kind and text. What fits
nothing is left out. So nothing is confused and nothing is false: no way of telling detections apart can do
better with the same sights.
"""

import argparse
import bisect
import json
import math
import shutil
import sqlite3
import struct
import sys
from pathlib import Path

# What is taken for what (the study's table of look-alikes).
LOOK_ALIKE = {("door", "rectangle"), ("door", "locker"), ("locker", "door"), ("locker", "rectangle"),
              ("poster", "rectangle"), ("rectangle", "poster"), ("rectangle", "door"), ("extinguisher", "rectangle"),
              ("stairs", "rectangle"), ("exit_sign", "rectangle"), ("exit_sign", "poster"), ("text", "poster")}
FARTHEST_M, LATEST_S, WORST = 6.0, 0.6, 12.0


def point_of(blob):
    """A GeoPackage point: header, envelope, then well-known binary."""
    envelope = {0: 0, 1: 32, 2: 48, 3: 48, 4: 64}[(blob[3] >> 1) & 7]
    return struct.unpack("<dd", blob[8 + envelope + 5:8 + envelope + 21])


def landmarks_of(file):
    """Reads the landmarks, and makes each its own template in the file."""
    with sqlite3.connect(file) as database:
        # The triggers of the spatial index need functions that only GDAL has; no place changes here.
        named = "select name from sqlite_master where type='trigger' and tbl_name='landmarks'"
        for (name,) in database.execute(named).fetchall():
            database.execute(f'drop trigger "{name}"')
        rows = database.execute("select geom, landmark_id, kind, text, level from landmarks").fetchall()
        database.execute("update landmarks set template = landmark_id")
    return [(*point_of(geometry), *rest) for geometry, *rest in rows]


def misfit(detection, pose, landmark):
    """Squared deviations, as of a normal error; infinite where the landmark cannot be meant."""
    x, y, _, kind, text, level = landmark
    away = math.hypot(x - pose["x"], y - pose["y"])
    if level != pose["level"] or not 0.1 < away < FARTHEST_M:
        return math.inf
    cost = 0.0
    if kind != detection["kind"]:
        if (kind, detection["kind"]) not in LOOK_ALIKE:
            return math.inf
        cost += 4.0
    if detection.get("range_m"):
        cost += (math.log(away / detection["range_m"]) / 0.3) ** 2
    if detection.get("bearing_deg") is not None and pose.get("yaw_deg") is not None:
        true = math.degrees(math.atan2(y - pose["y"], x - pose["x"])) - pose["yaw_deg"]
        off = (true - detection["bearing_deg"] + 180.0) % 360.0 - 180.0
        cost += (off / (8.0 + math.degrees(0.5 / away))) ** 2
    if detection.get("text"):
        cost += 20.0 if not text else 3.0 if detection["text"] != text else 0.0
    return cost


def told(line, times, poses, landmarks):
    """The line with its landmark told; None: of no landmark."""
    detection = json.loads(line)
    if "kind" not in detection:
        return line
    after = bisect.bisect(times, detection["t"])
    near = [poses[i] for i in (after - 1, after) if 0 <= i < len(poses) and abs(times[i] - detection["t"]) <= LATEST_S]
    fits = [(misfit(detection, pose, each), each) for pose in near for each in landmarks]
    cost, best = min(fits, key=lambda fit: fit[0], default=(math.inf, None))
    if cost >= WORST:
        return None
    detection["template"], detection["kind"] = best[2], best[3]
    if detection.get("text"):
        detection["text"] = best[4]
    return json.dumps(detection) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data")
    parser.add_argument("out", help="a new folder")
    arguments = parser.parse_args()
    asked = given = 0
    for building in sorted(Path(arguments.data, "walks").iterdir()):
        folder = Path(arguments.out, "walks", building.name)
        folder.mkdir(parents=True)
        shutil.copyfile(building / "map.gpkg", folder / "map.gpkg")
        landmarks = landmarks_of(folder / "map.gpkg")
        for truth in sorted(building.glob("*.truth.jsonl")):
            shutil.copyfile(truth, folder / truth.name)
            poses = [json.loads(line) for line in truth.read_text().splitlines()]
            times = [pose["t"] for pose in poses]
            name = truth.name.replace(".truth", "")
            before = (building / name).read_text().splitlines(keepends=True)
            lines = [told(line, times, poses, landmarks) for line in before]
            asked += sum('"kind"' in line for line in before)
            given += sum(line is not None and '"kind"' in line for line in lines)
            (folder / name).write_text("".join(line for line in lines if line is not None))
    print(f"{given} of {asked} detections told")
    return 0


if __name__ == "__main__":
    sys.exit(main())
