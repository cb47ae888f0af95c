#!/usr/bin/env python3
"""A walk in the demo building as a newcomer starts it: what is printed tells one story, and the same one again.

  check_simulated_walk.py FAROL_CLI REPOSITORY

Without pictures, so that it takes seconds. Checks the transcript against the result of the same walk, that the same
seed gives the same bytes, and that a place which is not on the map is refused by name.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

from check_corridor_walk import Check

KEYS = {"arrived", "announced_arrival", "seconds", "metres", "shortest_m", "wrong_region_said", "cues", "reason"}
FROM, TO = "0-foyer", "1-west-room-1"


def main():
    cli, repository = sys.argv[1], Path(sys.argv[2])

    def simulate(*words):
        command = [cli, "simulate", repository / "resources/demo/demo.gpkg", "--obey", "--no-vision", "--json", *words]
        return subprocess.run([str(w) for w in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=False, timeout=120)

    check = Check()
    way = ("--from", FROM, "--to", TO)
    told = simulate(*way, "--seed", 0, "--transcript")
    *lines, last = told.stdout.splitlines()
    result = json.loads(last)
    check.that(told.returncode == 0 and KEYS <= result.keys(), "the last line is the result, with all its keys")

    places = [m for m in (re.match(r" *([\d.]+) s  in (\S+) at .*; taken for (\S+) \(([\d.]+)\)", line) for line in lines) if m]
    said = [m for m in (re.match(r' *([\d.]+) s    "(.+)"$', line) for line in lines) if m]
    seen = [line.strip() for line in lines if line.lstrip().startswith("sees ")]
    check.that(places and places[0][2] == FROM, f"it begins in {FROM}")
    check.that(bool(seen), "it tells what is recognised")
    check.that(any(re.match(r"sees \w+.*, \d+ degrees (left|right) \(0\.\d\d\)$", line) for line in seen),
               "with its direction and its score")
    check.that(said and said[0][2].startswith("Destination: Office 1.01."), "the first words are the destination")
    times = [float(m[1]) for m in places]
    check.that(times == sorted(times), "in the order of time")
    check.that(times[-1] <= result["seconds"], "none later than the end")
    arrived = [m for m in said if "arrived" in m[2] or "there already" in m[2]]
    check.that(result["announced_arrival"] == bool(arrived), "the arrival is in the transcript if it was announced")
    check.that(result["arrived"] == (places[-1][2] == TO and result["announced_arrival"]),
               f"who arrived is in {TO} at the end")
    check.that(result["metres"] >= 0.8 * result["shortest_m"] or not result["arrived"], "nobody flies")
    check.that(len(said) <= result["cues"], "no more is said than was told")

    check.that(simulate(*way, "--seed", 0, "--transcript").stdout == told.stdout, "the same seed, the same bytes")
    check.that(simulate(*way, "--seed", 1, "--transcript").stdout != told.stdout, "another seed, another walk")
    check.that(simulate(*way, "--seed", 0).stdout.splitlines() == [last], "without --transcript the result alone")

    lost = simulate("--from", "attic", "--to", TO)
    check.that(lost.returncode == 2 and "attic" in lost.stderr and not lost.stdout, "an unknown place is refused by name")
    sys.exit(1 if check.failed else 0)


if __name__ == "__main__":
    main()
