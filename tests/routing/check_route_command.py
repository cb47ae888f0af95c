#!/usr/bin/env python3
"""farol-cli route as scripts use it: JSON, words, exit codes, what is avoided and why there is no way.

  check_route_command.py FAROL_CLI WORK_FOLDER
"""
import json
import subprocess
import sys
from pathlib import Path



CRS = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32629"}}
EAST, NORTH = 500000.0, 4500000.0  # of the lower left corner


def placed(points):
    return [[EAST + x, NORTH + y] for x, y in points]


def square(x, y, width=4.0, height=4.0):
    corners = [[x, y], [x + width, y], [x + width, y + height], [x, y + height], [x, y]]
    return {"type": "Polygon", "coordinates": [placed(corners)]}


def region(name, level, shape, **more):
    return {"type": "Feature", "geometry": shape,
            "properties": {"region_id": name, "name": name, "level": level, "kind": "room", **more}}


def access(name, kind, level, a, b, points, **more):
    line = placed(points)
    shape = {"type": "LineString", "coordinates": line} if len(line) > 1 else {"type": "Point", "coordinates": line[0]}
    return {"type": "Feature", "geometry": shape,
            "properties": {"access_id": name, "kind": kind, "level": level, "region_a": a, "region_b": b, **more}}


def write_map(folder):
    """Hall, Office and Store below, Attic over the Hall by stairs, Shed joined to nothing."""
    regions = [region("Hall", 0, square(0, 0, 12, 4), kind="corridor"), region("Office", 0, square(8, 4)),
               region("Store", 0, square(0, 4)), region("Attic", 1, square(0, 0)), region("Shed", 0, square(40, 0))]
    accesses = [access("d1", "door", 0, "Hall", "Store", [[1, 4], [2, 4]], width_m=1.0),
                access("d2", "door", 0, "Hall", "Office", [[9, 4], [9.7, 4]], width_m=0.7),
                access("s1", "stairs", 0, "Hall", "Attic", [[2, 2]], steps=17)]
    for name, features in (("regions", regions), ("accesses", accesses)):
        (folder / f"{name}.geojson").write_text(
            json.dumps({"type": "FeatureCollection", "name": name, "crs": CRS, "features": features}))
    return folder


class Check:
    def __init__(self, cli):
        self.cli, self.failed = cli, 0

    def run(self, *words):
        return subprocess.run([self.cli, *map(str, words)], capture_output=True, text=True, check=False)

    def that(self, holds, text, done=None):
        print(("  ok    " if holds else "  FAILS ") + text)
        if not holds:
            self.failed += 1
            if done is not None:
                print(f"exit {done.returncode}\n{done.stdout}{done.stderr}")


def check_found(check, building):
    done = check.run("route", building, "--from", "Store", "--to", "Office", "--json")
    check.that(done.returncode == 0, "a way is found", done)
    route = json.loads(done.stdout)
    check.that(list(route)[0] == "found" and route["found"] is True, "found comes first")
    check.that(route["regions"] == ["Store", "Hall", "Office"] and route["accesses"] == ["d1", "d2"],
               "regions and accesses in order", done)
    check.that(all(len(point) == 3 for point in route["path"]) and route["path"][0][2] == 0, "path of x, y, level")
    length = sum(((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5 for a, b in zip(route["path"], route["path"][1:]))
    check.that(abs(length - route["length_m"]) < 0.01, "the length is the path's")
    check.that(abs(route["seconds"] - (length / 0.8 + 8.0)) < 0.01, "seconds: walking and two doors")
    kinds = [each["kind"] for each in route["manoeuvres"]]
    check.that(kinds == ["start", "door", "door", "arrive"], f"manoeuvres {kinds}")
    last = route["manoeuvres"][2]
    check.that((last.get("side"), last.get("number")) == ("left", 1), "the office is the first door on the left", done)
    words = check.run("route", building, "--from", "Store", "--to", "Office")
    check.that("the first on the left" in words.stdout and words.returncode == 0, "the same in words", words)
    greedy = json.loads(check.run("route", building, "--from", "Store", "--to", "Office", "--planner", "greedy",
                                  "--json").stdout)
    check.that(greedy["planner"] == "greedy" and greedy["length_m"] >= route["length_m"] - 1e-6, "the greedy planner")
    spot = json.loads(check.run("route", building, "--from", f"{EAST + 1},{NORTH + 1},0", "--to",
                                f"{EAST + 11},{NORTH + 3},0", "--json").stdout)
    check.that(spot["regions"] == ["Hall"] and abs(spot["length_m"] - 104 ** 0.5) < 0.01, "from x,y,level to another")
    up = json.loads(check.run("route", building, "--from", "Store", "--to", "Attic", "--json").stdout)
    stairs = up["manoeuvres"][2]
    check.that((stairs["kind"], stairs["vertical"], stairs["target_level"], stairs["steps"]) == ("stairs", "up", 1, 17),
               "stairs up with their steps", None)


def check_refused(check, building, folder):
    for avoided, goal, words in (("stairs", "Attic", "Attic can be reached by stairs only, which are to be avoided"),
                                 ("narrow-doors", "Office",
                                  "Office can be reached by a narrow door only, which is to be avoided")):
        done = check.run("route", building, "--from", "Store", "--to", goal, "--avoid", avoided, "--json")
        check.that(done.returncode == 1, f"no way without {avoided}: exit 1", done)
        route = json.loads(done.stdout)
        check.that(route["found"] is False and route["reason"] == words and route["regions"] == [] and
                   route["length_m"] is None, "the reason in words", done)
        check.that(words in done.stderr, "and on stderr")
    done = check.run("route", building, "--from", "Store", "--to", "Office", "--avoid",
                     "stairs,elevator,escalator,moving-walkway,ramp,restricted", "--json")
    check.that(done.returncode == 0, "all other things to avoid are known", done)
    done = check.run("route", building, "--from", "Store", "--to", "Shed")
    check.that(done.returncode == 1 and "no way at all" in done.stderr and done.stdout == "", "no way at all", done)
    done = check.run("route", building, "--from", "Store", "--to", "Office", "--avoid", "puddles")
    check.that(done.returncode == 2 and "puddles" in done.stderr and "narrow-doors" in done.stderr,
               "what cannot be avoided is named with what can", done)
    done = check.run("route", building, "--from", "Store", "--to", "Offise")
    check.that(done.returncode == 1 and "Office" in done.stderr, "near spellings are told", done)
    done = check.run("route", building, "--from", "Store", "--to", "100,100,0")
    check.that(done.returncode == 1 and "no region" in done.stderr, "a point in no region", done)
    done = check.run("route", building, "--from", "Store")
    check.that(done.returncode == 2, "without --to: wrong usage", done)
    done = check.run("route", folder / "none.gpkg", "--from", "Store", "--to", "Office", "--json")
    check.that(done.returncode == 1 and done.stdout == "" and "none.gpkg" in done.stderr, "no such map", done)
    done = check.run("route", "--help")
    check.that(done.returncode == 0 and "Example" in done.stdout, "help with an example")


def main():
    cli, folder = sys.argv[1], Path(sys.argv[2])
    source = folder / "source"
    source.mkdir(parents=True, exist_ok=True)
    check = Check(cli)
    building = folder / "route.gpkg"
    done = check.run("map", "import", write_map(source), building)
    check.that(done.returncode == 0, "the drawn map is imported", done)
    if done.returncode == 0:
        check_found(check, building)
        check_refused(check, building, folder)
    sys.exit(1 if check.failed else 0)


if __name__ == "__main__":
    main()
