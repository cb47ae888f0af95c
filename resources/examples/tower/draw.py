#!/usr/bin/python3
"""Makes tower.gpkg from tower.txt. For maintainers; ./dev does not run it. Needs Debian's python3-gdal.
Usage: draw.py OUT.gpkg"""
import sys
from pathlib import Path

from osgeo import ogr, osr

STOREY = 4.0  # metres from floor to floor


def plan():
    """The lines of tower.txt as lists of words."""
    for line in (Path(__file__).parent / "tower.txt").read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            yield line.split()


def levels_of(word, every):
    return every if word == "*" else [float(one) for one in word.split(",")]


def region_id(level, name):
    return f"{level:g}-{name}"


class Writer:
    def __init__(self, path):
        Path(path).unlink(missing_ok=True)
        self.data = ogr.GetDriverByName("GPKG").CreateDataSource(path)
        self.crs = osr.SpatialReference()
        self.crs.ImportFromWkt('LOCAL_CS["tower example, metres",UNIT["metre",1]]')
        self.layers = {}

    def layer(self, name, kind, fields):
        options = ["SPATIAL_INDEX=NO"] if kind != ogr.wkbNone else []
        layer = self.data.CreateLayer(name, None if kind == ogr.wkbNone else self.crs, kind, options)
        types = {"s": ogr.OFTString, "r": ogr.OFTReal, "i": ogr.OFTInteger, "b": ogr.OFTInteger}
        for field in fields.split():
            kind_of, label = field.split(":")
            definition = ogr.FieldDefn(label, types[kind_of])
            if kind_of == "b":
                definition.SetSubType(ogr.OFSTBoolean)
            layer.CreateField(definition)
        self.layers[name] = layer

    def add(self, layer, wkt=None, **values):
        feature = ogr.Feature(self.layers[layer].GetLayerDefn())
        if wkt:
            feature.SetGeometryDirectly(ogr.CreateGeometryFromWkt(wkt))
        for key, value in values.items():
            if value not in ("", None):
                feature.SetField(key, value)
        self.layers[layer].CreateFeature(feature)


def layers(out):
    out.layer("levels", ogr.wkbNone, "r:level s:name s:ref r:elevation_m r:height_m")
    out.layer("regions", ogr.wkbPolygon, "s:region_id r:level s:name s:ref s:kind b:restricted")
    out.layer("accesses", ogr.wkbLineString, "s:access_id s:kind r:level s:region_a s:region_b s:shaft s:oneway "
              "s:door_type b:automatic r:width_m i:steps b:closed")
    out.layer("landmarks", ogr.wkbPoint, "s:landmark_id s:kind s:template s:text s:region_id r:level r:heading_deg "
              "r:height_m r:width_m r:tall_m")
    out.layer("farol", ogr.wkbNone, "s:key s:value")


def line(words):
    ax, ay, bx, by = (float(word) for word in words)
    width = ((ax - bx) ** 2 + (ay - by) ** 2) ** 0.5
    return f"LINESTRING({ax} {ay}, {bx} {by})", width


def draw(out):
    rows = list(plan())
    every = [float(words[1]) for words in rows if words[0] == "level"]
    refs = {float(words[1]): words[2] for words in rows if words[0] == "level"}
    boxes = {}
    for words in rows:
        if words[0] == "level":
            level = float(words[1])
            out.add("levels", level=level, ref=words[2], name=" ".join(words[3:]), elevation_m=STOREY * level, height_m=3.0)
        elif words[0] == "region":
            west, south, east, north = (float(word) for word in words[4:8])
            ring = [(west, south), (east, south), (east, north), (west, north), (west, south)]
            for level in levels_of(words[2], every):
                boxes[level, words[1]] = (west, south, east, north)
                out.add("regions", "POLYGON((" + ", ".join(f"{x} {y}" for x, y in ring) + "))", restricted=0,
                        region_id=region_id(level, words[1]), level=level, kind=words[3],
                        name=f"{' '.join(words[8:])} on floor {refs[level]}")
        elif words[0] == "access":
            wkt, width = line(words[5:9])
            for level in levels_of(words[4], every):
                out.add("accesses", wkt, access_id=region_id(level, f"{words[2]}-{words[3]}"), kind=words[1], level=level,
                        region_a=region_id(level, words[2]), region_b=region_id(level, words[3]), width_m=width, closed=0,
                        door_type="hinged" if words[1] == "door" else "")
        elif words[0] == "shaft":
            wkt, width = line(words[3:7])
            flights = levels_of(words[7], every)
            for low, high in zip(flights, flights[1:]):
                out.add("accesses", wkt, access_id=region_id(low, f"{words[2]}-up"), kind=words[1], level=low,
                        region_a=region_id(low, words[2]), region_b=region_id(high, words[2]), shaft=words[2],
                        width_m=width, closed=0)
        elif words[0] == "text":
            level = float(words[1])
            out.add("landmarks", f"POINT({words[3]} {words[4]})", landmark_id=f"{level:g}-{words[2]}-{words[6]}", kind="text",
                    text=words[6], region_id=region_id(level, words[2]), level=level, heading_deg=float(words[5]), height_m=1.6)
        elif words[0] == "spot":
            level, (x, y) = float(words[2]), (float(value) for value in words[3].split(","))
            region = next(name for (on, name), (w, s, e, n) in boxes.items() if on == level and w <= x < e and s <= y < n)
            out.add("landmarks", f"POINT({x} {y})", landmark_id=words[1], kind="place", template=words[1],
                    region_id=region_id(level, region), level=level, height_m=1.4)
    for key, value in [("schema", "1"), ("title", "Tower"), ("languages", "en"),
                       ("crs_note", "A local plane in metres; drawn by eye")]:
        out.add("farol", key=key, value=value)


if __name__ == "__main__":
    ogr.UseExceptions()
    writer = Writer(sys.argv[1])
    writer.data.StartTransaction()
    layers(writer)
    draw(writer)
    writer.data.CommitTransaction()
