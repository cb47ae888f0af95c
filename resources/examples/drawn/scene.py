"""Turns the plan into panels and lamps: walls with doors let into them, floors, ceilings, furniture, landmarks."""
import cv2
import numpy as np

import posters
from building import ACCESSES, CEILING, DOOR_TALL, LANDMARKS, REGIONS, WINDOWS
from render import Panel

UP = np.array([0.0, 0.0, 1.0])
_textures = {}


def texture(name):
    """Every drawn surface is made once and shared."""
    if name not in _textures:
        kind, _, detail = name.partition(":")
        _textures[name] = MAKERS[kind](detail) if detail else MAKERS[kind]()
    return _textures[name]


def mottled(size, colour, strength, softness, seed):
    noise = np.random.RandomState(seed).normal(0, 1, (size, size)).astype(np.float32)
    noise = cv2.GaussianBlur(np.tile(noise, (3, 3)), (0, 0), softness)[size:2 * size, size:2 * size]
    return np.clip(np.array(colour) + strength * (noise / noise.std())[..., None], 0, 255).astype(np.uint8)


def wall(dado):
    """A 2.7 m high strip of wall that repeats sideways: plaster, a coloured lower part, a rail, a skirting board."""
    colours = {"hall": (168, 190, 206), "long-corridor": (176, 160, 120), "north-corridor": (130, 170, 176),
               "library": (150, 178, 158), "side-corridor": (150, 150, 186)}
    image = mottled(540, (218, 228, 232), 0.9, 14, 21)
    lower = mottled(540, colours.get(dado, (190, 190, 190)), 0.9, 14, 22)
    metre = 540 / 2.7
    image[int(1.7 * metre):] = lower[int(1.7 * metre):]
    cv2.rectangle(image, (0, int(1.7 * metre)), (540, int(1.7 * metre) + 3), (235, 240, 240), -1)
    if dado.endswith("corridor"):
        cv2.rectangle(image, (0, int(1.76 * metre)), (540, int(1.83 * metre)), (84, 120, 160), -1)
        cv2.rectangle(image, (0, int(1.83 * metre)), (540, int(1.85 * metre)), (70, 80, 90), -1)
    cv2.rectangle(image, (0, int(2.58 * metre)), (540, 540), (92, 96, 104), -1)
    return image


def floor(kind):
    if kind == "library":
        image = blank_planks()
    elif kind == "hall":
        image = mottled(480, (178, 186, 190), 7, 1.2, 23)
        for k in (0, 240):
            cv2.line(image, (k, 0), (k, 480), (140, 146, 150), 3)
            cv2.line(image, (0, k), (480, k), (140, 146, 150), 3)
        image[:240, :240] = np.clip(image[:240, :240] * 0.9, 0, 255)
        image[240:, 240:] = np.clip(image[240:, 240:] * 0.9, 0, 255)
    else:
        image = mottled(480, (150, 152, 146), 5, 1.4, 24)
    return image


def blank_planks():
    random = np.random.RandomState(25)
    image = np.zeros((480, 480, 3), np.uint8)
    for row in range(8):
        x = -int(random.uniform(0, 200))
        while x < 480:
            wide = int(random.uniform(140, 260))
            shade = random.uniform(0.86, 1.06)
            cv2.rectangle(image, (x, row * 60), (x + wide, row * 60 + 59), tuple(int(c * shade) for c in (92, 136, 176)), -1)
            cv2.line(image, (x, row * 60), (x, row * 60 + 59), (70, 104, 138), 2)
            x += wide
        cv2.line(image, (0, row * 60), (480, row * 60), (70, 104, 138), 2)
    return image


def ceiling():
    image = mottled(240, (232, 234, 234), 2, 1.0, 26)
    cv2.rectangle(image, (0, 0), (239, 239), (196, 198, 198), 2)
    return image


def lamp():
    image = np.full((60, 240, 3), (250, 252, 252), np.uint8)
    cv2.rectangle(image, (0, 0), (239, 59), (200, 204, 204), 3)
    return image


def door(label):
    """A closed leaf in its frame, as seen from a corridor; 1.06 of the leaf's width, 1.04 of its height."""
    image = np.full((900, 430, 3), (186, 196, 200), np.uint8)
    leaf = mottled(900, (52, 70, 96), 4, 5, 27 + len(label))[:, :370]
    grain = cv2.resize(np.random.RandomState(31).normal(0, 5, (12, 370)).astype(np.float32), (370, 900))
    image[36:, 30:400] = np.clip(leaf[36:] + grain[36:, :, None], 0, 255)
    cv2.rectangle(image, (0, 0), (429, 899), (120, 128, 132), 3)
    cv2.rectangle(image, (29, 35), (401, 899), (40, 44, 48), 3)
    cv2.rectangle(image, (36, 800), (394, 886), (150, 152, 154), -1)
    cv2.rectangle(image, (346, 440), (372, 540), (170, 174, 176), -1)
    cv2.rectangle(image, (300, 470), (366, 482), (205, 208, 210), -1)
    posters.disc(image, 359, 518, 6, (40, 40, 40))
    if label == "entrance":
        for x in (50, 225):
            cv2.rectangle(image, (x, 60), (x + 150, 780), (226, 214, 196), -1)
            cv2.rectangle(image, (x, 60), (x + 150, 780), (90, 96, 100), 5)
    else:
        cv2.rectangle(image, (280, 120), (340, 400), (196, 186, 170), -1)
        cv2.rectangle(image, (280, 120), (340, 400), (40, 50, 64), 5)
    return image


def window():
    random = np.random.RandomState(33)
    image = posters.gradient(720, 540, (250, 226, 196), (250, 244, 236))
    for layer, colour in enumerate([(170, 196, 168), (120, 166, 124), (84, 136, 90)]):
        for _ in range(26):
            posters.disc(image, random.uniform(-20, 740), 400 + 50 * layer + random.uniform(-40, 60), random.uniform(30, 70), colour)
    image = cv2.GaussianBlur(image, (0, 0), 4)
    cv2.rectangle(image, (0, 0), (719, 539), (236, 238, 238), 34)
    cv2.rectangle(image, (352, 0), (368, 539), (236, 238, 238), -1)
    cv2.rectangle(image, (16, 16), (703, 523), (180, 184, 186), 2)
    return image


def books():
    """Shelves at the far end of the library: many books of quiet colours, softly drawn."""
    random = np.random.RandomState(34)
    image = np.full((660, 600, 3), (60, 84, 108), np.uint8)
    for row in range(5):
        x = 16
        while x < 570:
            w, h = int(random.uniform(9, 24)), int(random.uniform(76, 108))
            colour = np.array([96, 108, 124]) + random.randint(-44, 44, 3)
            cv2.rectangle(image, (x, 126 * row + 122 - h), (min(x + w - 2, 582), 126 * row + 122), tuple(int(c) for c in colour), -1)
            x += w
        cv2.rectangle(image, (8, 126 * row + 122), (592, 126 * row + 132), (84, 120, 156), -1)
    return cv2.GaussianBlur(image, (0, 0), 1.2)


def plain(colour):
    return mottled(64, tuple(int(v) for v in colour.split(",")), 2, 6, 35)


MAKERS = {"wall": wall, "floor": floor, "ceiling": ceiling, "lamp": lamp, "door": door, "window": window, "books": books,
          "plain": plain, "number": posters.room_sign, "template": lambda name: posters.TEMPLATES[name]()}


def upright(a, b, low, high, picture, room, off=0.0, **more):
    """A vertical panel from a (its left as seen from its front) to b, moved `off` metres to its front."""
    a, b = np.array([*a, high], float), np.array([*b, high], float)
    along = (b - a) / np.linalg.norm(b - a)
    front = np.cross(-UP, along)
    return Panel(a + off * front, b - a, UP * (low - high), texture(picture), room, **more)


def box(west, south, east, north, low, high, side, top, room):
    ring = [(west, south), (east, south), (east, north), (west, north)]
    panels = [upright(ring[k], ring[(k + 1) % 4], low, high, side, room) for k in range(4)]
    panels.append(Panel((west, north, high), (east - west, 0, 0), (0, south - north, 0), texture(top), room))
    return panels


def accesses_on(a, b):
    """Accesses in the wall from a to b, as shares of its length, in order."""
    a, b = np.array(a), np.array(b)
    length, found = np.linalg.norm(b - a), []
    along = (b - a) / length
    for name, (kind, _, _, p, q, is_open) in ACCESSES.items():
        ends = []
        for point in (p, q):
            offset = np.array(point) - a
            if abs(offset[0] * along[1] - offset[1] * along[0]) < 0.01:
                ends.append(offset @ along)
        if len(ends) == 2 and min(ends) > -0.01 and max(ends) < length + 0.01:
            found.append((min(ends), max(ends), name, kind, is_open))
    return sorted(found), along


def walls_of(room):
    """The inner faces of a region, clockwise, so that each panel's front looks into the region."""
    west, south, east, north = REGIONS[room][3:]
    ring, panels = [(west, south), (west, north), (east, north), (east, south)], []
    skin = "wall:" + room
    for k in range(4):
        a, b = np.array(ring[k]), np.array(ring[(k + 1) % 4])
        found, along = accesses_on(a, b)
        at = 0.0
        for begin, end, name, kind, is_open in found:
            if begin - at > 0.01:
                panels.append(upright(a + along * at, a + along * begin, 0, CEILING, skin, room, repeat=CEILING))
            p, q = a + along * begin, a + along * end
            head = 2.45 if kind == "opening" else DOOR_TALL
            panels.append(upright(p, q, head, CEILING, skin, room, repeat=CEILING))
            if kind == "door":
                panels += door_panels(p, q, along, name, is_open, room)
            at = end
        if np.linalg.norm(b - a) - at > 0.01:
            panels.append(upright(a + along * at, b, 0, CEILING, skin, room, repeat=CEILING))
    return panels


def door_panels(p, q, along, name, is_open, room):
    wide, frame = np.linalg.norm(q - p), "plain:186,196,200"
    if not is_open:
        return [upright(p - along * 0.03 * wide, q + along * 0.03 * wide, 0, DOOR_TALL * 1.04, "door:" + name, room, off=0.012)]
    panels = [upright(p - along * 0.08, p, 0, DOOR_TALL + 0.08, frame, room, off=0.012),
              upright(q, q + along * 0.08, 0, DOOR_TALL + 0.08, frame, room, off=0.012),
              upright(p, q, DOOR_TALL, DOOR_TALL + 0.08, frame, room, off=0.012)]
    if room == "library":  # the leaf stands open into the room
        into = np.array([along[1], -along[0]])
        panels.append(upright(p, p + into * wide, 0, DOOR_TALL, "door:" + name, room, two_sided=True))
    return panels


def shell(room):
    west, south, east, north = REGIONS[room][3:]
    gloss = 0.03 if room == "library" else 0.13
    panels = walls_of(room)
    panels.append(Panel((west, north, 0), (east - west, 0, 0), (0, south - north, 0), texture("floor:" + room), room,
                        repeat=1.2, mirror=gloss))
    panels.append(Panel((west, south, CEILING), (east - west, 0, 0), (0, north - south, 0), texture("ceiling"), room, repeat=0.6))
    for left, right, sill, head in WINDOWS.get(room, []):
        panels.append(upright(left, right, sill, head, "window", room, off=0.015, glow=1.25))
    return panels


def lamps_of(room):
    """Long lamps in rows under the ceiling; returns their panels and the places they shine from."""
    west, south, east, north = REGIONS[room][3:]
    across, along = max(1, round((north - south) / 2.4)), max(1, round((east - west) / 2.4))
    panels, lights = [], []
    for i in range(along):
        for j in range(across):
            x, y = west + (i + 0.5) * (east - west) / along, south + (j + 0.5) * (north - south) / across
            panels.append(Panel((x - 0.6, y - 0.15, CEILING - 0.02), (1.2, 0, 0), (0, 0.3, 0), texture("lamp"), room, glow=1.9))
            lights.append((np.array([x, y, CEILING - 0.1]), np.array([0.95, 1.0, 1.03], np.float32)))
    return panels, lights


def landmark_panel(name):
    _, template, words, room, x, y, faces, middle, wide, tall = LANDMARKS[name]
    out = np.array([np.cos(np.radians(faces)), np.sin(np.radians(faces))])
    left = np.array([out[1], -out[0]]) * 0.5 * wide  # as seen by someone who stands in front of it
    if template:
        picture = "template:" + template
    else:
        picture = "number:" + words
    return upright((x + left[0], y + left[1]), (x - left[0], y - left[1]), middle - tall / 2, middle + tall / 2, picture, room,
                   off=0.025, name=name)


def furniture():
    wood, pale, dark = "plain:70,104,140", "plain:150,176,196", "plain:72,74,80"
    panels = box(3.2, 0.1, 4.6, 0.75, 0, 1.05, wood, pale, "hall")
    panels += box(2.4, 5.5, 4.2, 5.95, 0, 0.45, "plain:110,70,50", "plain:140,92,66", "hall")
    for south in (5.3, 9.8):
        panels += box(22.1, south, 22.5, south + 1.5, 0, 2.0, "books", dark, "library")
    for west in (20.3,):
        panels += box(west, 7.6, west + 1.0, 9.4, 0.70, 0.75, wood, pale, "library")
        for x in (west + 0.05, west + 0.87):
            for y in (7.65, 9.27):
                panels += box(x, y, x + 0.08, y + 0.08, 0, 0.70, dark, dark, "library")
    return panels


def hung():
    """The back of the projecting sign and the exit sign's, and the rods that hold them."""
    grey = "plain:150,154,158"
    return [upright((13.20, 3.83), (13.20, 4.33), 1.70, 2.20, "template:cafe", "long-corridor"),
            upright((15.6, 9.5), (14.8, 9.5), 2.15, 2.49, grey, "north-corridor"),
            upright((14.95, 9.48), (14.97, 9.48), 2.49, CEILING, grey, "north-corridor", two_sided=True),
            upright((15.43, 9.48), (15.45, 9.48), 2.49, CEILING, grey, "north-corridor", two_sided=True)]


def build():
    panels, lamps = [], {}
    for room in REGIONS:
        if REGIONS[room][2] == "outside":
            continue
        panels += shell(room)
        shining, lamps[room] = lamps_of(room)
        panels += shining
    panels += furniture() + hung()
    panels += [landmark_panel(name) for name in LANDMARKS]
    return panels, lamps
