"""Scenes to learn signs from: photographs of the training third and drawn signs, moved, bent, blurred and lit anew
over photographs of rooms. The pictures kept for asking are never opened here."""

import csv
import re
from pathlib import Path

import cv2
import numpy as np

import pictograms as pg

STRIDE = 8


def in_development_half(name):
    """As in training_pictures.cpp: FNV-1a, and a bit of its upper half."""
    value = 14695981039346656037
    for byte in name.encode():
        value = ((value ^ byte) * 1099511628211) % 2**64
    return (value >> 32) % 2 == 0


def exit_pictures(data):
    """In the order of the numbers in their names; every third from the first on is for training."""
    folder = Path(data) / "images" / "exit_signs_campus_tw"
    number = lambda path: int(re.findall(r"_(\d+)\.jpg$", path.name)[0])
    return sorted((folder / "images").glob("*.jpg"), key=number)


def boxes_of(picture_path, width, height):
    boxes = []
    for line in (picture_path.parents[1] / "labels" / (picture_path.stem + ".txt")).read_text().splitlines():
        if line.strip():
            x, y, w, h = (float(v) for v in line.split()[1:5])
            boxes.append(((x - w / 2) * width, (y - h / 2) * height, (x + w / 2) * width, (y + h / 2) * height))
    return np.array(boxes).reshape(-1, 4)


def shrunk(picture, longest):
    scale = longest / max(picture.shape[:2])
    return cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA) if scale < 1 else picture


def room_files(data):
    """Photographs without (large) signs: {set: files}. The other floors and halves are left for asking."""
    images = Path(data) / "images"
    rooms = {"tower": [], "tower4": [], "doors": [], "doors_dev": [], "walk": [], "stairs": []}
    with open(images / "tower" / "frames.csv") as file:
        for i, row in enumerate(csv.DictReader(file)):
            if row["floor"] in ("floor3", "basement0", "basement2") and i % 2 == 0:
                rooms["tower"].append(images / "tower" / row["image"])
            elif row["floor"] == "floor4":
                rooms["tower4"].append(images / "tower" / row["image"])
    with open(images / "doors" / "index.csv") as file:
        mine = [row["image"] for row in csv.DictReader(file) if in_development_half(row["image"])]
    for i, name in enumerate(mine):
        rooms["doors_dev" if i % 3 == 0 else "doors"].append(images / "doors" / "images" / name)
    rooms["walk"] = [images / "corridor_walk" / f"{i}.jpg" for i in range(1, 41)]
    with open(images / "stairs" / "stairs.csv") as file:
        rooms["stairs"] = [images / "stairs" / "img" / row["image"] for row in csv.DictReader(file)
                           if in_development_half(row["image"])]
    return rooms


class Scenes:
    def __init__(self, exits, rooms, seed):
        """`exits`: files of photographed exit signs; `rooms`: files of photographs without."""
        self.rng = np.random.default_rng(seed)
        self.exits = []
        for path in exits:
            picture = cv2.imread(str(path))
            boxes = boxes_of(path, picture.shape[1], picture.shape[0])
            self.exits.append((picture, boxes))
        self.rooms = [shrunk(cv2.imread(str(path)), 800) for path in rooms]

    def room(self, size):
        rng = self.rng
        picture = self.rooms[rng.integers(len(self.rooms))]
        h, w = picture.shape[:2]
        side = min(h, w) * rng.uniform(0.35, 1.0)
        if rng.random() < 0.3:
            side = max(h, w)  # all of it, squeezed
        cw, ch = int(min(w, side * rng.uniform(0.9, 1.2))), int(min(h, side * rng.uniform(0.9, 1.2)))
        x, y = int(rng.integers(w - cw + 1)), int(rng.integers(h - ch + 1))
        crop = cv2.resize(picture[y:y + ch, x:x + cw], (size, size),
                          interpolation=cv2.INTER_AREA if cw > size else cv2.INTER_LINEAR)
        return (crop[:, ::-1] if rng.random() < 0.5 else crop).astype(np.float32)

    def sign_width(self, size):
        """Mostly small to middling, as a walker's camera sees them, and some that fill the picture."""
        low, high = np.log(22), np.log(size * 0.95)
        return float(np.exp(self.rng.uniform(low, high)))

    def quad(self, width, height, size):
        """A rectangle turned in space and put somewhere in the picture; most of it inside."""
        rng = self.rng
        yaw, pitch, roll = rng.normal(0, 0.55), rng.normal(0, 0.25), rng.normal(0, 0.1)
        yaw, pitch = np.clip(yaw, -1.15, 1.15), np.clip(pitch, -0.7, 0.7)
        x = np.array([-1, 1, 1, -1]) * width / 2
        y = np.array([-1, -1, 1, 1]) * height / 2
        x, z = x * np.cos(yaw), x * np.sin(yaw)
        y, z = y * np.cos(pitch) - z * np.sin(pitch), y * np.sin(pitch) + z * np.cos(pitch)
        far = max(width, height) * rng.uniform(1.6, 6.0)
        k = far / (far + z)
        if rng.random() < 0.35:  # seen from above or below at the side: the panel slopes
            y = y + x * rng.normal(0, 0.3)
        x, y = x * k, y * k
        points = np.stack([x * np.cos(roll) - y * np.sin(roll), x * np.sin(roll) + y * np.cos(roll)], 1)
        low, high = points.min(0), points.max(0)
        room = np.maximum(size - (high - low), 0)
        place = rng.uniform(0, 1, 2) * room - low
        slack = (high - low) * 0.12
        return (points + place + rng.uniform(-slack, slack) * (rng.random() < 0.2)).astype(np.float32)

    def paste(self, canvas, panel, quad, feather):
        """Warps `panel` (float BGR) onto `quad`."""
        size = canvas.shape[0]
        h, w = panel.shape[:2]
        wide = max(np.linalg.norm(quad[1] - quad[0]), np.linalg.norm(quad[2] - quad[3]))
        tall = max(np.linalg.norm(quad[3] - quad[0]), np.linalg.norm(quad[2] - quad[1]))
        scale = min(1.0, 1.3 * max(wide / w, tall / h))
        panel = cv2.resize(np.ascontiguousarray(panel, np.float32), (max(3, round(w * scale)), max(3, round(h * scale))), interpolation=cv2.INTER_AREA)
        h, w = panel.shape[:2]
        x0, y0 = np.clip(np.floor(quad.min(0)) - 2, 0, size - 1).astype(int)
        x1, y1 = np.clip(np.ceil(quad.max(0)) + 2, 1, size).astype(int)
        if x1 - x0 < 2 or y1 - y0 < 2:
            return
        source = np.float32([[0, 0], [w, 0], [w, h], [0, h]]) - 0.5
        transform = cv2.getPerspectiveTransform(source, quad - np.float32([x0, y0]))
        alpha = np.full((h, w), 1, np.float32)
        if feather:
            f = max(1, int(min(h, w) * 0.06))
            alpha = cv2.copyMakeBorder(np.ones((max(1, h - 2 * f), max(1, w - 2 * f)), np.float32), f, f, f, f, cv2.BORDER_CONSTANT)[:h, :w]
            alpha = cv2.blur(alpha, (f, f))
        warped = cv2.warpPerspective(panel, transform, (int(x1 - x0), int(y1 - y0)), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        a = cv2.warpPerspective(alpha, transform, (int(x1 - x0), int(y1 - y0)), flags=cv2.INTER_LINEAR)[..., None]
        part = canvas[y0:y1, x0:x1]
        canvas[y0:y1, x0:x1] = part * (1 - a) + warped * a

    def glare(self, canvas, box):
        rng = self.rng
        x0, y0, x1, y1 = box
        centre = (rng.uniform(x0, x1), rng.uniform(y0, y1))
        axes = np.maximum(rng.uniform(0.05, 0.25, 2) * (x1 - x0, y1 - y0), 2)
        light = np.zeros(canvas.shape[:2], np.float32)
        cv2.ellipse(light, (int(centre[0]), int(centre[1])), (int(axes[0]), int(axes[1])), rng.uniform(0, 180), 0, 360, 1.0, -1)
        light = cv2.GaussianBlur(light, (0, 0), float(max(1.0, axes.min() * 0.4)))
        canvas += light[..., None] * rng.uniform(60, 255)

    def tone(self, panel, mean):
        """A drawn panel takes some of the room's light, or shines by itself."""
        rng = self.rng
        if rng.random() < 0.45:
            gain = rng.uniform(0.95, 1.3)
        else:
            gain = np.clip(mean / 130, 0.35, 1.2) * rng.uniform(0.8, 1.2)
        out = panel * gain
        spots = cv2.resize(rng.normal(0, 1, (4, 6)).astype(np.float32), (panel.shape[1], panel.shape[0]), interpolation=cv2.INTER_CUBIC)
        return out * (1 + rng.uniform(0, 0.08) * spots[..., None])

    def add_drawn(self, canvas, kind, width=None):
        rng = self.rng
        size = canvas.shape[0]
        panel = pg.draw_exit(rng) if kind == pg.EXIT else pg.draw_other(rng) if kind < 0 else pg.draw_square(rng, kind)
        width = width or self.sign_width(size)
        aspect = panel.shape[1] / panel.shape[0]
        if aspect < 1.6:
            width = max(20.0, width * 0.75)
        quad = self.quad(width, width / aspect, size)
        self.paste(canvas, self.tone(panel, canvas.mean()), quad, False)
        return quad

    def add_cut(self, canvas, width=None):
        """A photographed sign, cut out with a little of its wall."""
        rng = self.rng
        size = canvas.shape[0]
        picture, boxes = self.exits[rng.integers(len(self.exits))]
        x0, y0, x1, y1 = boxes[rng.integers(len(boxes))]
        h, w = picture.shape[:2]
        panel = picture[max(0, int(y0)):min(h, int(y1)), max(0, int(x0)):min(w, int(x1))].astype(np.float32)
        if rng.random() < 0.3:
            panel = panel[:, ::-1]
        width = width or self.sign_width(size)
        quad = self.quad(width, width * panel.shape[0] / panel.shape[1], size)
        self.paste(canvas, panel, quad, True)
        return quad

    def add_photograph(self, canvas, spoil=False):
        """The whole photograph round its sign, so that the sign has the wanted width; the rest is the room."""
        rng = self.rng
        size = canvas.shape[0]
        picture, boxes = self.exits[rng.integers(len(self.exits))]
        boxes = boxes.copy()
        h, w = picture.shape[:2]
        if spoil:
            picture = self.spoilt(picture, boxes)
        box = boxes[rng.integers(len(boxes))]
        if rng.random() < 0.3:
            picture = picture[:, ::-1]
            boxes = np.stack([w - boxes[:, 2], boxes[:, 1], w - boxes[:, 0], boxes[:, 3]], 1)
            box = np.array([w - box[2], box[1], w - box[0], box[3]])
        low, high = np.log(max(20, 0.12 * size)), np.log(0.95 * size)
        scale = np.exp(rng.uniform(low, high)) / max(box[2] - box[0], box[3] - box[1])
        ax, ay = scale * np.exp(rng.normal(0, 0.08)), scale * np.exp(rng.normal(0, 0.08))
        turn, shear = np.radians(rng.normal(0, 5)), rng.normal(0, 0.08)
        linear = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) @ np.array([[1, 0], [shear, 1]]) @ np.diag([ax, ay])
        tilt = rng.normal(0, 0.12, 2) / max(h, w)
        to = np.array([[1, 0, 0], [0, 1, 0], [tilt[0], tilt[1], 1]])
        centre = np.array([(box[0] + box[2]) / 2, (box[1] + box[3]) / 2])
        move = np.eye(3)
        move[:2, :2] = linear
        full = move @ to @ np.array([[1, 0, -centre[0]], [0, 1, -centre[1]], [0, 0, 1]])
        outline = moved_box(full, box)
        spread = outline[2:] - outline[:2]
        free = np.maximum(size - spread, 0)
        shift = rng.uniform(0, 1, 2) * free - outline[:2]
        full = np.array([[1, 0, shift[0]], [0, 1, shift[1]], [0, 0, 1]]) @ full
        factor = min(1.0, 1.4 * max(ax, ay))
        small = cv2.resize(np.ascontiguousarray(picture), None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA) if factor < 1 else np.ascontiguousarray(picture)
        matrix = full @ np.diag([w / small.shape[1], h / small.shape[0], 1])
        warped = cv2.warpPerspective(small, matrix, (size, size), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        inside = cv2.warpPerspective(np.ones(small.shape[:2], np.float32), matrix, (size, size))[..., None]
        if rng.random() < 0.85:
            canvas[:] = canvas * (1 - inside) + warped * inside
        else:
            canvas[:] = warped
        return [] if spoil else [moved_box(full, one) for one in boxes]

    def spoilt(self, picture, boxes):
        """The same wall with the man gone: covered, wiped away, or another panel in the place."""
        rng = self.rng
        picture = picture.astype(np.float32)
        h, w = picture.shape[:2]
        for x0, y0, x1, y1 in boxes:
            x0, y0, x1, y1 = max(0, int(x0) - 8), max(0, int(y0) - 8), min(w, int(x1) + 8), min(h, int(y1) + 8)
            kind = rng.integers(3)
            if kind == 0:
                bh, bw = y1 - y0, x1 - x0
                sy = 0 if y0 > h - y1 else max(0, h - bh)
                part = picture[sy:sy + bh, :bw]
                picture[y0:y0 + part.shape[0], x0:x1] = cv2.resize(part, (x1 - x0, part.shape[0]))
            else:
                colour = picture[[max(0, y0 - 3), min(h - 1, y1 + 3)], (x0 + x1) // 2].mean(0)
                picture[y0:y1, x0:x1] = colour if kind == 1 else picture[y0:y1, x0:x1].mean(axis=(0, 1)) * 0.3 + 0.7 * colour
            if rng.random() < 0.6:
                panel = np.clip(pg.draw_other(rng), 0, 255)
                wide = (x1 - x0) * rng.uniform(0.5, 1.0)
                tall = min(y1 - y0, wide * panel.shape[0] / panel.shape[1])
                panel = cv2.resize(panel, (max(4, int(wide)), max(4, int(tall))), interpolation=cv2.INTER_AREA)
                px, py = x0 + int((x1 - x0 - panel.shape[1]) / 2), y0 + int((y1 - y0 - panel.shape[0]) / 2)
                picture[py:py + panel.shape[0], px:px + panel.shape[1]] = panel
        return np.clip(picture, 0, 255).astype(np.uint8)

    def photographed(self, canvas):
        """What a camera does to the light."""
        rng = self.rng
        out = canvas
        if rng.random() < 0.3:  # bright things bleed
            out = out + cv2.GaussianBlur(np.maximum(out - 190, 0), (0, 0), rng.uniform(1, 5)) * rng.uniform(0.2, 1.0)
        out = out * rng.uniform(0.6, 1.35) * (1 + rng.normal(0, 0.07, 3).astype(np.float32))
        out = np.clip(out, 0, 255)
        if rng.random() < 0.5:
            out = 255.0 * (out / 255.0) ** np.exp(rng.normal(0, 0.3))
        if rng.random() < 0.4:
            grey = out.mean(2, keepdims=True)
            out = grey + (out - grey) * rng.uniform(0.5, 1.4)
        if rng.random() < 0.4:
            out = cv2.GaussianBlur(out, (0, 0), rng.uniform(0.3, 1.4))
        if rng.random() < 0.15:
            k = int(rng.integers(3, 9))
            kernel = np.zeros((k, k), np.float32)
            a = rng.uniform(0, np.pi)
            c = (k - 1) / 2
            cv2.line(kernel, (round(c - c * np.cos(a)), round(c - c * np.sin(a))), (round(c + c * np.cos(a)), round(c + c * np.sin(a))), 1.0)
            out = cv2.filter2D(out, -1, kernel / kernel.sum())
        if rng.random() < 0.5:
            out = out + rng.normal(0, rng.uniform(1, 9), out.shape).astype(np.float32)
        out = np.clip(out, 0, 255).astype(np.uint8)
        if rng.random() < 0.3:
            out = cv2.imdecode(cv2.imencode(".jpg", out, [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(35, 95))])[1], 1)
        return out

    def scene(self, size):
        """A picture, and its signs as rows of kind, x0, y0, x1, y1."""
        rng = self.rng
        canvas = self.room(size)
        signs = []
        kind = rng.random()
        if kind < 0.25:
            signs += [(pg.EXIT, *box) for box in self.add_photograph(canvas)]
            if rng.random() < 0.25:
                self.distract(canvas, signs)
        elif kind < 0.78:
            for _ in range(int(rng.integers(0, 3))):
                self.add_drawn(canvas, -1)
            for _ in range(int(rng.integers(1, 4))):
                before = canvas.copy()
                which = pg.EXIT if rng.random() < 0.55 else int(rng.integers(1, len(pg.NAMES)))
                quad = self.add_cut(canvas) if which == pg.EXIT and rng.random() < 0.35 else self.add_drawn(canvas, which)
                box = np.concatenate([quad.min(0), quad.max(0)])
                if any(meets(box, other[1:]) for other in signs):
                    canvas[:] = before
                else:
                    signs.append((which, *box))
        elif kind < 0.86:
            self.add_photograph(canvas, spoil=True)
        else:
            for _ in range(int(rng.integers(0, 5))):
                self.add_drawn(canvas, -1)
        for sign in signs:
            if rng.random() < 0.2:
                self.glare(canvas, sign[1:])
            if rng.random() < 0.12:
                self.hide(canvas, sign[1:])
        return self.photographed(canvas), np.array(signs, np.float32).reshape(-1, 5)

    def distract(self, canvas, signs):
        before = canvas.copy()
        quad = self.add_drawn(canvas, -1, self.rng.uniform(12, canvas.shape[0] * 0.4))
        box = np.concatenate([quad.min(0), quad.max(0)])
        if any(meets(box, sign[1:]) for sign in signs):
            canvas[:] = before

    def hide(self, canvas, box):
        """Something before one end of it."""
        rng = self.rng
        x0, y0, x1, y1 = box
        share = rng.uniform(0.05, 0.25)
        colour = canvas[rng.integers(canvas.shape[0]), rng.integers(canvas.shape[1])].copy()
        a, b = (x0, x0 + share * (x1 - x0)) if rng.random() < 0.5 else (x1 - share * (x1 - x0), x1)
        a, b, y0, y1 = (int(np.clip(v, 0, canvas.shape[0])) for v in (a, b, y0, y1))
        canvas[y0:y1, a:b] = colour


def meets(a, b):
    return min(a[2], b[2]) > max(a[0], b[0]) and min(a[3], b[3]) > max(a[1], b[1])


def moved_box(matrix, box):
    """Between the box round the moved corners and the one round the moved inscribed ellipse: a sign seldom
    reaches into the corners of its box."""
    x0, y0, x1, y1 = box
    corners = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
    angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    round_ = np.stack([(x0 + x1) / 2 + (x1 - x0) / 2 * np.cos(angle), (y0 + y1) / 2 + (y1 - y0) / 2 * np.sin(angle)], 1)
    both = []
    for points in (corners, round_):
        p = np.concatenate([points, np.ones((len(points), 1))], 1) @ matrix.T
        p = p[:, :2] / p[:, 2:]
        both.append(np.concatenate([p.min(0), p.max(0)]))
    return (both[0] + both[1]) / 2


def targets(signs, size, classes):
    """Heat for each kind, distances to the four sides, where those count, and where heat does not."""
    n = size // STRIDE
    heat = np.zeros((classes, n, n), np.float32)
    sides = np.zeros((4, n, n), np.float32)
    inside = np.zeros((n, n), np.float32)
    ignore = np.zeros((classes, n, n), np.float32)
    grid = (np.arange(n, dtype=np.float32) + 0.5) * STRIDE
    gx, gy = np.meshgrid(grid, grid)
    for kind, x0, y0, x1, y1 in sorted(signs.tolist(), key=lambda s: -(s[3] - s[1]) * (s[4] - s[2])):
        x0, y0, x1, y1 = max(0, x0), max(0, y0), min(size, x1), min(size, y1)
        w, h = x1 - x0, y1 - y0
        if w < 3 or h < 3:
            continue
        cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
        if max(w, h) < 12 or min(w, h) < 6:
            ignore[:, (np.abs(gy - cy) < h / 2 + 8) & (np.abs(gx - cx) < w / 2 + 8)] = 1
            continue
        sx, sy = max(3.0, 0.11 * w), max(3.0, 0.11 * h)
        peak = np.exp(-((gx - cx) ** 2 / (2 * sx * sx) + (gy - cy) ** 2 / (2 * sy * sy)))
        iy, ix = min(n - 1, int(cy // STRIDE)), min(n - 1, int(cx // STRIDE))
        peak[iy, ix] = 1.0
        k = int(kind)
        heat[k] = np.maximum(heat[k], peak)
        near = (np.abs(gx - cx) < max(5.0, 0.2 * w)) & (np.abs(gy - cy) < max(5.0, 0.2 * h))
        near &= (gx > x0) & (gx < x1) & (gy > y0) & (gy < y1)
        near[iy, ix] = True
        for i, d in enumerate((gx - x0, gy - y0, x1 - gx, y1 - gy)):
            sides[i][near] = np.maximum(d, 1.0)[near]
        inside[near] = 1
    return heat, sides, inside, ignore
