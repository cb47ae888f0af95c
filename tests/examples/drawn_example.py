"""What the tests know of the drawn example: its truth, its map and its training list."""
import csv
import sqlite3
import subprocess
import sys

FOLDER = "resources/examples/drawn"
BARELY_IN_VIEW = 0.02  # of a landmark; less than that nobody could name


class Check:
    def __init__(self):
        self.failed = 0

    def that(self, holds, text):
        print(("  ok    " if holds else "  FAILS ") + text)
        self.failed += 0 if holds else 1


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: exit {done.returncode}")
    return done.stdout.decode()


def truth(example):
    """One dictionary a frame, in the order of the walk; `visible`: landmark -> share that is in view;
    `near`: trained landmarks that anyone would recognise."""
    with open(example / "truth.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        pairs = (entry.rsplit(":", 1) for entry in row["visible"].split(";") if entry)
        row["visible"] = {name: float(share) for name, share in pairs}
        row["near"] = [name for name in row["near"].split(";") if name]
    return rows


def landmarks(example):
    """landmark -> its kind, template, text and region, from the map file."""
    query = "select landmark_id, kind, template, text, region_id from landmarks"
    with sqlite3.connect(f"file:{example / 'drawn.gpkg'}?mode=ro", uri=True) as database:
        return {row[0]: dict(zip(("kind", "template", "text", "region"), row[1:])) for row in database.execute(query)}


def training(example):
    """(picture, template, kind, width in metres, outline) of every view."""
    lines = (example / "train" / "views.txt").read_text(encoding="utf-8").splitlines()
    words = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return [(row[0], row[1], row[2], float(row[3]), [float(v) for v in row[4].split(",")]) for row in words]
