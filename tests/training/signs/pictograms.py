"""Draws pictogram signs: exits with a running man, and the square signs for an extinguisher, toilets, stairs and
lifts, in the manner of ISO 7010 and ISO 7001 but in outlines of our own, each time a little different.

Every drawing is a BGRA picture; what stands in for a wrong sign (an arrow, a cross, a letter) is drawn here too."""

import cv2
import numpy as np

EXIT, EXTINGUISHER, TOILET, STAIRS, LIFT = range(5)
NAMES = ["exit", "extinguisher", "toilet", "stairs", "lift"]

WORDS = ["EXIT", "SAIDA", "SORTIE", "SALIDA", "WC", "LIFT", "NOTAUSGANG", "UITGANG", "USCITA", "SALIDA DE EMERGENCIA"]


class Canvas:
    """A unit square on which shapes are drawn; colour is what is inked, `mask` where."""

    def __init__(self, size):
        self.size = size
        self.mask = np.zeros((size, size), np.uint8)

    def px(self, points):
        return np.round(np.asarray(points, np.float64) * self.size * 16).astype(np.int32)

    def polygon(self, points, value=255):
        cv2.fillPoly(self.mask, [self.px(points)], value, cv2.LINE_AA, 4)

    def line(self, points, width, value=255):
        cv2.polylines(self.mask, [self.px(points)], False, value, max(1, round(width * self.size)), cv2.LINE_AA, 4)

    def disc(self, centre, radius, value=255):
        cv2.circle(self.mask, tuple(self.px(centre).tolist()), int(radius * self.size * 16), value, -1, cv2.LINE_AA, 4)

    def box(self, x0, y0, x1, y1, value=255):
        self.polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], value)


def shaken(rng, points, amount):
    return np.asarray(points) + rng.normal(0, amount, np.shape(points))


def running_man(c, rng, value=255, scale=1.0, at=(0.0, 0.0)):
    """Runs to the left, one arm ahead, the rear leg bent."""
    def p(points):
        return (shaken(rng, points, 0.008) - 0.5) * scale + 0.5 + np.asarray(at)
    thick = rng.uniform(0.075, 0.1) * scale
    c.disc(p([(0.42, 0.2)])[0], rng.uniform(0.065, 0.085) * scale, value)
    shoulder, hip = (0.5, 0.34), (0.57, 0.58)
    c.line(p([shoulder, hip]), thick * 1.45, value)
    c.line(p([shoulder, (0.37, 0.38), (0.3, 0.5)]), thick * 0.8, value)
    c.line(p([shoulder, (0.66, 0.42), (0.75, 0.36)]), thick * 0.8, value)
    c.line(p([hip, (0.42, 0.66), (0.4, 0.82), (0.33, 0.83)]), thick, value)
    c.line(p([hip, (0.63, 0.75), (0.78, 0.84)]), thick, value)


def exit_door(rng, size):
    """The green door with the man in it: 255 where the sign's ink is."""
    c = Canvas(size)
    kind = rng.integers(4)
    if kind == 0:  # man in an open door, white man on ink
        c.box(0.02, 0.02, 0.98, 0.98)
        running_man(c, rng, 0, rng.uniform(0.9, 1.05))
    elif kind == 1:  # ink frame, light doorway, ink man
        c.box(0.02, 0.02, 0.98, 0.98)
        left = rng.uniform(0.12, 0.22)
        c.polygon([(left, 0.1), (0.86, 0.1), (0.86, 1.0), (left + 0.05, 1.0)], 0)
        running_man(c, rng, 255, rng.uniform(0.85, 1.0))
    elif kind == 2:  # light doorway at one side, man running into it
        c.box(0.0, 0.0, 1.0, 1.0)
        c.polygon([(0.05, 0.08), (0.45, 0.08), (0.45, 0.9), (0.05, 0.9)], 0)
        man = Canvas(size)
        running_man(man, rng, 255, 1.0, (0.03, 0.0))
        c.mask = cv2.absdiff(c.mask, man.mask)
    else:  # ink man alone before a frame of ink
        c.line([(0.12, 1.0), (0.12, 0.06), (0.88, 0.06), (0.88, 1.0)], rng.uniform(0.05, 0.12))
        running_man(c, rng, 255, rng.uniform(0.85, 1.0))
    return c.mask


def arrow(rng, size, turn=None):
    c = Canvas(size)
    thick = rng.uniform(0.1, 0.2)
    head = rng.uniform(0.22, 0.36)
    if rng.random() < 0.5:
        c.line([(0.12, 0.5), (0.85, 0.5)], thick)
        c.line([(0.85 - head, 0.5 - head), (0.86, 0.5), (0.85 - head, 0.5 + head)], thick)
    else:
        c.polygon([(0.1, 0.5 - thick / 2), (0.5, 0.5 - thick / 2), (0.5, 0.5 - head), (0.92, 0.5),
                   (0.5, 0.5 + head), (0.5, 0.5 + thick / 2), (0.1, 0.5 + thick / 2)])
    turns = int(rng.integers(4)) if turn is None else turn
    return np.ascontiguousarray(np.rot90(c.mask, turns))


def letters(rng, height, word=None):
    word = word or str(rng.choice(WORDS))
    face = int(rng.choice([cv2.FONT_HERSHEY_SIMPLEX, cv2.FONT_HERSHEY_DUPLEX, cv2.FONT_HERSHEY_COMPLEX]))
    thick = int(rng.integers(2, 6))
    (w, h), base = cv2.getTextSize(word, face, 1.6, thick)
    mask = np.zeros((h + base + 8, w + 8), np.uint8)
    cv2.putText(mask, word, (4, h + 4), face, 1.6, 255, thick, cv2.LINE_AA)
    return cv2.resize(mask, (max(4, round(mask.shape[1] * height / mask.shape[0])), height), interpolation=cv2.INTER_AREA)


def square_letters(rng, height, count=4):
    """Strokes in squares, as words of Chinese characters look from afar."""
    mask = np.zeros((height, height * count), np.uint8)
    for i in range(count):
        for _ in range(int(rng.integers(4, 9))):
            a = rng.uniform(0.1, 0.9, 2) * height
            b = a + (rng.uniform(-0.7, 0.7) * height, 0) if rng.random() < 0.5 else a + (0, rng.uniform(-0.7, 0.7) * height)
            b = np.clip(b, 0.08 * height, 0.92 * height)
            cv2.line(mask, (int(a[0]) + i * height, int(a[1])), (int(b[0]) + i * height, int(b[1])), 255,
                     max(1, height // 12), cv2.LINE_AA)
    return mask


def person(c, x, y, h, skirt=False, value=255):
    w = h * 0.34
    c.disc((x, y + 0.09 * h), 0.085 * h, value)
    top, bottom = y + 0.2 * h, y + h
    if skirt:
        c.polygon([(x - 0.14 * h, top), (x + 0.14 * h, top), (x + 0.25 * h, y + 0.66 * h), (x - 0.25 * h, y + 0.66 * h)], value)
        c.box(x - 0.1 * h, y + 0.6 * h, x - 0.02 * h, bottom, value)
        c.box(x + 0.02 * h, y + 0.6 * h, x + 0.1 * h, bottom, value)
        c.line([(x - 0.15 * h, top + 0.03 * h), (x - 0.24 * h, y + 0.52 * h)], 0.06 * h, value)
        c.line([(x + 0.15 * h, top + 0.03 * h), (x + 0.24 * h, y + 0.52 * h)], 0.06 * h, value)
    else:
        c.box(x - w / 2.2, top, x + w / 2.2, y + 0.56 * h, value)
        c.box(x - 0.13 * h, y + 0.5 * h, x - 0.015 * h, bottom, value)
        c.box(x + 0.015 * h, y + 0.5 * h, x + 0.13 * h, bottom, value)
        c.line([(x - 0.19 * h, top + 0.04 * h), (x - 0.19 * h, y + 0.56 * h)], 0.07 * h, value)
        c.line([(x + 0.19 * h, top + 0.04 * h), (x + 0.19 * h, y + 0.56 * h)], 0.07 * h, value)


def wheelchair(c, rng, at=(0.5, 0.5), s=1.0, value=255):
    def p(points):
        return (shaken(rng, points, 0.006) - 0.5) * s + np.asarray(at)
    t = 0.075 * s
    c.disc(p([(0.42, 0.16)])[0], 0.075 * s, value)
    c.line(p([(0.42, 0.28), (0.46, 0.56), (0.68, 0.56), (0.76, 0.8), (0.84, 0.78)]), t, value)
    c.line(p([(0.44, 0.4), (0.64, 0.4)]), t * 0.8, value)
    centre = c.px(p([(0.48, 0.66)])[0])
    radius = int(0.22 * s * c.size * 16)
    cv2.ellipse(c.mask, tuple(centre.tolist()), (radius, radius), 0, 20, 250, value, max(1, round(t * 0.8 * c.size)),
                cv2.LINE_AA, 4)


def toilet(rng, size):
    c = Canvas(size)
    kind = rng.integers(5)
    if kind == 0:
        person(c, 0.5, 0.12, 0.76, False)
    elif kind == 1:
        person(c, 0.5, 0.12, 0.76, True)
    elif kind == 2:
        wheelchair(c, rng)
    else:
        person(c, 0.28, 0.14, 0.7, False)
        person(c, 0.72, 0.14, 0.7, True)
        if kind == 3:
            c.line([(0.5, 0.12), (0.5, 0.88)], 0.03)
    return c.mask


def stairs(rng, size):
    c = Canvas(size)
    steps = int(rng.integers(4, 7))
    x0, y0, x1, y1 = 0.1, 0.86, 0.92, 0.3
    points = [(x0, y0)]
    for i in range(steps):
        y = y0 + (y1 - y0) * (i + 1) / steps
        points += [(x0 + (x1 - x0) * i / steps, y), (x0 + (x1 - x0) * (i + 1) / steps, y)]
    if rng.random() < 0.5:
        c.polygon(points + [(x1, y0)])
    else:
        c.line(points, 0.06)
    if rng.random() < 0.6:
        person(c, 0.36, 0.08, 0.48)
    else:
        c.line([(0.14, 0.56), (0.5, 0.2)], 0.06)
        c.line([(0.34, 0.18), (0.52, 0.18), (0.52, 0.36)], 0.06)
    return c.mask


def lift(rng, size):
    c = Canvas(size)
    if rng.random() < 0.6:
        c.box(0.14, 0.3, 0.86, 0.92)
        c.box(0.19, 0.35, 0.81, 0.88, 0)
    else:
        c.box(0.14, 0.3, 0.86, 0.92)
    value = 255 if c.mask[c.size // 2, c.size // 2] == 0 else 0
    many = int(rng.integers(1, 4))
    for i in range(many):
        person(c, 0.5 + (i - (many - 1) / 2) * 0.2, 0.4, 0.44, bool(rng.random() < 0.3), value)
    for x, up in ((0.36, True), (0.64, False)):
        ys = (0.22, 0.06) if up else (0.08, 0.24)
        c.polygon([(x - 0.1, ys[0]), (x + 0.1, ys[0]), (x, ys[1])])
    return c.mask


def extinguisher(rng, size):
    c = Canvas(size)
    x = rng.uniform(0.36, 0.5)
    w = rng.uniform(0.1, 0.13)
    c.polygon([(x - w, 0.36), (x - w * 0.5, 0.27), (x + w * 0.5, 0.27), (x + w, 0.36), (x + w, 0.9), (x - w, 0.9)])
    c.box(x - 0.035, 0.16, x + 0.035, 0.3)
    c.line([(x - 0.12, 0.13), (x + 0.1, 0.17)], 0.05)
    c.line([(x, 0.2), (x + 0.18, 0.24), (x + 0.24, 0.42), (x + 0.25, 0.6)], 0.045)
    if rng.random() < 0.75:  # the flame
        f = np.array([(0.84, 0.9), (0.72, 0.8), (0.7, 0.62), (0.78, 0.68), (0.8, 0.46), (0.92, 0.62), (0.96, 0.78), (0.92, 0.88)])
        c.polygon(shaken(rng, f, 0.01))
    return c.mask


def other_mask(rng, size):
    """What is not one of the signs: crosses, letters, telephones, assembly points, hoses, blobs."""
    c = Canvas(size)
    kind = rng.integers(7)
    if kind == 0:
        c.box(0.4, 0.12, 0.6, 0.88)
        c.box(0.12, 0.4, 0.88, 0.6)
    elif kind == 1:
        return arrow(rng, size)
    elif kind == 2:
        word = letters(rng, int(size * 0.55), str(rng.choice(list("PABCDEFH0123456789i?"))))
        h, w = min(size, word.shape[0]), min(size, word.shape[1])
        y, x = (size - h) // 2, (size - w) // 2
        c.mask[y:y + h, x:x + w] = word[:h, :w]
    elif kind == 3:  # four people and arrows from the corners
        for x in (0.4, 0.5, 0.6):
            person(c, x, 0.38, 0.26)
        for x, y in ((0.1, 0.1), (0.9, 0.1), (0.1, 0.9), (0.9, 0.9)):
            c.line([(x, y), (0.5 + (x - 0.5) * 0.5, 0.5 + (y - 0.5) * 0.5)], 0.07)
    elif kind == 4:
        c.disc((0.5, 0.5), 0.33)
        c.disc((0.5, 0.5), rng.uniform(0.1, 0.28), 0)
    elif kind == 5:
        c.polygon(rng.uniform(0.1, 0.9, (int(rng.integers(3, 8)), 2)))
    else:
        for _ in range(int(rng.integers(2, 6))):
            c.line(rng.uniform(0.1, 0.9, (int(rng.integers(2, 4)), 2)), rng.uniform(0.03, 0.12))
    return c.mask


def green(rng):
    hue, sat, val = rng.uniform(60, 92), rng.uniform(140, 255), rng.uniform(60, 220)
    return hsv(hue, sat, val)


def hsv(h, s, v):
    return cv2.cvtColor(np.uint8([[[h % 180, s, v]]]), cv2.COLOR_HSV2BGR)[0, 0].astype(np.float32)


def white(rng):
    return np.float32(rng.uniform(185, 255)) + rng.normal(0, 6, 3).astype(np.float32)


def inked(mask, ink, ground):
    a = (mask.astype(np.float32) / 255.0)[..., None]
    return ground * (1 - a) + ink * a


def bordered(rng, picture, colour, share):
    b = max(1, int(picture.shape[0] * share))
    return cv2.copyMakeBorder(picture, b, b, b, b, cv2.BORDER_CONSTANT, value=[float(x) for x in colour])


def strip(rng, parts, height, ground):
    """Masks side by side, or one above the other in a column of their own, on one ground."""
    gap = int(height * rng.uniform(0.05, 0.25))
    widths = [p.shape[1] for p in parts]
    total = sum(widths) + gap * (len(parts) + 1)
    mask = np.zeros((height, total), np.uint8)
    x = gap
    for part in parts:
        y = (height - part.shape[0]) // 2
        mask[y:y + part.shape[0], x:x + part.shape[1]] = part
        x += part.shape[1] + gap
    return mask


def lit(rng, picture):
    """Light from a lamp above or behind the panel."""
    h, w = picture.shape[:2]
    kind = rng.integers(3)
    if kind == 0:
        return picture
    y = np.linspace(0, 1, h, dtype=np.float32)[:, None, None]
    x = np.linspace(0, 1, w, dtype=np.float32)[None, :, None]
    gain = rng.uniform(0.75, 1.0) + rng.uniform(0.0, 0.6) * (np.exp(-3 * y) if kind == 1 else np.exp(-8 * (x - rng.random()) ** 2))
    return picture * gain


def housing(rng, picture):
    """The lamp's case above the panel, or a frame round it."""
    h, w = picture.shape[:2]
    grey = np.float32(rng.uniform(50, 220)) + rng.normal(0, 5, 3).astype(np.float32)
    kind = rng.random()
    if kind < 0.45:
        bar = np.empty((max(2, int(h * rng.uniform(0.15, 0.5))), w, 3), np.float32)
        bar[:] = grey * np.linspace(rng.uniform(0.8, 1.2), rng.uniform(0.8, 1.2), bar.shape[0], dtype=np.float32)[:, None, None]
        return np.vstack([bar, picture])
    if kind < 0.7:
        return bordered(rng, picture, grey, rng.uniform(0.03, 0.15))
    return picture


def panel_of(rng, masks, height):
    ink, ground = green(rng), white(rng)
    if rng.random() < 0.5:
        ink, ground = ground, ink
    picture = inked(strip(rng, masks, height, ground), ink, ground)
    if rng.random() < 0.3:
        picture = bordered(rng, picture, white(rng) if rng.random() < 0.7 else green(rng), 0.04)
    return housing(rng, lit(rng, picture))


def words(rng, height):
    if rng.random() < 0.5:
        return square_letters(rng, int(height * rng.uniform(0.2, 0.45)), int(rng.integers(2, 5)))
    return letters(rng, int(height * rng.uniform(0.2, 0.5)))


def man_mask(rng, size):
    mask = exit_door(rng, size)
    if rng.random() < 0.5:
        mask = mask[:, ::-1].copy()
    if rng.random() < 0.6:
        mask = cv2.resize(mask, (int(size * rng.uniform(0.75, 1.1)), size), interpolation=cv2.INTER_AREA)
    return 255 - mask if rng.random() < 0.3 else mask


def draw_exit(rng):
    height = 150
    inner = int(height * rng.uniform(0.75, 0.96))
    parts = [man_mask(rng, inner)]
    extras = rng.choice(5, p=[0.22, 0.33, 0.15, 0.2, 0.1])
    if extras in (1, 3):
        side = arrow(rng, int(inner * rng.uniform(0.6, 1.0)))
        parts = [side] + parts if rng.random() < 0.5 else parts + [side]
    if extras in (2, 3):
        side = words(rng, inner)
        parts = [side] + parts if rng.random() < 0.5 else parts + [side]
    if extras == 4:  # a long panel with empty ground at one side
        blank = np.zeros((4, int(inner * rng.uniform(0.4, 1.2))), np.uint8)
        parts = [blank] + parts + [words(rng, inner)]
    return panel_of(rng, parts, height)


def draw_square(rng, kind):
    size = 150
    mask = {EXTINGUISHER: extinguisher, TOILET: toilet, STAIRS: stairs, LIFT: lift}[kind](rng, size)
    if rng.random() < 0.5 and kind != TOILET:
        mask = mask[:, ::-1].copy()
    if kind == EXTINGUISHER:
        ink, ground = white(rng), hsv(rng.normal(0, 4), rng.uniform(170, 255), rng.uniform(110, 240))
    else:
        dark = [hsv(rng.uniform(100, 120), rng.uniform(120, 255), rng.uniform(60, 200)), hsv(0, 0, rng.uniform(10, 80)),
                green(rng), hsv(rng.uniform(0, 180), rng.uniform(60, 200), rng.uniform(40, 150))]
        ink, ground = white(rng), dark[int(rng.choice(4, p=[0.4, 0.35, 0.1, 0.15]))]
        if rng.random() < 0.45:
            ink, ground = ground, ink
    picture = inked(mask, ink, ground)
    if rng.random() < 0.5:
        picture = bordered(rng, picture, ink if rng.random() < 0.6 else ground, rng.uniform(0.02, 0.06))
    return lit(rng, picture)


def draw_other(rng):
    """A sign-like panel that is none of the kinds."""
    height = 150
    if rng.random() < 0.5:
        inner = int(height * 0.8)
        parts = []
        for _ in range(int(rng.integers(1, 4))):
            which = rng.integers(3)
            parts.append(words(rng, inner) if which == 0 else other_mask(rng, inner) if which == 1 else arrow(rng, inner))
        return panel_of(rng, parts, height)
    mask = other_mask(rng, height)
    colours = [green(rng), hsv(rng.normal(0, 5), rng.uniform(150, 255), rng.uniform(100, 240)),
               hsv(rng.uniform(100, 120), rng.uniform(120, 255), rng.uniform(60, 200)), hsv(0, 0, rng.uniform(10, 90)),
               hsv(rng.uniform(15, 30), 220, 230)]
    ink, ground = white(rng), colours[int(rng.integers(len(colours)))]
    if rng.random() < 0.4:
        ink, ground = ground, ink
    picture = inked(mask, ink, ground)
    if rng.random() < 0.4:
        picture = bordered(rng, picture, ink, 0.04)
    return lit(rng, picture)
