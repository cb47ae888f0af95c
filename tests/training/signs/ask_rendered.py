"""Asks a network about drawn signs over rooms that it has not learnt from: python3 ask_rendered.py DATA NETWORK.onnx

The drawings come from the same program as those of the training, with other chances: this tells how far and how dim a
sign may be, not how well real signs of that kind are found."""

import argparse
from pathlib import Path

import csv
import cv2
import numpy as np

import finder
import pictograms
import scenes

SIZE = 384


def other_rooms(data):
    """Those that room_files() leaves out."""
    images = Path(data) / "images"
    with open(images / "tower" / "frames.csv") as file:
        rooms = [images / "tower" / row["image"] for i, row in enumerate(csv.DictReader(file))
                 if row["floor"] in ("floor10", "floor11", "floor12", "floor13") and i % 6 == 0]
    with open(images / "doors" / "index.csv") as file:
        rooms += [images / "doors" / "images" / row["image"] for row in csv.DictReader(file)
                  if not scenes.in_development_half(row["image"])]
    return rooms


def rendered(made, kind, width):
    """One sign of that width and up to two panels that are none; the picture and the sign's box."""
    while True:
        canvas = made.room(SIZE)
        quad = made.add_drawn(canvas, kind, width)
        box = np.concatenate([quad.min(0), quad.max(0)])
        if box.min() < 0 or box.max() > SIZE or min(box[2:] - box[:2]) < 0.25 * width:
            continue  # cut by the border, or seen along its plane
        for _ in range(int(made.rng.integers(0, 3))):
            made.distract(canvas, [(kind, *box)])
        return made.photographed(canvas), [tuple(box)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("data", type=Path)
    parser.add_argument("network", type=Path)
    parser.add_argument("--each", type=int, default=40)
    parser.add_argument("--level", type=float, default=0.5)
    options = parser.parse_args()
    cv2.setNumThreads(1)
    made = scenes.Scenes([], other_rooms(options.data), 77)
    asked = finder.Finder(options.network)
    for kind, name in enumerate(pictograms.NAMES):
        for width in (24, 40, 64, 110, 200):
            pictures = [rendered(made, kind, width) for _ in range(options.each)]
            (_, signs, found, wrong), = finder.table(asked, pictures, kind, (options.level,))
            print(f"{name:13} {width:3} px of {SIZE}: {found} of {signs} found, {wrong} wrong", flush=True)


if __name__ == "__main__":
    main()
