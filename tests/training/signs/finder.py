"""Runs an exported network as core/recognition/sign_detector.cpp does, and scores it."""

import cv2
import numpy as np

KINDS = 5


class Finder:
    def __init__(self, path, longest=384):
        self.net = cv2.dnn.readNetFromONNX(str(path))
        self.longest = longest

    def find(self, picture, least=0.05):
        scale = self.longest / max(picture.shape[:2])
        h, w = round(picture.shape[0] * scale), round(picture.shape[1] * scale)
        small = cv2.resize(picture, (w, h), interpolation=cv2.INTER_AREA)
        small = cv2.copyMakeBorder(small, 0, -h % 64, 0, -w % 64, cv2.BORDER_CONSTANT, value=(114, 114, 114))
        self.net.setInput(cv2.dnn.blobFromImage(small, 1 / 255.0))
        maps = self.net.forward()[0]
        found = []
        for kind in range(KINDS):
            heat = 1 / (1 + np.exp(-maps[kind]))
            top = (heat == cv2.dilate(heat, np.ones((3, 3)))) & (heat >= least)
            for y, x in zip(*np.nonzero(top)):
                d = np.exp(np.clip(maps[KINDS:, y, x], -4, 4)) * 16
                cx, cy = (x + 0.5) * 8, (y + 0.5) * 8
                box = np.clip([cx - d[0], cy - d[1], cx + d[2], cy + d[3]], 0, [w, h, w, h]) / scale
                found.append((float(heat[y, x]), kind, *box))
        found.sort(reverse=True)
        kept = []
        for one in found:
            if all(iou(one[2:], other[2:]) < 0.4 and covered(one[2:], other[2:]) < 0.7 for other in kept):
                kept.append(one)
        return kept


def iou(a, b):
    w = min(a[2], b[2]) - max(a[0], b[0])
    h = min(a[3], b[3]) - max(a[1], b[1])
    if w <= 0 or h <= 0:
        return 0.0
    return w * h / ((a[2] - a[0]) * (a[3] - a[1]) + (b[2] - b[0]) * (b[3] - b[1]) - w * h)


def covered(a, b):
    """Share of the smaller box that the other covers."""
    w = min(a[2], b[2]) - max(a[0], b[0])
    h = min(a[3], b[3]) - max(a[1], b[1])
    least = min((a[2] - a[0]) * (a[3] - a[1]), (b[2] - b[0]) * (b[3] - b[1]))
    return w * h / least if w > 0 and h > 0 and least > 0 else 0.0


def table(finder, pictures, kind=0, levels=(0.2, 0.3, 0.4, 0.5, 0.6, 0.7)):
    """pictures: (picture, boxes of `kind`). Rows of level, signs, found, wrong."""
    scored, signs = [], 0
    for picture, boxes in pictures:
        signs += len(boxes)
        left = [tuple(box) for box in boxes]
        for one in finder.find(picture, min(levels)):
            if one[1] != kind:
                continue
            best = max(left, key=lambda box: iou(one[2:], box), default=None)
            hit = best is not None and iou(one[2:], best) >= 0.5
            if hit:
                left.remove(best)
            scored.append((one[0], hit))
    return [(level, signs, sum(h for s, h in scored if s >= level), sum(not h for s, h in scored if s >= level)) for level in levels]
