#!/usr/bin/env python3
"""Damages maps of every format in every way a disk, a network or a stranger can, and imports each.

  mutate_maps.py IMPORT_CHECK REPOSITORY WORK_FOLDER [COUNT [SEED]]

Real maps from FAROL_DATA, where it is there, are damaged beside the small ones of the repository. Each answer must be
an error in words or a building that can be saved and read again, within three minutes (sanitizers on a busy machine);
nothing may crash. Cases that failed stay in WORK_FOLDER/failed-NUMBER.
"""
import io
import json
import os
import random
import re
import selectors
import shutil
import subprocess
import sys
import time
import zipfile
from collections import Counter
from pathlib import Path

LONGEST_S = 180
IMDF = {
    "manifest.json": '{"version":"1.0.0","created":"2026-01-01T00:00:00Z","language":"en"}',
    "venue.geojson": '{"type":"FeatureCollection","features":[{"type":"Feature","id":"v","feature_type":"venue",'
                     '"geometry":null,"properties":{"name":{"en":"House"}}}]}',
    "level.geojson": '{"type":"FeatureCollection","features":[{"type":"Feature","id":"l","feature_type":"level",'
                     '"geometry":null,"properties":{"ordinal":0,"name":{"en":"Ground"},"short_name":{"en":"0"}}}]}',
    "unit.geojson": '{"type":"FeatureCollection","features":['
                    '{"type":"Feature","id":"a","feature_type":"unit","properties":{"category":"office","level_id":"l",'
                    '"name":{"en":"Office"}},"geometry":{"type":"Polygon","coordinates":[[[-8,37],[-7.9999,37],'
                    '[-7.9999,37.0001],[-8,37.0001],[-8,37]]]}},'
                    '{"type":"Feature","id":"b","feature_type":"unit","properties":{"category":"stairs","level_id":"l"},'
                    '"geometry":{"type":"Polygon","coordinates":[[[-7.9999,37],[-7.9998,37],[-7.9998,37.0001],'
                    '[-7.9999,37.0001],[-7.9999,37]]]}}]}',
    "opening.geojson": '{"type":"FeatureCollection","features":[{"type":"Feature","id":"d","feature_type":"opening",'
                       '"properties":{"category":"pedestrian","level_id":"l","door":{"type":"sliding"}},'
                       '"geometry":{"type":"LineString","coordinates":[[-7.9999,37.00002],[-7.9999,37.00003]]}}]}',
    "relationship.geojson": '{"type":"FeatureCollection","features":[{"type":"Feature","id":"r","feature_type":'
                            '"relationship","geometry":null,"properties":{"category":"stairs","direction":"directed",'
                            '"origin":{"id":"a","feature_type":"unit"},"intermediary":[{"id":"d"}],'
                            '"destination":{"id":"b","feature_type":"unit"}}}]}',
}


def hulop():
    features = []
    for name, x, floor in (("A", 0, 1), ("B", 1, 1), ("C", 2, 2)):
        features.append({"type": "Feature", "geometry": {"type": "Point", "coordinates": [-9.2 + x * 1e-4, 38.7]},
                         "properties": {"node_id": name, "floor": floor, "link1_id": "AB"}})
    for name, ends, kind in (("AB", "AB", "1"), ("BC", "BC", "5")):
        features.append({"type": "Feature", "geometry": None,
                         "properties": {"link_id": name, "start_id": ends[0], "end_id": ends[1], "route_type": kind,
                                        "direction": "2"}})
    features.append({"type": "Feature", "geometry": {"type": "Point", "coordinates": [-9.2, 38.70005]},
                     "properties": {"facil_id": "F", "name_en": "Shop", "ent1_node": "A", "ent1_d": "1"}})
    return json.dumps({"type": "FeatureCollection", "features": features})


class Map:
    """A map in memory: the bytes of its files by name; one file, a folder, or a zip of it."""

    def __init__(self, files, shape):
        self.files, self.shape = files, shape

    @staticmethod
    def of(path, shape=None):
        if path.is_dir():
            files = {str(f.relative_to(path)): f.read_bytes() for f in sorted(path.rglob("*")) if f.is_file()}
            return Map(files, shape or "folder")
        return Map({path.name: path.read_bytes()}, "file")

    def zipped(self):
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in self.files.items():
                archive.writestr(zipfile.ZipInfo(name), content)
        return packed.getvalue()

    def written(self, folder):
        if self.shape == "zip":
            (folder / "map.zip").write_bytes(self.zipped())
            return folder / "map.zip"
        for name, content in self.files.items():
            target = folder / "map" / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
        return folder / "map" / next(iter(self.files)) if self.shape == "file" else folder / "map"


def seeds(check, repository, work):
    made = work / "seeds"
    made.mkdir()
    fixtures = repository / "tests/data/import"
    subprocess.run([check, "--seeds", fixtures / "sit_house.osm", made], check=True)
    maps = {path.name: Map.of(path) for path in [*sorted(fixtures.iterdir()), *sorted(made.iterdir())]}
    maps["imdf_house"] = Map({name: text.encode() for name, text in IMDF.items()}, "folder")
    maps["hulop.geojson"] = Map({"hulop.geojson": hulop().encode()}, "file")
    real = Path(os.environ.get("FAROL_DATA", "")) / "maps"
    if os.environ.get("FAROL_DATA") and real.is_dir():
        for path in [*sorted((real / "cambridge_imdf").iterdir()), real / "westport_house_wrld",
                     real / "indoorgml_fjk", real / "hulop_sample", real / "shp_edge_cases_synthetic/tokyo_station",
                     *sorted((real / "berlin_hbf_osm_sit").glob("berlin*"))]:
            maps["real/" + path.name] = Map.of(path)
    for name in [n for n, m in maps.items() if m.shape == "folder"]:
        maps[name + ".zip"] = Map(maps[name].files, "zip")
    return maps


NUMBERS = [b"NaN", b"Infinity", b"-Infinity", b"1e308", b"-1e308", b"1e400", b"9223372036854775808", b"0", b"-0.0",
           b"1e-320", b"99999999", b"-1", b"4294967296", b'"x"', b"null", b"1.5.2", b"0x7f", b"1e15"]
DOUBLES = [bytes.fromhex(h) for h in ("000000000000f87f", "000000000000f07f", "000000000000f0ff", "a0c8eb85f3cce17f",
                                      "ffffffffffffffff", "0100000000000000", "000000000000f041")]
LAUGHS = ('<!DOCTYPE x [<!ENTITY a0 "ha">' + "".join(
    f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, 12)) + "]>")


def cut(chance, data, _):
    return data[:chance.randrange(len(data))]


def flip(chance, data, _):
    data = bytearray(data)
    for _ in range(chance.choice([1, 1, 4, 16, 64, 512])):
        data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    return bytes(data)


def splice(chance, data, other):
    start, end = sorted(chance.randrange(len(data)) for _ in range(2))
    low, high = sorted(chance.randrange(len(other) + 1) for _ in range(2))
    return data[:start] + other[low:high] + data[end:]


def repeat(chance, data, _):
    start = chance.randrange(len(data))
    piece = data[start:start + chance.choice([3, 50, 2000])]
    return data[:start] + piece * chance.choice([2, 10, 200]) + data[start:]


def drop(chance, data, _):
    start = chance.randrange(len(data))
    return data[:start] + data[start + chance.choice([1, 10, 300, 5000]):]


def numbers(chance, data, _):
    """Some numbers become others; in binary files any eight bytes become a number that is none."""
    found = list(re.finditer(rb"-?\d+\.?\d*", data)) if b"\0" not in data[:2000] else []
    if not found:
        data = bytearray(data)
        for _ in range(chance.choice([1, 5, 30])):
            at = chance.randrange(max(1, len(data) - 8))
            data[at:at + 8] = chance.choice(DOUBLES)
        return bytes(data)
    for match in sorted(chance.sample(found, min(len(found), chance.choice([1, 3, 30]))),
                        key=lambda m: -m.start()):
        data = data[:match.start()] + chance.choice(NUMBERS) + data[match.end():]
    return data


def short_ring(chance, data, _):
    text = re.sub(rb"\[\s*\[\s*(\[[^\[\]]*\])[^a-z{}]*\]\s*\]", rb"[[\1]]", data, count=chance.choice([1, 2, 1000]))
    text = re.sub(rb"(<gml:pos[^>]*>[^<]*</gml:pos>\s*){2,}", rb"\1", text, count=chance.choice([1, 1000]))
    return re.sub(rb'(<nd [^>]*>\s*){2,}', rb"\1", text, count=chance.choice([1, 1000]))


def laughs(_, data, __):
    start = re.search(rb"<[A-Za-z]", data)
    if not start:
        return LAUGHS.encode() + data
    text = data[:start.start()] + LAUGHS.encode() + data[start.start():]
    return re.sub(rb'v="[^"]*"|>[^<>\s]+<', lambda m: b'v="&a11;"' if m[0][:1] == b"v" else b">&a11;<", text, count=3)


def deep(chance, data, _):
    start = chance.randrange(len(data))
    depth = chance.choice([100, 3000, 200000])
    opening = b"<a>" if data[:1] == b"<" else chance.choice([b"[", b'{"a":'])
    return data[:start] + opening * depth + data[start:]


def long_text(chance, data, _):
    match = chance.choice(list(re.finditer(rb'"[^"]*"', data)) or [None])
    text = chance.choice([b"x", b"\xff\xfe", b"\\ud800", b"&amp;", b"%s%n", "ç".encode()]) * chance.choice([1, 1000, 300000])
    return data if match is None else data[:match.start() + 1] + text + data[match.end() - 1:]


WAYS = [cut, flip, flip, splice, repeat, drop, numbers, numbers, short_ring, laughs, deep, long_text]


def damaged(chance, maps, number):
    """(what was done, the map, or bytes of one file)"""
    name = sorted(maps)[number % len(maps)]
    victim = Map(dict(maps[name].files), maps[name].shape)
    other = maps[chance.choice(sorted(maps))]
    other_bytes = other.files[chance.choice(sorted(other.files))]
    kind = chance.random()
    file = chance.choice([f for f in sorted(victim.files) if victim.files[f]] or sorted(victim.files))
    if kind < 0.03:
        victim.files[file] = b""
        return f"{name}: {file} empty", victim
    if kind < 0.07:
        victim.files[file] = other_bytes
        return f"{name}: {file} is of another kind", victim
    if kind < 0.10 and victim.shape != "file":
        del victim.files[file]
        return f"{name}: {file} missing", victim
    if victim.shape == "zip" and kind < 0.5:
        if kind < 0.2:
            evil = chance.choice(["../evil.geojson", "a/../../b.json", "/etc/x.geojson", "..\\x.json", "a\0b"])
            victim.files[evil] = victim.files[file]
            return f"{name}: a member called {evil!r}", victim
        if kind < 0.25:
            victim.files["bomb.geojson"] = b'{"type":"FeatureCollection","features":[' + b" " * (64 << 20)
            return f"{name}: a bomb", victim
        way = chance.choice([cut, flip, splice, repeat, drop])
        return f"{name}: zip, {way.__name__}", Map({"map.zip": way(chance, victim.zipped(), other_bytes)}, "file")
    ways = [chance.choice(WAYS) for _ in range(chance.choice([1, 1, 2]))]
    for way in ways:
        if victim.files[file]:
            victim.files[file] = way(chance, victim.files[file], other_bytes or b"x")
    return f"{name}: {file}, {', '.join(way.__name__ for way in ways)}", victim


def whole_cases():
    """What no damage to a real file makes."""
    square = "[[[{0},0],[{1},0],[{1},1],[{0},1],[{0},0]]]"
    def rooms(count, properties, shape=square):
        return json.dumps({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:32629"}},
                           "features": [{"type": "Feature", "properties": properties(i), "geometry": {
                               "type": "Polygon", "coordinates": json.loads(shape.format(2 * i, 2 * i + 2))}}
                                        for i in range(count)]}).encode()
    def one(name, content):
        return Map({name: content}, "file")
    osm = ("<osm version='0.6'>" + "".join(f"<node id='{i + 1}' lat='{38 + y * 1e-4}' lon='{-9 + x * 1e-4}'/>"
                                           for i, (x, y) in enumerate([(0, 0), (1, 0), (1, 1), (0, 1)])) +
           "<way id='1'><nd ref='1'/><nd ref='2'/><nd ref='3'/><nd ref='4'/><nd ref='1'/>"
           "<tag k='indoor' v='room'/><tag k='level' v='{}'/></way></osm>")
    yield "10,000 levels in a table", one("rooms.geojson", rooms(10000, lambda i: {"id": f"r{i}", "level": i}))
    yield "10,000 levels by repeat_on", one("map.osm", osm.format("0-10000").encode())
    yield "10,000 levels by a list", one("map.osm", osm.format(";".join(map(str, range(10000)))).encode())
    yield "levels up to 1e300", one("map.osm", osm.format("0-1e300").encode())
    yield "20,000 rooms on one spot", one("rooms.geojson", rooms(20000, lambda i: {"id": f"r{i}", "level": 0},
                                                                  "[[[0,0],[5,0],[5,5],[0,5],[0,0]]]"))
    ring = ",".join(f"[{i % 2 * 100},{i / 10}]" for i in range(20000))
    yield "a ring that crosses itself 10,000 times", one("rooms.geojson", rooms(1, lambda i: {"level": 0},
                                                                                 f"[[{ring},[0,0]]]"))
    yield "5,000 columns", one("rooms.geojson", rooms(3, lambda i: {f"c{i}_{j}": j for j in range(5000)}))
    yield "a name of 50 MB", one("rooms.geojson", rooms(2, lambda i: {"name": "x" * (25 << 20)}))
    yield "nothing but a folder", Map({"readme.txt": b"hello"}, "folder")


class Checker:
    def __init__(self, program, out):
        self.words = [program, out]
        self.process = None

    def answer(self, path):
        if self.process is None or self.process.poll() is not None:
            self.process = subprocess.Popen(self.words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.process.stdin.write(f"{path}\n")
        self.process.stdin.flush()
        with selectors.DefaultSelector() as waiting:
            waiting.register(self.process.stdout, selectors.EVENT_READ)
            if not waiting.select(LONGEST_S):
                self.process.kill()
                self.process.wait()
                return {"fault": f"no answer within {LONGEST_S} s"}
        line = self.process.stdout.readline()
        if not line:
            return {"fault": f"the program ended with code {self.process.wait()}"}
        return json.loads(line)

    def close(self):
        if self.process and self.process.poll() is None:
            self.process.stdin.close()
            return self.process.wait()
        return 0


def main():
    check, repository, work = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 2000
    seed = int(sys.argv[5]) if len(sys.argv) > 5 else 1
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    maps = seeds(check.resolve(), repository, work)
    checker = Checker(check.resolve(), work / "out.gpkg")
    told, failed, slowest, peak = Counter(), [], (0.0, ""), 0
    whole = list(whole_cases())
    for number in range(count + len(whole)):
        chance = random.Random(seed * 1000003 + number)
        what, case = whole[number - count] if number >= count else damaged(chance, maps, number)
        folder = work / "case"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        start = time.monotonic()
        try:
            path = case.written(folder)
        except (OSError, ValueError):  # a name that no file can have
            told["not written"] += 1
            continue
        answer = checker.answer(path)
        seconds = time.monotonic() - start
        slowest = max(slowest, (seconds, what))
        peak = max(peak, answer.get("peak_mb", 0))
        if answer.get("fault"):
            failed.append(what)
            shutil.copytree(folder, work / f"failed-{number}")
            print(f"case {number} ({what}): {answer['fault']}", flush=True)
        told["building" if answer.get("ok") else "error"] += 1
    code = checker.close()
    print(f"{count} damaged maps of {len(maps)} and {len(whole)} hostile ones, seed {seed}: {told['building']} became "
          f"buildings, {told['error']} errors, {len(failed)} faults; slowest {slowest[0]:.1f} s ({slowest[1]}), "
          f"peak {peak} MB")
    sys.exit(1 if failed or code else 0)


if __name__ == "__main__":
    main()
