"""The pictures on the walls of the drawn building: posters, boards, signs and plates, each of our own making and each
with a texture of its own. Every function returns an 8-bit BGR picture; the same every time (seeded)."""
import cv2
import numpy as np

FONT_FOLDER = "/usr/share/fonts/truetype/dejavu/"  # Debian package fonts-dejavu-core
_fonts = {}


def text(image, words, x, y, height, colour, font="DejaVuSans-Bold", centre=False):
    """Writes with the baseline-free box's top left (or top middle) at x, y."""
    if font not in _fonts:
        _fonts[font] = cv2.freetype.createFreeType2()
        _fonts[font].loadFontData(FONT_FOLDER + font + ".ttf", 0)
    if centre:
        x -= _fonts[font].getTextSize(words, height, -1)[0][0] / 2
    _fonts[font].putText(image, words, (int(x), int(y)), height, colour, -1, cv2.LINE_AA, False)


def blank(width, height, colour):
    return np.full((height, width, 3), colour, np.uint8)


def gradient(width, height, top, bottom):
    share = np.linspace(0, 1, height)[:, None, None]
    column = np.array(top) * (1 - share) + np.array(bottom) * share
    return np.repeat(column, width, axis=1).astype(np.uint8)


def polygon(image, points, colour):
    cv2.fillPoly(image, [np.round(np.array(points, float) * 16).astype(np.int32)], colour, cv2.LINE_AA, 4)


def disc(image, x, y, radius, colour, thickness=-1):
    cv2.circle(image, (int(x * 16), int(y * 16)), max(1, int(radius * 16)), colour, thickness, cv2.LINE_AA, 4)


def border(image, colour, thickness):
    height, width = image.shape[:2]
    cv2.rectangle(image, (0, 0), (width - 1, height - 1), colour, 2 * thickness)
    return image


def paragraph(image, random, x, y, width, lines, pitch, colour, weight=None):
    """Lines of print too small to be read: strokes of word length."""
    weight = weight or max(2, pitch // 3)
    for line in range(lines):
        at, end = x, x + width * (random.uniform(0.5, 0.8) if line == lines - 1 else random.uniform(0.9, 1.0))
        while at < end - 8:
            word = random.uniform(14, 60)
            stop = min(at + word, end)
            for stroke in np.arange(at, stop, 7):
                tall = weight * random.choice([1.0, 1.0, 1.0, 1.7])
                cv2.rectangle(image, (int(stroke), int(y + line * pitch - tall)),
                              (int(min(stroke + 4, stop)), int(y + line * pitch)), colour, -1)
            at = stop + 10


def welcome():
    random = np.random.RandomState(1)
    image = blank(1080, 810, (232, 238, 240))
    cv2.rectangle(image, (0, 0), (1080, 190), (122, 66, 28), -1)
    text(image, "WELCOME", 50, 38, 118, (255, 255, 255))
    for k in range(14):  # a lighthouse and its rays
        angle = np.radians(-100 + 14.3 * k)
        polygon(image, [(930, 70), (930 + 260 * np.cos(angle), 70 + 260 * np.sin(angle)),
                        (930 + 260 * np.cos(angle + 0.1), 70 + 260 * np.sin(angle + 0.1))], (96, 190, 250))
    cv2.rectangle(image, (700, 190), (1080, 810), (232, 238, 240), -1)
    polygon(image, [(905, 180), (955, 180), (945, 60), (915, 60)], (240, 240, 250))
    for k in range(3):
        polygon(image, [(908 + 2 * k, 160 - 34 * k), (952 - 2 * k, 160 - 34 * k), (950 - 2 * k, 142 - 34 * k),
                        (910 + 2 * k, 142 - 34 * k)], (50, 50, 200))
    for k, (x, y, w, h) in enumerate([(60, 240, 250, 170), (310, 240, 150, 90), (310, 330, 150, 80), (60, 410, 130, 190),
                                      (190, 410, 120, 100), (190, 510, 120, 90), (310, 410, 150, 190),
                                      (460, 240, 180, 120), (460, 360, 180, 240)]):
        colour = [(176, 214, 244), (200, 230, 190), (230, 205, 176), (205, 190, 235), (170, 225, 235)][k * 3 % 5]
        cv2.rectangle(image, (x, y), (x + w, y + h), colour, -1)
        cv2.rectangle(image, (x, y), (x + w, y + h), (70, 50, 40), 5, cv2.LINE_AA)
        disc(image, x + w * 0.3 + 6 * k, y + h * 0.5, 11, (40 + 22 * k, 60, 170))
    cv2.polylines(image, [np.array([(90, 640), (90, 385), (330, 385), (385, 450), (385, 560), (560, 560)])], False,
                  (30, 30, 210), 7, cv2.LINE_AA)
    for k in range(7):
        colour = [(60, 60, 200), (180, 110, 40), (70, 150, 70), (40, 140, 230)][k % 4]
        polygon(image, [(715, 240 + 78 * k), (765, 225 + 78 * k), (765, 275 + 78 * k)], colour)
        paragraph(image, random, 790, 250 + 78 * k, 240, 2, 26, (60, 50, 40), 12)
    paragraph(image, random, 60, 690, 580, 4, 28, (90, 80, 70))
    return border(image, (70, 50, 40), 10)


def timetable():
    random = np.random.RandomState(2)
    image = blank(630, 880, (246, 246, 244))
    cv2.rectangle(image, (0, 0), (630, 120), (60, 120, 40), -1)
    text(image, "TIMETABLE", 315, 26, 74, (255, 255, 255), centre=True)
    palette = [(150, 205, 255), (175, 230, 180), (240, 200, 160), (200, 180, 245), (150, 240, 250), (215, 215, 215)]
    for column in range(5):
        x, y = 70 + column * 108, 190
        text(image, "MTWTF"[column], x + 50, 138, 40, (40, 70, 30), centre=True)
        while y < 830:
            tall = int(random.choice([46, 64, 92, 120]))
            tall = min(tall, 850 - y)
            if random.rand() < 0.8:
                cv2.rectangle(image, (x, y), (x + 102, y + tall - 5), palette[random.randint(6)], -1)
                cv2.rectangle(image, (x, y), (x + 10, y + tall - 5), tuple(int(v) for v in random.randint(20, 160, 3)), -1)
                paragraph(image, random, x + 18, y + 22, 74, max(1, tall // 28), 20, (50, 50, 50), 9)
            y += tall
    for hour in range(12):
        y = 190 + hour * 55
        cv2.line(image, (20, y), (54, y), (90, 90, 90), 3)
        paragraph(image, random, 22, y + 28, 34, 1, 18, (60, 60, 60), 12)
    return border(image, (50, 70, 40), 8)


def ocean():
    random = np.random.RandomState(3)
    image = gradient(640, 900, (205, 150, 60), (70, 30, 12))
    for k in range(9):
        x = random.uniform(0, 640)
        layer = image.copy()
        polygon(layer, [(x, 0), (x + 50, 0), (x + 160, 620), (x + 20, 620)], (235, 205, 140))
        image = cv2.addWeighted(layer, 0.22, image, 0.78, 0)
    for k, (x, y, size, colour) in enumerate([(330, 340, 1.0, (70, 50, 30)), (180, 560, 0.55, (96, 66, 40))]):
        body = [(x + size * (-230 + 20 * t), y - size * 82 * np.sin(np.pi * (t / 23) ** 0.7)) for t in range(24)]
        body += [(x + size * (230 - 20 * t), y + size * 62 * np.sin(np.pi * (1 - t / 23) ** 1.3)) for t in range(24)]
        polygon(image, body, colour)
        polygon(image, [(x + size * 215, y), (x + size * 300, y - size * 80), (x + size * 268, y),
                        (x + size * 305, y + size * 70)], colour)
        polygon(image, [(x - size * 60, y + size * 40), (x + size * 10, y + size * 140), (x + size * 30, y + size * 40)],
                (50, 36, 22))
        for line in range(5):
            cv2.line(image, (int(x - size * 210), int(y + size * (8 + 9 * line))),
                     (int(x - size * (60 - 14 * line)), int(y + size * (22 + 9 * line))), (190, 180, 165), 3, cv2.LINE_AA)
        disc(image, x - size * 130, y - size * 22, 9 * size, (240, 240, 240))
        disc(image, x - size * 130, y - size * 22, 4 * size, (10, 10, 10))
    for _ in range(70):
        x, y, r = random.uniform(20, 620), random.uniform(150, 860), random.uniform(3, 15)
        disc(image, x, y, r, (235, 215, 180), 2)
        disc(image, x - r / 3, y - r / 3, r / 4, (255, 250, 240))
    for _ in range(26):
        x, y, s = random.uniform(30, 610), random.uniform(640, 860), random.uniform(10, 22)
        colour = [(40, 150, 250), (60, 220, 250), (90, 90, 240)][random.randint(3)]
        polygon(image, [(x - s, y), (x, y - s / 2), (x + s, y), (x + 1.6 * s, y - s / 2), (x + 1.6 * s, y + s / 2), (x + s, y),
                        (x, y + s / 2)], colour)
    text(image, "OCEANS", 320, 40, 122, (255, 250, 235), centre=True)
    return border(image, (240, 240, 240), 12)


def jazz():
    random = np.random.RandomState(4)
    image = blank(640, 900, (40, 180, 245))
    for k in range(36):
        if k % 2 == 0:
            a, b = np.radians(10 * k), np.radians(10 * k + 10)
            polygon(image, [(300, 470), (300 + 1100 * np.cos(a), 470 + 1100 * np.sin(a)),
                            (300 + 1100 * np.cos(b), 470 + 1100 * np.sin(b))], (60, 110, 235))
    disc(image, 300, 470, 255, (24, 20, 22))
    for k in range(9):
        disc(image, 300, 470, 110 + 16 * k, (70, 62, 66) if k % 2 else (46, 40, 44), 3)
    disc(image, 300, 470, 92, (190, 220, 240))
    for k in range(12):
        a = np.radians(30 * k)
        disc(image, 300 + 66 * np.cos(a), 470 + 66 * np.sin(a), 6 + k, (30 + 15 * k, 40, 180 - 10 * k))
    disc(image, 300, 470, 12, (20, 20, 20))
    polygon(image, [(585, 200), (610, 215), (470, 610), (420, 640), (410, 610), (450, 590)], (225, 225, 230))
    for k in range(11):
        x, y = random.uniform(30, 610), random.uniform(690, 780)
        disc(image, x, y, 15, (25, 25, 30))
        cv2.line(image, (int(x + 13), int(y)), (int(x + 13), int(y - 62)), (25, 25, 30), 5, cv2.LINE_AA)
        if k % 2:
            cv2.line(image, (int(x + 13), int(y - 62)), (int(x + 38), int(y - 40)), (25, 25, 30), 7, cv2.LINE_AA)
    text(image, "JAZZ NIGHT", 320, 44, 82, (30, 20, 60), centre=True)
    cv2.rectangle(image, (0, 815), (640, 900), (60, 30, 40), -1)
    paragraph(image, random, 40, 850, 560, 2, 28, (200, 230, 245), 14)
    return border(image, (60, 30, 40), 10)


def noticeboard():
    random = np.random.RandomState(5)
    grain = random.normal(0, 1, (340, 480)).astype(np.float32)
    grain = cv2.resize(cv2.GaussianBlur(grain, (0, 0), 1.5), (960, 680)) * 32
    image = np.clip(np.array([96, 150, 190]) + grain[..., None], 0, 255).astype(np.uint8)
    papers = [(60, 60), (250, 50), (430, 70), (640, 48), (800, 80), (70, 300), (290, 280), (500, 320), (690, 290),
              (90, 500), (330, 490), (560, 520), (770, 480)]
    for k, (x, y) in enumerate(papers):
        w, h = int(random.uniform(110, 190)), int(random.uniform(120, 190))
        paper = [(250, 250, 248), (160, 240, 255), (210, 190, 255), (250, 225, 190), (190, 245, 200)][random.randint(5)]
        sheet = blank(w, h, paper)
        if k % 3 == 0:
            cv2.rectangle(sheet, (12, 12), (w - 12, h // 2), tuple(int(v) for v in random.randint(30, 200, 3)), -1)
            for _ in range(6):
                disc(sheet, random.uniform(20, w - 20), random.uniform(20, h / 2 - 8), random.uniform(5, 16),
                     tuple(int(v) for v in random.randint(30, 255, 3)))
            paragraph(sheet, random, 14, h // 2 + 24, w - 28, max(1, (h // 2 - 30) // 18), 18, (50, 50, 60), 8)
        else:
            cv2.rectangle(sheet, (14, 14), (int(w * random.uniform(0.5, 0.9)), 30), tuple(int(v) for v in random.randint(20, 140, 3)), -1)
            paragraph(sheet, random, 14, 54, w - 28, (h - 60) // 18, 18, (70, 60, 60), 8)
        turn = cv2.getRotationMatrix2D((w / 2, h / 2), random.uniform(-9, 9), 1)
        turn[:, 2] += (x, y)
        mask = cv2.warpAffine(np.full((h, w), 255, np.uint8), turn, (960, 680), flags=cv2.INTER_AREA)[..., None] / 255.0
        placed = cv2.warpAffine(sheet, turn, (960, 680), flags=cv2.INTER_LINEAR)
        shade = cv2.GaussianBlur(np.roll(mask, (5, 4), (0, 1)), (0, 0), 4)[..., None]
        image = (image * (1 - 0.35 * shade) * (1 - mask) + placed * mask).astype(np.uint8)
        disc(image, x + w / 2, y + 14, 8, [(40, 40, 220), (220, 120, 30), (60, 170, 60), (30, 200, 240)][k % 4])
    return border(image, (60, 96, 130), 16)


def skyline():
    random = np.random.RandomState(6)
    image = gradient(880, 620, (92, 40, 30), (110, 130, 240))
    for _ in range(90):
        disc(image, random.uniform(0, 880), random.uniform(0, 240), random.uniform(0.8, 2.6), (255, 240, 230))
    disc(image, 690, 130, 62, (210, 240, 250))
    for x, y, r in [(670, 115, 12), (712, 140, 16), (690, 165, 8), (720, 100, 7)]:
        disc(image, x, y, r, (180, 215, 228))
    for row, (base, dark) in enumerate([(250, (110, 70, 84)), (330, (70, 44, 52)), (430, (42, 26, 28))]):
        x = -20
        while x < 880:
            w, top = int(random.uniform(46, 110)), base + random.uniform(-70, 90)
            cv2.rectangle(image, (int(x), int(top)), (int(x + w), 620), dark, -1)
            if random.rand() < 0.4:
                polygon(image, [(x, top), (x + w / 2, top - random.uniform(20, 70)), (x + w, top)], dark)
            for wy in range(int(top) + 14, 600, 22):
                for wx in range(int(x) + 9, int(x + w) - 12, 18):
                    if random.rand() < 0.42:
                        lit = [(120, 220, 255), (160, 240, 255), (90, 170, 240)][random.randint(3)]
                        cv2.rectangle(image, (wx, wy), (wx + 8, wy + 11), lit, -1)
            x += w + random.uniform(-6, 10)
    text(image, "CITY LIGHTS", 325, 44, 72, (240, 245, 255), "DejaVuSerif-Bold", centre=True)
    return border(image, (30, 20, 24), 14)


def abstract():
    random = np.random.RandomState(7)
    image = blank(700, 760, (205, 228, 238))
    for _ in range(16):
        x, y, r = random.uniform(60, 640), random.uniform(60, 700), random.uniform(22, 110)
        colours = [(40, 60, 200), (190, 120, 30), (40, 190, 240), (90, 140, 60), (120, 60, 110), (30, 30, 40)]
        for ring in range(random.randint(1, 4)):
            disc(image, x, y, r * (1 - 0.3 * ring), colours[random.randint(6)])
    for _ in range(18):
        centre = random.uniform(60, 640, 2)
        polygon(image, centre + random.uniform(-75, 75, (3, 2)),
                [(60, 60, 220), (200, 150, 40), (60, 200, 250), (80, 160, 80), (30, 30, 36)][random.randint(5)])
    for _ in range(22):
        a = random.uniform(20, 680, 2)
        b = a + random.uniform(-260, 260, 2)
        cv2.line(image, tuple(int(v) for v in a), tuple(int(v) for v in b), (30, 28, 30), int(random.choice([3, 5, 8])), cv2.LINE_AA)
    for n in range(6):
        for m in range(6):
            if (n + m) % 2:
                cv2.rectangle(image, (460 + 30 * n, 520 + 30 * m), (490 + 30 * n, 550 + 30 * m), (30, 30, 36), -1)
    return border(border(image, (250, 250, 250), 26), (40, 70, 100), 12)


def town_map():
    random = np.random.RandomState(8)
    image = blank(900, 700, (205, 236, 226))
    polygon(image, [(0, 520), (220, 470), (420, 560), (640, 500), (900, 590), (900, 700), (0, 700)], (235, 200, 140))
    for k in range(7):
        x = 40 + 130 * k
        cv2.line(image, (x, 90), (x + 60 - 18 * k, 560), (255, 255, 255), 16, cv2.LINE_AA)
    for k in range(5):
        y = 140 + 95 * k
        cv2.line(image, (0, y), (900, y + 40 - 22 * k), (255, 255, 255), 14, cv2.LINE_AA)
    cv2.line(image, (0, 110), (900, 480), (90, 200, 250), 20, cv2.LINE_AA)
    for _ in range(95):
        x, y = random.uniform(10, 880), random.uniform(110, 470)
        w, h, turn = random.uniform(14, 46), random.uniform(14, 40), random.uniform(-0.2, 0.2)
        box = np.array([(-w, -h), (w, -h), (w, h), (-w, h)]) / 2
        rotated = box @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]) + (x, y)
        polygon(image, rotated, [(150, 170, 200), (130, 140, 190), (170, 190, 205), (120, 160, 215)][random.randint(4)])
    for _ in range(60):
        disc(image, random.uniform(10, 890), random.uniform(110, 500), random.uniform(5, 11), (90, 170, 96))
    for x, y in [(210, 250), (520, 330), (700, 210), (380, 450)]:
        polygon(image, [(x - 18, y - 26), (x + 18, y - 26), (x, y + 12)], (40, 40, 210))
        disc(image, x, y - 30, 18, (40, 40, 210))
        disc(image, x, y - 30, 7, (255, 255, 255))
    cv2.rectangle(image, (0, 0), (900, 90), (90, 60, 110), -1)
    text(image, "TOWN MAP", 30, 16, 62, (255, 255, 255))
    paragraph(image, random, 560, 40, 300, 2, 28, (230, 220, 235), 13)
    cv2.rectangle(image, (630, 560), (870, 680), (250, 250, 250), -1)
    paragraph(image, random, 650, 590, 200, 4, 24, (60, 60, 60), 11)
    return border(image, (90, 60, 110), 10)


def leaves():
    random = np.random.RandomState(9)
    image = blank(640, 880, (226, 240, 246))
    text(image, "LEAVES", 320, 34, 90, (50, 96, 40), "DejaVuSerif-Bold", centre=True)
    for row in range(4):
        for column in range(3):
            x, y = 115 + 205 * column, 220 + 172 * row
            colour = np.array([50, 130, 60]) + random.randint(-40, 60, 3)
            lobes, deep, lean = random.randint(3, 9), random.uniform(0.1, 0.5), random.uniform(0.5, 0.95)
            angle = np.linspace(0, 2 * np.pi, 120)
            radius = 78 * (1 - deep * np.abs(np.sin(lobes * angle / 2))) * (1 - 0.2 * np.cos(angle))
            points = np.stack([x + lean * radius * np.sin(angle), y - radius * np.cos(angle)], 1)
            polygon(image, points, tuple(int(v) for v in colour))
            vein = tuple(int(v) for v in np.clip(colour + 80, 0, 255))
            cv2.line(image, (x, y - 62), (x, y + 92), vein, 4, cv2.LINE_AA)
            for k in range(-3, 4):
                cv2.line(image, (x, y + 18 * k + 12), (int(x + 40 * lean), y + 18 * k - 12), vein, 2, cv2.LINE_AA)
                cv2.line(image, (x, y + 18 * k + 12), (int(x - 40 * lean), y + 18 * k - 12), vein, 2, cv2.LINE_AA)
            paragraph(image, random, x - 55, y + 100, 110, 1, 20, (80, 80, 80), 9)
    return border(image, (60, 90, 60), 12)


def stars():
    random = np.random.RandomState(10)
    image = gradient(900, 680, (70, 30, 16), (40, 16, 10))
    for radius in (110, 190, 270):
        disc(image, 450, 380, radius, (150, 110, 80), 2)
    for k in range(12):
        a = np.radians(30 * k + 8)
        cv2.line(image, (450, 380), (int(450 + 285 * np.cos(a)), int(380 + 285 * np.sin(a))), (110, 80, 56), 2, cv2.LINE_AA)
    for figure in range(9):
        centre = np.array([random.uniform(90, 810), random.uniform(160, 600)])
        points = centre + random.uniform(-95, 95, (6, 2))
        cv2.polylines(image, [points.astype(np.int32)], False, (220, 190, 130), 3, cv2.LINE_AA)
        for x, y in points:
            r = random.uniform(5, 12)
            star = [(x + (r if k % 2 else 2.2 * r) * np.sin(k * np.pi / 5), y - (r if k % 2 else 2.2 * r) * np.cos(k * np.pi / 5))
                    for k in range(10)]
            polygon(image, star, [(200, 245, 255), (255, 240, 220), (150, 200, 255)][random.randint(3)])
    for _ in range(150):
        disc(image, random.uniform(10, 890), random.uniform(10, 670), random.uniform(1, 3.4), (250, 245, 240))
    text(image, "THE NIGHT SKY", 450, 26, 72, (190, 225, 250), "DejaVuSerif-Bold", centre=True)
    return border(image, (110, 160, 190), 10)


def reading():
    random = np.random.RandomState(11)
    image = blank(660, 900, (150, 90, 60))
    for row in range(4):
        x, base = 34, 340 + 160 * row
        cv2.rectangle(image, (20, base), (640, base + 16), (50, 80, 120), -1)
        while x < 610:
            w, h = int(random.uniform(16, 44)), int(random.uniform(90, 138))
            colour = tuple(int(v) for v in random.randint(40, 240, 3))
            w = min(w, 626 - x)
            cv2.rectangle(image, (x, base - h), (x + w - 3, base - 1), colour, -1)
            stripe = tuple(int(255 - v) for v in colour)
            for k in range(random.randint(1, 4)):
                y = int(base - h + 12 + 22 * k + random.uniform(0, 10))
                cv2.rectangle(image, (x + 2, y), (x + w - 5, y + int(random.uniform(3, 11))), stripe, -1)
            x += w
    text(image, "READ", 330, 36, 140, (210, 240, 255), "DejaVuSerif-Bold", centre=True)
    return border(image, (40, 50, 80), 12)


def cafe():
    random = np.random.RandomState(12)
    image = blank(520, 520, (60, 78, 110))
    for n in range(13):
        for m in (0, 1, 11, 12):
            colour = (235, 240, 245) if (n + m) % 2 else (40, 40, 60)
            cv2.rectangle(image, (40 * n, 40 * m), (40 * n + 40, 40 * m + 40), colour, -1)
    polygon(image, [(130, 220), (350, 220), (320, 390), (160, 390)], (240, 245, 250))
    cv2.ellipse(image, (350, 285), (52, 48), 0, -90, 100, (240, 245, 250), 18, cv2.LINE_AA)
    cv2.ellipse(image, (240, 222), (108, 24), 0, 0, 360, (34, 52, 84), -1, cv2.LINE_AA)
    for k in range(3):
        wave = [(180 + 60 * k + 14 * np.sin(t / 3.0), 190 - 4.2 * t) for t in range(22)]
        cv2.polylines(image, [np.array(wave).astype(np.int32)], False, (225, 235, 240), 7, cv2.LINE_AA)
    for _ in range(26):
        x, y, turn = random.uniform(20, 500), random.uniform(100, 420), random.uniform(0, 180)
        if not (110 < x < 420):
            cv2.ellipse(image, (int(x), int(y)), (15, 10), turn, 0, 360, (26, 40, 70), -1, cv2.LINE_AA)
            cv2.ellipse(image, (int(x), int(y)), (14, 2), turn + 8, 0, 360, (120, 150, 190), -1, cv2.LINE_AA)
    disc(image, 240, 320, 34, (70, 90, 200))
    polygon(image, [(240, 352), (206, 318), (222, 296), (240, 312), (258, 296), (274, 318)], (240, 245, 250))
    return border(image, (30, 40, 60), 8)


def extinguisher():
    random = np.random.RandomState(13)
    image = blank(400, 640, (236, 238, 240))
    cv2.rectangle(image, (14, 14), (386, 626), (36, 30, 196), -1)
    cv2.rectangle(image, (34, 34), (366, 420), (245, 245, 250), -1)
    polygon(image, [(150, 160), (170, 130), (230, 130), (250, 160), (250, 390), (150, 390)], (40, 34, 205))
    cv2.rectangle(image, (180, 100), (220, 132), (50, 50, 50), -1)
    polygon(image, [(150, 78), (250, 62), (254, 80), (160, 98)], (50, 50, 50))
    cv2.polylines(image, [np.array([(220, 112), (285, 130), (300, 200), (292, 300)])], False, (40, 40, 40), 12, cv2.LINE_AA)
    polygon(image, [(280, 296), (304, 300), (318, 350), (270, 344)], (40, 40, 40))
    cv2.rectangle(image, (160, 200), (240, 300), (240, 240, 240), -1)
    paragraph(image, random, 166, 222, 68, 5, 17, (60, 60, 60), 8)
    disc(image, 200, 330, 16, (60, 220, 250))
    for k in range(6):
        x = 62 + 10 * k
        polygon(image, [(x, 390), (x + 14, 340 - 12 * (k % 3)), (x + 26, 390)], (30, 120 + 20 * k, 250))
    for k in range(3):
        x = 40 + 112 * k
        cv2.rectangle(image, (x, 440), (x + 96, 520), (245, 245, 250), -1)
        disc(image, x + 30 + 12 * k, 470, 16, (40, 40, 60))
        polygon(image, [(x + 20, 510), (x + 48 + 8 * k, 480), (x + 84, 510 - 8 * k)], (60, 40, 200 - 60 * k))
    paragraph(image, random, 40, 552, 320, 3, 26, (240, 240, 255), 12)
    return image


def exit_sign():
    image = blank(800, 340, (70, 140, 20))
    border(image, (240, 250, 240), 9)
    cv2.rectangle(image, (40, 48), (300, 292), (240, 252, 240), -1)
    green = (60, 130, 16)
    disc(image, 190, 92, 24, green)
    for points, width in [([(180, 122), (160, 190)], 40), ([(160, 190), (205, 225), (196, 274)], 24),
                          ([(156, 190), (130, 236), (76, 240)], 24), ([(182, 130), (226, 160), (262, 140)], 18),
                          ([(170, 130), (122, 146), (104, 186)], 18)]:
        cv2.polylines(image, [np.array(points)], False, green, width, cv2.LINE_AA)
    text(image, "EXIT", 350, 58, 132, (245, 255, 245))
    polygon(image, [(360, 250), (420, 205), (420, 234), (700, 234), (700, 266), (420, 266), (420, 295)], (245, 255, 245))
    return image


def room_sign(number):
    """White on dark blue, without a frame: what signs in buildings have, and what can be read from afar."""
    image = blank(440, 260, (104, 52, 20))
    text(image, number, 220, 48, 160, (250, 252, 252), centre=True)
    return image


TEMPLATES = {"welcome": welcome, "timetable": timetable, "ocean": ocean, "jazz": jazz, "noticeboard": noticeboard,
             "skyline": skyline, "abstract": abstract, "town-map": town_map, "leaves": leaves, "stars": stars,
             "reading": reading, "cafe": cafe, "extinguisher": extinguisher, "exit": exit_sign}
