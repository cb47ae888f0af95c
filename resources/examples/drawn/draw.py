#!/usr/bin/python3
"""Draws the example building: its map, the frames of a walk through it, views to train its landmarks from, and the truth.

For maintainers; ./dev does not run it. Needs Debian's python3-opencv, python3-gdal and fonts-dejavu-core. Everything
is the same at every run. Usage: draw.py [FOLDER] (default: the folder of this file)
"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the folder holds what is given away and nothing else

import cv2
import numpy as np
from osgeo import gdal, ogr, osr

import scene
from building import ACCESSES, CEILING, DOOR_LANDMARKS, DOOR_TALL, LANDMARKS, REGIONS, WALK
from render import SAMPLES, Camera, look

CRS, EAST, NORTH = 32629, 594200.0, 4098600.0  # UTM 29N; somewhere near the sea: the building does not exist
QUALITY = 80
TRAIN_LIGHT = {"warmth": 0.05, "gain": 0.86}
# The distance in metres from which a landmark is photographed for training, where it is not 1.75.
FAR = {"welcome-board": 2.0, "extinguisher-1": 1.5, "exit-sign": 1.6, "cafe-sign": 1.5}

# Templates with few details of their own are photographed from the side as well.
ASIDE = ("cafe", "extinguisher", "exit")


def on_map(x, y):
    return round(EAST + x, 3), round(NORTH + y, 3)


def region_at(x, y):
    for name, (_, _, _, west, south, east, north) in REGIONS.items():
        if west <= x < east and south <= y < north:
            return name
    raise ValueError("no region at %g, %g" % (x, y))


class MapFile:
    """A GeoPackage with the layers of the building file."""

    def __init__(self, path):
        path.unlink(missing_ok=True)
        self.source = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
        self.crs = osr.SpatialReference()
        self.crs.ImportFromEPSG(CRS)
        self.source.StartTransaction()

    def layer(self, name, geometry, fields, rows):
        options = ["SPATIAL_INDEX=NO", "GEOMETRY_NAME=geom"] if geometry != ogr.wkbNone else []
        table = self.source.CreateLayer(name, self.crs if geometry != ogr.wkbNone else None, geometry, options)
        kinds = {"s": ogr.OFTString, "r": ogr.OFTReal, "i": ogr.OFTInteger, "b": ogr.OFTInteger}
        for field in fields.split():
            kind, label = field.split(":")
            definition = ogr.FieldDefn(label, kinds[kind])
            if kind == "b":
                definition.SetSubType(ogr.OFSTBoolean)
            table.CreateField(definition)
        for values, points in rows:
            feature = ogr.Feature(table.GetLayerDefn())
            for index, value in enumerate(values):
                if value is not None:
                    feature.SetField(index, value)
            if points is not None:
                feature.SetGeometry(shape(geometry, points))
            table.CreateFeature(feature)

    def close(self):
        self.source.CommitTransaction()
        self.source = None


def shape(kind, points):
    line = ogr.Geometry({ogr.wkbPolygon: ogr.wkbLinearRing}.get(kind, kind))
    for x, y in points:
        line.AddPoint_2D(*on_map(x, y))
    if kind != ogr.wkbPolygon:
        return line
    polygon = ogr.Geometry(ogr.wkbPolygon)
    polygon.AddGeometry(line)
    return polygon


def wall_lines():
    """The regions' outlines without doors and openings, each shared wall once."""
    lines = {}
    for _, _, kind, west, south, east, north in REGIONS.values():
        if kind == "outside":
            continue
        ring = [(west, south), (west, north), (east, north), (east, south)]
        for k in range(4):
            a, b = np.array(ring[k], float), np.array(ring[(k + 1) % 4], float)
            found, along = scene.accesses_on(a, b)
            at, ends = 0.0, []
            for begin, end, *_ in found:
                ends.append((at, begin))
                at = end
            ends.append((at, np.linalg.norm(b - a)))
            for begin, end in ends:
                if end - begin > 0.01:
                    pair = sorted(tuple(float(v) for v in np.round(a + along * s, 3)) for s in (begin, end))
                    lines[tuple(pair)] = True
    return sorted(lines)


def landmark_rows():
    for name, (kind, template, words, room, x, y, faces, middle, wide, tall) in LANDMARKS.items():
        yield (name, kind, template, words, room, 0.0, float(faces), middle, wide, tall), [(x, y)]
    for access, room, faces in DOOR_LANDMARKS:
        (ax, ay), (bx, by) = ACCESSES[access][3:5]
        wide = float(np.hypot(bx - ax, by - ay))
        yield ("%s@%s" % (access, room), "door", "", "", room, 0.0, float(faces), DOOR_TALL / 2, round(wide, 3),
               DOOR_TALL), [((ax + bx) / 2, (ay + by) / 2)]


def write_map(path):
    out = MapFile(path)
    out.layer("farol", ogr.wkbNone, "s:key s:value",
              [((key, value), None) for key, value in [
                  ("schema", "1"), ("title", "Drawn example building"), ("languages", "en"),
                  ("crs_note", "Drawn, not surveyed: the place on Earth is made up."), ("licence", "CC0-1.0")]])
    out.layer("levels", ogr.wkbNone, "r:level s:name s:ref r:elevation_m r:height_m",
              [((0.0, "Ground floor", "0", 0.0, CEILING), None)])
    out.layer("regions", ogr.wkbPolygon, "s:region_id r:level s:name s:ref s:kind b:restricted",
              [((name, 0.0, title, ref, kind, 0), [(w, s), (e, s), (e, n), (w, n), (w, s)])
               for name, (title, ref, kind, w, s, e, n) in REGIONS.items()])
    out.layer("accesses", ogr.wkbLineString,
              "s:access_id s:kind r:level s:region_a s:region_b s:shaft s:oneway s:door_type b:automatic r:width_m i:steps b:closed",
              [((name, kind, 0.0, a, b, "", "", "hinged" if kind == "door" else "", 0,
                 round(float(np.hypot(q[0] - p[0], q[1] - p[1])), 3), None, 0), [p, q])
               for name, (kind, a, b, p, q, _) in ACCESSES.items()])
    out.layer("landmarks", ogr.wkbPoint,
              "s:landmark_id s:kind s:template s:text s:region_id r:level r:heading_deg r:height_m r:width_m r:tall_m",
              landmark_rows())
    out.layer("walls", ogr.wkbLineString, "r:level", [((0.0,), line) for line in wall_lines()])
    out.close()


def area_on_screen(camera, panel):
    """In fine samples, also what lies outside the picture; None when the panel reaches behind the camera."""
    corners = [camera.project(corner) for corner in panel.corners()]
    if any(corner is None for corner in corners):
        return None
    return cv2.contourArea(np.array(corners, np.float32)) * SAMPLES ** 2


def seen(camera, panels, owner):
    """Landmarks in view and which share of each is: inside the picture and not hidden."""
    counts = np.bincount(owner[owner >= 0], minlength=len(panels))
    shares = {}
    for index, panel in enumerate(panels):
        whole = area_on_screen(camera, panel) if panel.name and counts[index] else None
        if whole:
            share = min(1.0, counts[index] / whole)
            if share >= 0.01 and whole >= 60 * SAMPLES ** 2:
                shares[panel.name] = share
    return shares


def near(camera, shares):
    """Landmarks that anyone would recognise: whole, trained, at no more than twice the usual training distance, and not
    seen at more than 55 degrees aside."""
    names = []
    for name, share in sorted(shares.items()):
        template, x, y, faces, middle = (LANDMARKS[name][k] for k in (1, 4, 5, 6, 7))
        towards = camera.place - (x, y, middle)
        out = (np.cos(np.radians(faces)), np.sin(np.radians(faces)), 0.0)
        aside = np.degrees(np.arccos(towards @ out / np.linalg.norm(towards)))
        if template and share >= 0.98 and np.linalg.norm(towards) <= 2 * FAR.get(name, 1.75) and aside <= 55:
            names.append(name)
    return names


def write_picture(path, image):
    small = [cv2.IMWRITE_JPEG_OPTIMIZE, 1, cv2.IMWRITE_JPEG_PROGRESSIVE, 1]
    if not cv2.imwrite(str(path), image, [cv2.IMWRITE_JPEG_QUALITY, QUALITY] + small):
        raise OSError("cannot write %s" % path)


def write_walk(folder, panels, lamps):
    (folder / "frames").mkdir(exist_ok=True)
    lines = ["frame,region,x,y,heading_deg,visible,near"]
    for number, (x, y, heading) in enumerate(WALK, 1):
        camera = Camera(x, y, heading)
        image, owner = look(camera, panels, lamps, seed=number)
        write_picture(folder / "frames" / ("%d.jpg" % number), image)
        shares = seen(camera, panels, owner)
        visible = ";".join("%s:%.2f" % item for item in sorted(shares.items()))
        lines.append("%d.jpg,%s,%.3f,%.3f,%g,%s,%s" % ((number, region_at(x, y)) + on_map(x, y)
                                                       + (heading % 360, visible, ";".join(near(camera, shares)))))
    (folder / "truth.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def training_camera(name, aside):
    """In front of a landmark, `aside` degrees off its axis to the side from which the walk comes."""
    x, y, faces, middle = (LANDMARKS[name][k] for k in (4, 5, 6, 7))
    far = FAR.get(name, 1.75) + (0.15 if aside else 0.0)
    a = np.radians(faces + aside)
    px, py = x + far * np.cos(a), y + far * np.sin(a)
    pitch = 0.8 * np.degrees(np.arctan2(middle - 1.5, far))
    return Camera(px, py, np.degrees(a) + 180 + 3, pitch=pitch)


def write_views(folder, panels, lamps):
    """One or two views of each template. Outlines are known from the projection."""
    (folder / "train").mkdir(exist_ok=True)
    lines = ["# picture, template, kind, width in metres, outline clockwise from the object's own top left"]
    done = set()
    named = {panel.name: panel for panel in panels if panel.name}
    for number, (name, row) in enumerate(LANDMARKS.items()):
        kind, template, wide, faces = row[0], row[1], row[8], row[6]
        if not template or template in done:
            continue
        done.add(template)
        side = {270: -1, 90: 1, 180: 1, 0: -1}[faces]
        for view, aside in enumerate([4 * side, 36 * side] if template in ASIDE else [4 * side], 1):
            camera = training_camera(name, aside)
            image, owner = look(camera, panels, lamps, seed=1000 + 10 * number + view, **TRAIN_LIGHT)
            share = seen(camera, panels, owner).get(name, 0.0)
            if share < 0.97:
                raise ValueError("%s is not wholly in its training view %d (%.2f)" % (name, view, share))
            picture = "%s-%d.jpg" % (template, view)
            write_picture(folder / "train" / picture, image)
            outline = ",".join("%.1f" % v for corner in named[name].corners() for v in camera.project(corner))
            lines.append("%s %s %s %.2f %s" % (picture, template, kind, wide, outline))
    (folder / "train" / "views.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent
    folder.mkdir(parents=True, exist_ok=True)
    gdal.UseExceptions()
    gdal.SetConfigOption("OGR_CURRENT_DATE", "2026-01-01T00:00:00.000Z")
    cv2.setNumThreads(1)
    write_map(folder / "drawn.gpkg")
    panels, lamps = scene.build()
    write_views(folder, panels, lamps)
    write_walk(folder, panels, lamps)


if __name__ == "__main__":
    main()
