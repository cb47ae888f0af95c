#!/usr/bin/python3
"""Draws corridor.gpkg: the floor of the corridor walk, by eye from its photographs. For maintainers; ./dev does not
run it. Needs Debian's python3-gdal. Usage: draw.py OUT.gpkg

The floor is a rectangular loop walked counter-clockwise: leg-a east, leg-b north, leg-c west, leg-d south. Lengths
come from the size of doors in the pictures (steps of about 1.9 m between pictures) and are good to perhaps 20 %.
"Arc" is the distance walked from the south-west corner.
"""
import math
import sys

from osgeo import ogr, osr

WIDTH, HEIGHT, HALF = 12.4, 25.6, 0.9  # of the loop's centre line, and half the corridor's width, in metres
STEP, FIRST = 1.9, 2.0                 # between two photographs, and the arc of the first
DEPTH = 4.0                            # drawn depth of the side rooms, which nobody photographed
LEGS = {  # name: start corner, walking direction in degrees, length
    "leg-a": ((0.0, 0.0), 0.0, WIDTH),
    "leg-b": ((WIDTH, 0.0), 90.0, HEIGHT),
    "leg-c": ((WIDTH, HEIGHT), 180.0, WIDTH),
    "leg-d": ((0.0, HEIGHT), 270.0, HEIGHT),
}
NAMES = {"leg-a": "Corridor A", "leg-b": "Corridor B", "leg-c": "Corridor C", "leg-d": "Corridor D"}


def point(leg, along, right=0.0):
    """Map point of a leg: metres along its centre line, metres to the right of it."""
    (x, y), degrees, _ = LEGS[leg]
    c, s = round(math.cos(math.radians(degrees))), round(math.sin(math.radians(degrees)))
    return (round(x + c * along + s * right, 3), round(y + s * along - c * right, 3))


def facing(leg, side):
    """The way an object on that wall faces: 'right' wall looks left across the corridor, 'end' looks back."""
    turn = {"right": 90.0, "left": -90.0, "end": 180.0, "along": 0.0}[side]
    return (LEGS[leg][1] + turn) % 360.0


# Side doors as the pictures show them: leg, metres along, wall. Rooms behind them are drawn, not seen.
DOORS = [
    ("leg-a", 4.6, "right"), ("leg-a", 9.4, "right"), ("leg-a", 11.2, "right"),
    ("leg-b", 3.2, "left"), ("leg-b", 6.2, "right"), ("leg-b", 8.6, "right"), ("leg-b", 14.6, "right"),
    ("leg-b", 16.2, "right"), ("leg-b", 19.0, "right"),
    ("leg-c", 3.6, "right"), ("leg-c", 5.4, "right"), ("leg-c", 5.8, "left"), ("leg-c", 9.4, "right"),
    ("leg-d", 3.4, "right"), ("leg-d", 5.2, "left"), ("leg-d", 6.8, "right"), ("leg-d", 8.8, "right"),
    ("leg-d", 11.2, "right"), ("leg-d", 14.2, "right"), ("leg-d", 17.4, "right"), ("leg-d", 20.0, "right"),
    ("leg-d", 22.4, "left"), ("leg-d", 23.4, "right"),
]
# Doors at the end of a leg, met frontally: leg, metres to the right of the centre line, id of what lies behind, name.
END_DOORS = [
    ("leg-a", 0.0, "end-room", "Room at the end of corridor A", "room"),
    ("leg-b", 0.3, "washroom", "Washroom", "toilet"),
    ("leg-c", 0.1, "exit-stairs", "Exit", "outside"),
]
# Objects: id, kind, template, text, leg, along, wall, height of the centre, width, height of the object.
OBJECTS = [
    ("cabinet-a", "extinguisher", "extinguisher-cabinet", "", "leg-a", 8.6, "right", 1.3, 0.35, 0.85),
    ("cabinet-c", "extinguisher", "extinguisher-cabinet", "", "leg-c", 1.9, "right", 1.3, 0.35, 0.85),
    ("cabinet-d", "extinguisher", "extinguisher-cabinet", "", "leg-d", 16.6, "right", 1.3, 0.35, 0.85),
    ("board-a-1", "picture", "", "", "leg-a", 6.6, "right", 1.6, 0.9, 1.2),
    ("board-a-2", "picture", "", "", "leg-a", 10.2, "right", 1.6, 0.9, 1.2),
    ("board-b-1", "picture", "", "", "leg-b", 2.2, "left", 1.6, 0.9, 1.2),
    ("board-b-2", "picture", "", "", "leg-b", 7.0, "right", 1.6, 0.9, 1.2),
    ("board-b-3", "picture", "", "", "leg-b", 13.2, "right", 1.6, 0.9, 1.2),
    ("board-b-4", "picture", "", "", "leg-b", 20.4, "right", 1.6, 0.9, 1.2),
    ("panel-b", "locker", "", "", "leg-b", 13.6, "left", 1.4, 0.6, 1.2),
    ("plan-c", "sign", "evacuation-plan", "", "leg-c", 11.6, "right", 1.6, 0.35, 0.5),
    ("exit-sign-c", "exit_sign", "", "SORTIE", "leg-c", 13.2, "end", 2.3, 0.35, 0.18),
    ("exit-sign-d", "exit_sign", "", "SORTIE", "leg-d", 26.4, "end", 2.4, 0.35, 0.18),
    ("fountain-d", "fountain", "fountain", "", "leg-d", 2.2, "right", 0.9, 0.45, 0.5),
    ("showcase-d", "furniture", "", "", "leg-d", 9.6, "left", 1.5, 1.2, 0.9),
    ("poster-d-1", "poster", "poster-blue", "", "leg-d", 19.0, "right", 1.6, 0.9, 1.2),
    ("poster-d-2", "poster", "poster-violet", "", "leg-d", 15.8, "right", 1.6, 0.9, 1.2),
    ("poster-d-3", "poster", "", "", "leg-d", 13.4, "left", 1.6, 0.9, 1.2),
]


def places():
    """The view of the spot itself, where each usable picture of the first lap was taken (see train.sh)."""
    for line in open(__file__.rsplit("/", 1)[0] + "/places.txt", encoding="utf-8"):
        if line.strip() and not line.startswith("#"):
            frame, name, leg = line.split()[:3]
            arc = (FIRST + (int(frame) - 1) * STEP) % (2 * (WIDTH + HEIGHT))
            start = {"leg-a": 0.0, "leg-b": WIDTH, "leg-c": WIDTH + HEIGHT, "leg-d": 2 * WIDTH + HEIGHT}[leg]
            along = min(max(arc - start, HALF + 0.1), LEGS[leg][2] + HALF - 0.1)
            yield name, leg, point(leg, along), facing(leg, "along")


def corridor(leg):
    """A corner belongs to the leg that ends there, with the door one meets at its end."""
    end = LEGS[leg][2] + HALF
    return [point(leg, HALF, HALF), point(leg, end, HALF), point(leg, end, -HALF), point(leg, HALF, -HALF)][::-1]


def side_room(leg, along, side, span):
    sign = 1.0 if side == "right" else -1.0
    near, far = sign * (HALF + 0.15), sign * (HALF + 0.15 + DEPTH)
    ring = [point(leg, span[0], near), point(leg, span[1], near), point(leg, span[1], far), point(leg, span[0], far)]
    return ring if side == "left" else ring[::-1]


def spans():
    """Each door's share of its wall: half-way to its neighbours."""
    for leg in LEGS:
        for side in ("left", "right"):
            doors = sorted(d for d in DOORS if d[0] == leg and d[2] == side)
            for k, (_, along, _) in enumerate(doors):
                low = max(along - 2.5, along - 1.5 if k == 0 else (doors[k - 1][1] + along) / 2 + 0.08)
                high = min(along + 2.5, along + 1.5 if k == len(doors) - 1 else (doors[k + 1][1] + along) / 2 - 0.08)
                limit = (HALF + 0.2, LEGS[leg][2] - HALF - 0.2) if side == "left" else (-HALF, LEGS[leg][2] + HALF)
                yield leg, along, side, (max(low, limit[0]), min(high, limit[1]))


class Writer:
    def __init__(self, path):
        driver = ogr.GetDriverByName("GPKG")
        self.data = driver.CreateDataSource(path)
        self.crs = osr.SpatialReference()
        self.crs.ImportFromWkt('LOCAL_CS["corridor example, metres",UNIT["metre",1]]')

    def layer(self, name, kind, fields):
        types = {"s": ogr.OFTString, "r": ogr.OFTReal, "i": ogr.OFTInteger, "b": ogr.OFTInteger}
        layer = self.data.CreateLayer(name, None if kind == ogr.wkbNone else self.crs, kind)
        for field in fields:
            definition = ogr.FieldDefn(field[2:], types[field[0]])
            if field[0] == "b":
                definition.SetSubType(ogr.OFSTBoolean)
            layer.CreateField(definition)
        return layer

    @staticmethod
    def add(layer, wkt=None, **values):
        feature = ogr.Feature(layer.GetLayerDefn())
        if wkt:
            feature.SetGeometryDirectly(ogr.CreateGeometryFromWkt(wkt))
        for key, value in values.items():
            if value not in ("", None):
                feature.SetField(key, value)
        layer.CreateFeature(feature)


def ring_wkt(ring):
    return "POLYGON((" + ", ".join(f"{x} {y}" for x, y in ring + ring[:1]) + "))"


def line_wkt(*points):
    return "LINESTRING(" + ", ".join(f"{x} {y}" for x, y in points) + ")"


def main(path):
    out = Writer(path)
    out.data.StartTransaction()
    levels = out.layer("levels", ogr.wkbNone, ["r:level", "s:name", "s:ref", "r:elevation_m", "r:height_m"])
    out.add(levels, level=0.0, name="Corridor floor", ref="0", elevation_m=0.0, height_m=2.7)
    regions = out.layer("regions", ogr.wkbPolygon, ["s:region_id", "r:level", "s:name", "s:ref", "s:kind", "b:restricted"])
    accesses = out.layer("accesses", ogr.wkbLineString, [
        "s:access_id", "s:kind", "r:level", "s:region_a", "s:region_b", "s:shaft", "s:oneway", "s:door_type",
        "b:automatic", "r:width_m", "i:steps", "b:closed"])
    landmarks = out.layer("landmarks", ogr.wkbPoint, [
        "s:landmark_id", "s:kind", "s:template", "s:text", "s:region_id", "r:level", "r:heading_deg", "r:height_m",
        "r:width_m", "r:tall_m"])
    walls = out.layer("walls", ogr.wkbLineString, ["r:level"])

    order = list(LEGS)
    for leg in order:
        out.add(regions, ring_wkt(corridor(leg)), region_id=leg, level=0.0, name=NAMES[leg], ref=leg[-1].upper(),
                kind="corridor", restricted=0)
    for k, leg in enumerate(order):
        following = order[(k + 1) % 4]
        out.add(accesses, line_wkt(point(following, HALF, -HALF), point(following, HALF, HALF)),
                access_id=f"corner-{leg[-1]}{following[-1]}", kind="opening", level=0.0, region_a=leg, region_b=following,
                width_m=2 * HALF, closed=0)
    counts = {}
    for leg, along, side, span in sorted(spans(), key=lambda r: (r[0], r[1])):
        counts[leg] = counts.get(leg, 0) + 1
        room = f"room-{leg[-1]}{counts[leg]}"
        at = (HALF + 0.075) * (1.0 if side == "right" else -1.0)
        out.add(regions, ring_wkt(side_room(leg, along, side, span)), region_id=room, level=0.0,
                name=f"Room {leg[-1].upper()}{counts[leg]}", ref=f"{leg[-1].upper()}{counts[leg]}", kind="room", restricted=0)
        a, b = point(leg, along - 0.45, at), point(leg, along + 0.45, at)
        out.add(accesses, line_wkt(a, b), access_id=f"door-{leg[-1]}{counts[leg]}", kind="door", level=0.0, region_a=leg,
                region_b=room, door_type="hinged", width_m=0.9, closed=0)
        out.add(landmarks, "POINT(%s %s)" % point(leg, along, at), landmark_id=f"door-{leg[-1]}{counts[leg]}", kind="door",
                region_id=leg, level=0.0, heading_deg=facing(leg, side), height_m=1.0, width_m=0.9, tall_m=2.05)
    for leg, right, room, name, kind in END_DOORS:
        end = LEGS[leg][2] + HALF
        ring = [point(leg, end + 0.15, right + 1.2), point(leg, end + 0.15 + DEPTH, right + 1.2),
                point(leg, end + 0.15 + DEPTH, right - 1.2), point(leg, end + 0.15, right - 1.2)]
        out.add(regions, ring_wkt(ring), region_id=room, level=0.0, name=name, kind=kind, restricted=0)
        a, b = point(leg, end + 0.075, right + 0.45), point(leg, end + 0.075, right - 0.45)
        out.add(accesses, line_wkt(a, b), access_id=f"door-{room}", kind="door", level=0.0, region_a=leg, region_b=room,
                door_type="hinged", width_m=0.9, closed=0)
        templates = {"washroom": "washroom-door", "exit-stairs": "exit-door", "end-room": "end-door"}
        out.add(landmarks, "POINT(%s %s)" % point(leg, end, right), landmark_id=f"door-{room}", kind="door",
                template=templates[room], region_id=leg, level=0.0, heading_deg=facing(leg, "end"), height_m=1.0,
                width_m=0.95, tall_m=2.1)
    for name, kind, template, text, leg, along, side, height, width, tall in OBJECTS:
        at = {"right": HALF, "left": -HALF, "end": 0.1}[side]
        out.add(landmarks, "POINT(%s %s)" % point(leg, along, at), landmark_id=name, kind=kind, template=template, text=text,
                region_id=leg, level=0.0, heading_deg=facing(leg, side), height_m=height, width_m=width, tall_m=tall)
    for name, leg, where, heading in places():
        out.add(landmarks, "POINT(%s %s)" % where, landmark_id=name, kind="place", template=name, region_id=leg, level=0.0,
                heading_deg=heading, height_m=1.4)
    for k, leg in enumerate(order):
        length = LEGS[leg][2]
        out.add(walls, line_wkt(point(leg, -HALF, HALF), point(leg, length + HALF, HALF)), level=0.0)
        out.add(walls, line_wkt(point(leg, HALF, -HALF), point(leg, length - HALF, -HALF)), level=0.0)
    table = out.layer("farol", ogr.wkbNone, ["s:key", "s:value"])
    for key, value in [("schema", "1"), ("title", "Corridor walk"), ("languages", "en"),
                       ("crs_note", "A local plane in metres; drawn by eye, good to about 20 %")]:
        out.add(table, key=key, value=value)
    out.data.CommitTransaction()


if __name__ == "__main__":
    ogr.UseExceptions()
    main(sys.argv[1])
