#!/usr/bin/env python3
"""Do map, frames, training views and truth of the drawn example fit together?

  check_drawn_files.py FAROL_CLI REPOSITORY
"""
import json
import subprocess
import sys
from pathlib import Path

from drawn_example import FOLDER, Check, landmarks, run, training, truth

MOST_BYTES = 1_500_000


def main(cli, top):
    example, check = top / FOLDER, Check()
    info = json.loads(run(cli, "map", "info", example / "drawn.gpkg", "--json"))
    check.that(info["components"] == 1 and info["largest_component"] == info["regions"], "every region can be walked to")
    check.that(info["accesses_joined"] == info["accesses"], "every access joins two regions")
    check.that(info["unnamed_regions"] == 0, "every region has a name to be spoken")
    checked = subprocess.run([str(cli), "map", "check", str(example / "drawn.gpkg"), "--json"], stdout=subprocess.PIPE, check=False)
    findings = [f for f in json.loads(checked.stdout)["findings"] if f["severity"] != "note"]
    check.that(checked.returncode == 0 and not findings, f"map check finds nothing wrong: {findings or 'yes'}")

    known, rows, views = landmarks(example), truth(example), training(example)
    frames = {path.name for path in (example / "frames").iterdir()}
    check.that(frames == {row["frame"] for row in rows}, f"{len(rows)} frames, each with its truth")
    named = {name for row in rows for name in row["visible"]}
    check.that(named <= set(known), f"the truth names landmarks of the map only: {sorted(named - set(known)) or 'yes'}")
    pictures = {path.name for path in (example / "train").glob("*.jpg")}
    check.that(pictures == {view[0] for view in views}, f"{len(views)} training views, each listed")
    mapped = {entry["template"] for entry in known.values() if entry["template"]}
    check.that(mapped == {view[1] for view in views}, "the templates of the map are those that are trained")
    kinds = {(entry["template"], entry["kind"]) for entry in known.values() if entry["template"]}
    check.that(kinds == {(view[1], view[2]) for view in views}, "kinds agree between map and training list")
    size = sum(path.stat().st_size for path in example.rglob("*") if path.is_file() and path.suffix != ".pyc")
    check.that(size < MOST_BYTES, f"the example is small: {size} bytes")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()))
