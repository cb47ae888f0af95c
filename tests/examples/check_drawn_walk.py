#!/usr/bin/env python3
"""The drawn example, end to end: trains its library and walks it with farol-cli, against a truth that is exact.

  check_drawn_walk.py FAROL_CLI REPOSITORY WORK_FOLDER
"""
import json
import os
import shutil
import sys
from pathlib import Path

from drawn_example import BARELY_IN_VIEW, FOLDER, Check, landmarks, run, training, truth

LATEST_FIRST_FIX = 5      # frames, counted from 1
LEAST_RIGHT = 0.85
LEAST_NAMED = 0.8
START_REGION, DESTINATION = "hall", "library"


def allowed(rows, index):
    """The true region of the frame and of the frames next to it: one frame of slack at borders."""
    return {rows[k]["region"] for k in (index - 1, index, index + 1) if 0 <= k < len(rows)}


def check_fixes(check, lines, rows):
    fixes = [line for line in lines if line["type"] == "fix"]
    frames = [Path(line["name"]).name for line in lines if line["type"] == "frame"]
    check.that(frames == [row["frame"] for row in rows], f"{len(frames)} frames come in the order of the walk")
    check.that(len(fixes) == len(rows), f"{len(fixes)} fixes for {len(rows)} frames")
    first = next((k for k, fix in enumerate(fixes) if fix["region"]), None)
    check.that(first is not None and first < LATEST_FIRST_FIX,
               f"the first fix comes at frame {None if first is None else first + 1} (at the latest {LATEST_FIRST_FIX})")
    after = [] if first is None else list(range(first, len(fixes)))
    wrong = [k for k in after if fixes[k]["region"] not in allowed(rows, k)]
    strict = sum(fixes[k]["region"] == rows[k]["region"] for k in after)
    share = 1 - len(wrong) / max(1, len(after))
    check.that(bool(after) and share >= LEAST_RIGHT,
               f"right region in {share:.1%} of {len(after)} frames from the first fix on (without slack {strict})")
    for k in wrong:
        print(f"          {rows[k]['frame']}: {fixes[k]['region']}, in truth {rows[k]['region']}")
    check.that(bool(fixes) and fixes[-1]["region"] == DESTINATION, "the walk ends where it should")


def check_arrival(check, lines, rows):
    said = [line["frame"] for line in lines if line["type"] == "cue" and line["kind"] == "arrived"]
    there = [rows[frame]["region"] for frame in said]
    check.that(len(said) == 1 and there == [DESTINATION],
               f"arrival is announced once, in the destination (frames {[f + 1 for f in said]}, in truth {there})")
    spoken = [line["frame"] for line in lines if line["type"] == "utterance"]
    check.that(bool(spoken) and spoken[0] < LATEST_FIRST_FIX, "the first instruction is spoken at the start of the walk")


def check_detections(check, lines, rows, known):
    """No frame may name a trained landmark, or read a landmark's words, that the drawing does not have in view."""
    false = []
    for line in lines:
        if line["type"] != "detection":
            continue
        row = rows[line["frame"]]
        in_view = {name for name, share in row["visible"].items() if share >= BARELY_IN_VIEW}
        if line["template"] and line["template"] not in {known[name]["template"] for name in in_view}:
            false.append((row["frame"], line["template"]))
        words = {entry["text"] for entry in known.values() if entry["text"]}
        if line["text"] in words and line["text"] not in {known[name]["text"] for name in in_view}:
            false.append((row["frame"], line["text"]))
    check.that(not false, f"no frame names a landmark that is not in view: {false or 'none'}")
    check.that(any(line["type"] == "detection" and line["text"] == "105" for line in lines),
               "the number of the library's door is read")


def check_recognition(check, output, rows, known):
    """Most landmarks that are whole, near and not too much aside are named."""
    found = {}
    for line in (json.loads(text) for text in output.splitlines()):
        found[Path(line["file"]).name] = {entry["template"] for entry in line["detections"]}
    shown, named = 0, 0
    for row in rows:
        for name in row["near"]:
            shown += 1
            if known[name]["template"] in found[row["frame"]]:
                named += 1
            else:
                print(f"          {row['frame']}: {name} is near and not named")
    check.that(named >= LEAST_NAMED * shown > 0, f"{named} of {shown} landmarks near the walker are named")


def main(cli, top, work):
    example, library = top / FOLDER, work / "library.gpkg"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    run("bash", example / "train.sh", library, env=dict(os.environ, FAROL_CLI=str(cli)))
    check, rows, known = Check(), truth(example), landmarks(example)
    trained = {entry["template"] for entry in json.loads(run(cli, "library", "list", library, "--json"))["templates"]}
    check.that(trained == {view[1] for view in training(example)}, f"{len(trained)} templates are trained")
    walk = [cli, "run", "--map", example / "drawn.gpkg", "--library", library, "--source", example / "frames", "--fps", "1",
            "--to", DESTINATION, "--json-lines"]
    output = run(*walk)
    lines = [json.loads(text) for text in output.splitlines()]
    check_fixes(check, lines, rows)
    check_arrival(check, lines, rows)
    check_detections(check, lines, rows, known)
    check_recognition(check, run(cli, "recognise", library, example / "frames", "--json-lines"), rows, known)
    check.that(run(*walk) == output, "the same walk again gives the same lines")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()))
