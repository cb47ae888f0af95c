#!/usr/bin/env python3
"""farol-cli map import, check, info and ambiguity as scripts use them: documents, exit codes, messages, files.

  check_map_commands.py FAROL_CLI REPOSITORY WORK_FOLDER
"""
import hashlib
import json
import os
import resource
import shutil
import sqlite3
import subprocess
import sys
from pathlib import Path

DONE, FAILED, USAGE = 0, 1, 2
INFO_KEYS = {"regions", "accesses", "accesses_joined", "landmarks", "levels", "components", "largest_component", "kinds",
             "crs", "extent_m", "unnamed_regions"}
SEVERITIES = {"error", "warning", "note"}


class Check:
    def __init__(self):
        self.failed = 0

    def that(self, holds, text):
        print(("  ok    " if holds else "  FAILS ") + text)
        self.failed += 0 if holds else 1


class Cli:
    def __init__(self, program):
        self.program = program

    def __call__(self, *words, largest_file=None):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))
        return subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, check=False,
                              preexec_fn=limit if largest_file else None)


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def document(check, done, what):
    """The one JSON document on standard output, and nothing else there."""
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError:
        check.that(False, f"{what}: one JSON document on standard output, not {done.stdout[:200]!r}")
        return {}


def check_findings(check, findings, what):
    sound = all(set(f) == {"severity", "rule", "message", "layer", "ids"} and f["severity"] in SEVERITIES and f["rule"]
                and len(f["message"]) > 10 and all(isinstance(i, str) for i in f["ids"]) for f in findings)
    check.that(sound, f"{what}: each finding has severity, rule, message, layer and ids")
    order = [["error", "warning", "note"].index(f["severity"]) for f in findings]
    check.that(order == sorted(order), f"{what}: errors first, notes last")


def check_import(check, cli, source, work):
    out = work / "house.gpkg"
    done = cli("map", "import", source, out)
    check.that(done.returncode == DONE and out.exists(), "import: exit 0 and a file")
    check.that("read as osm" in done.stdout and "regions" in done.stdout, "import: the sum on standard output")
    check.that("warning" in done.stderr, "import: findings on standard error")
    again = cli("map", "import", source, work / "again.gpkg", "--json")
    told = document(check, again, "import --json")
    check.that(told.get("format") == "osm" and set(told.get("map", {})) == INFO_KEYS, "import --json: format and map")
    check_findings(check, told.get("findings", []), "import --json")
    info = document(check, cli("map", "info", out, "--json"), "info")
    check.that(info == told.get("map"), "info says of the file what import said")
    twice = cli("map", "import", source, work / "again.gpkg", "--json")
    check.that(twice.stdout == again.stdout, "import --json: the same again")
    own = cli("map", "import", out, work / "copy.gpkg", "--json")
    check.that(own.returncode == DONE and document(check, own, "import of a building file").get("map") == info,
               "a building file is imported as it stands")
    return out


def check_info(check, cli, house):
    info = document(check, cli("map", "info", house, "--json"), "info --json")
    check.that(set(info) == INFO_KEYS, "info --json: the keys of the contract")
    levels = info.get("levels", [])
    check.that(all(set(l) == {"level", "ref", "regions", "accesses", "landmarks"} for l in levels), "info: levels")
    check.that(sum(l["regions"] for l in levels) == info["regions"], "info: the regions of the levels are all")
    check.that(len(info["extent_m"]) == 2 and info["crs"].startswith("EPSG:326"), "info: metres, in a UTM zone")
    text = cli("map", "info", house)
    check.that(text.returncode == DONE and f"{info['regions']} regions" in text.stdout, "info in words")


def check_check(check, cli, house, work):
    done = cli("map", "check", house, "--json")
    findings = document(check, done, "check --json").get("findings", [])
    check_findings(check, findings, "check --json")
    check.that(done.returncode == DONE, "check: warnings alone are exit 0")
    words = cli("map", "check", house)
    check.that("0 errors" in words.stdout and words.returncode == DONE, "check in words, with the sum")
    broken = work / "broken.gpkg"
    shutil.copy(house, broken)
    with sqlite3.connect(broken) as file:
        access = file.execute("SELECT access_id FROM accesses WHERE region_b IS NOT NULL ORDER BY 1").fetchone()[0]
        file.create_function("ST_IsEmpty", 1, lambda g: 0)
        for name in ("ST_MinX", "ST_MaxX", "ST_MinY", "ST_MaxY"):
            file.create_function(name, 1, lambda g: 0.0)
        file.execute("UPDATE accesses SET region_b = 'nowhere' WHERE access_id = ?", (access,))
    done = cli("map", "check", broken, "--json")
    errors = [f for f in document(check, done, "check").get("findings", []) if f["severity"] == "error"]
    check.that(done.returncode == FAILED, "check: exit 1 on an error")
    check.that(any(f["rule"] == "access-regions-exist" and f["ids"] == [access] for f in errors),
               "check: the error names the access")
    words = cli("map", "check", broken)
    check.that(words.returncode == FAILED and access in words.stdout, "check in words names it too")
    torn = work / "torn.gpkg"
    torn.write_bytes(house.read_bytes()[:5000])
    done = cli("map", "check", torn, "--json")
    told = document(check, done, "check of a torn file").get("findings", [])
    check.that(done.returncode == FAILED and [f["rule"] for f in told] == ["file-readable"], "check: a torn file is a finding")


def check_ambiguity(check, cli, house):
    done = cli("map", "ambiguity", house, "--json")
    told = document(check, done, "ambiguity --json")
    check.that(done.returncode == DONE and {"regions", "confused_pairs", "groups", "without_landmarks", "suggestions"}
               <= set(told), "ambiguity --json: the keys of the contract")
    check.that(all({"region", "pairs_told_apart"} <= set(s) for s in told.get("suggestions", [])), "ambiguity: suggestions")
    check.that(len(told.get("without_landmarks", [])) < told.get("regions", 0), "ambiguity: some regions have landmarks")
    check.that("cannot tell apart" in cli("map", "ambiguity", house).stdout, "ambiguity in words")


def check_failures(check, cli, source, house, work):
    before = digest(house)
    hello = work / "hello.txt"
    hello.write_text("Dear Sir")
    cases = [("no such file", ("map", "import", work / "none.osm", house), FAILED, "no such file"),
             ("no map", ("map", "import", hello, house), FAILED, "no indoor map"),
             ("the wrong format", ("map", "import", source, house, "--format", "indoorgml"), FAILED, "house"),
             ("an unknown format", ("map", "import", source, house, "--format", "dwg"), USAGE, "none of auto"),
             ("a profile that is not there", ("map", "import", hello, house, "--format", "geojson", "--profile",
                                              work / "p.json"), FAILED, "p.json"),
             ("no heights", ("map", "import", house, work / "z.gpkg", "--level-from", "z"), USAGE, "heights"),
             ("another kind of file as the target", ("map", "import", source, hello), FAILED, "hello.txt"),
             ("a device as the target", ("map", "import", source, "/dev/null"), USAGE, "ordinary file"),
             ("a folder that is not there", ("map", "import", source, work / "no" / "map.gpkg"), FAILED, "map.gpkg"),
             ("nothing", ("map",), USAGE, ""), ("half", ("map", "import", source), USAGE, ""),
             ("an unknown option", ("map", "info", house, "--colour"), USAGE, "")]
    for what, words, code, text in cases:
        done = cli(*words)
        check.that(done.returncode == code, f"{what}: exit {code}, was {done.returncode}")
        check.that(text in done.stderr and not done.stdout, f"{what}: said on standard error: {done.stderr.strip()[:150]}")
    for file in (hello, house):
        check.that(file.exists(), f"{file.name} is still there")
    check.that(digest(house) == before and hello.read_text() == "Dear Sir", "failed imports leave the files as they were")
    full = cli("map", "import", source, house, largest_file=20000)
    check.that(full.returncode == FAILED and "disk is full" in full.stderr and digest(house) == before,
               f"a full disk: {full.stderr.strip()[-120:]}")
    check.that(not [n for n in os.listdir(work) if ".saving-" in n], "nothing half-written is left")
    for words in (("map", "info"), ("map", "check"), ("map", "ambiguity")):
        done = cli(*words, hello)
        check.that(done.returncode == FAILED and "hello.txt" in done.stderr, f"{' '.join(words)} of no map: exit 1")
        check.that(cli(*words, work / "none.gpkg").returncode == FAILED, f"{' '.join(words)} of no file: exit 1")
    for words in (("map", "import"), ("map", "check"), ("map", "info"), ("map", "ambiguity")):
        done = cli(*words, "--help")
        check.that(done.returncode == DONE and "Example" in done.stdout, f"{' '.join(words)} --help has an example")


def main():
    cli, repository, work = Cli(Path(sys.argv[1]).resolve()), Path(sys.argv[2]), Path(sys.argv[3])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    check = Check()
    source = repository / "tests/data/import/sit_house.osm"
    house = check_import(check, cli, source, work)
    check_info(check, cli, house)
    check_check(check, cli, house, work)
    check_ambiguity(check, cli, house)
    check_failures(check, cli, source, house, work)
    sys.exit(1 if check.failed else 0)


if __name__ == "__main__":
    main()
