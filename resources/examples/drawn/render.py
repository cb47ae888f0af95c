"""A small picture maker for the drawn building: flat textured panels seen by a pinhole camera, lit by lamps.

Rays are cast against every panel's plane on a grid SAMPLES times finer than the picture, a depth buffer keeps the
nearest, textures are read from a mip pyramid, and the fine grid is averaged down, so that nothing flickers or steps."""
import cv2
import numpy as np

WIDTH, HEIGHT, FOCAL, SAMPLES = 640, 480, 520.0, 3
EXPOSURE = 1.0


class Panel:
    """A rectangle in space: `corner` is its top left as seen from its front, `right` and `down` are its edges in metres.
    `texels` is a picture that fills it, or (with `repeat` metres) that tiles it; `glow` panels shine by themselves."""

    def __init__(self, corner, right, down, texels, room, repeat=None, glow=0.0, mirror=0.0, name=None, two_sided=False):
        self.corner, self.right, self.down = (np.array(v, float) for v in (corner, right, down))
        self.wide, self.tall = np.linalg.norm(self.right), np.linalg.norm(self.down)
        self.normal = np.cross(self.down, self.right) / (self.wide * self.tall)
        self.pyramid = pyramid(texels)
        self.room, self.repeat, self.glow, self.mirror, self.name = room, repeat, glow, mirror, name
        self.two_sided = two_sided

    def corners(self):
        return [self.corner, self.corner + self.right, self.corner + self.right + self.down, self.corner + self.down]


_pyramids = {}


def pyramid(texels):
    """Linear-light copies of a texture, each half as large as the one before; shared by panels with one picture."""
    if id(texels) not in _pyramids:
        level = (texels.astype(np.float32) / 255.0) ** 2.2
        levels = [level]
        while min(level.shape[:2]) > 4:
            level = cv2.resize(level, (max(1, level.shape[1] // 2), max(1, level.shape[0] // 2)), interpolation=cv2.INTER_AREA)
            levels.append(level)
        _pyramids[id(texels)] = (levels, texels)  # the picture is kept so that its id stays its own
    return _pyramids[id(texels)][0]


class Camera:
    """At x, y, z metres looking along `heading` (degrees, counter-clockwise from east) and `pitch` (up positive)."""

    def __init__(self, x, y, heading, z=1.5, pitch=0.0):
        self.place = np.array([x, y, z], float)
        a, p = np.radians(heading), np.radians(pitch)
        self.ahead = np.array([np.cos(a) * np.cos(p), np.sin(a) * np.cos(p), np.sin(p)])
        self.right = np.array([np.sin(a), -np.cos(a), 0.0])
        self.down = np.cross(self.ahead, self.right)

    def project(self, point):
        """Pixels (pixel centres at +0.5), or None behind the camera."""
        offset = np.asarray(point, float) - self.place
        depth = offset @ self.ahead
        if depth < 0.05:
            return None
        return np.array([WIDTH / 2 + FOCAL * (offset @ self.right) / depth, HEIGHT / 2 + FOCAL * (offset @ self.down) / depth])

    def rays(self, step):
        """Directions for a grid of `step` samples a pixel, one row of the picture after the other."""
        u = (np.arange(WIDTH * step) + 0.5) / step - WIDTH / 2
        v = (np.arange(HEIGHT * step) + 0.5) / step - HEIGHT / 2
        return (self.ahead[None, None] * FOCAL + u[None, :, None] * self.right + v[:, None, None] * self.down).astype(np.float32)


def screen_box(camera, panel, step):
    """Rows and columns of the fine grid that the panel can touch: its outline cut at the near plane."""
    corners = [corner - camera.place for corner in panel.corners()]
    points = []
    for k in range(4):
        a, b = corners[k], corners[(k + 1) % 4]
        da, db = a @ camera.ahead, b @ camera.ahead
        if da > 0.05:
            points.append(a)
        if (da > 0.05) != (db > 0.05):
            points.append(a + (b - a) * (0.05 - da) / (db - da))
    if not points:
        return None
    points = np.array(points)
    depth = np.maximum(points @ camera.ahead, 0.04)
    x = (WIDTH / 2 + FOCAL * (points @ camera.right) / depth) * step
    y = (HEIGHT / 2 + FOCAL * (points @ camera.down) / depth) * step
    left, right = int(max(0, np.floor(x.min()) - 1)), int(min(WIDTH * step, np.ceil(x.max()) + 1))
    top, bottom = int(max(0, np.floor(y.min()) - 1)), int(min(HEIGHT * step, np.ceil(y.max()) + 1))
    return (top, bottom, left, right) if left < right and top < bottom else None


def cast(camera, panels, step, rays):
    """Which panel each ray meets first (-1: none) and how far along the ray."""
    nearest = np.full(rays.shape[:2], np.inf, np.float32)
    owner = np.full(rays.shape[:2], -1, np.int16)
    for index, panel in enumerate(panels):
        facing = (camera.place - panel.corner) @ panel.normal
        if abs(facing) < 1e-6 or (facing < 0 and not panel.two_sided):
            continue
        box = screen_box(camera, panel, step)
        if box is None:
            continue
        top, bottom, left, right = box
        part = rays[top:bottom, left:right]
        with np.errstate(divide="ignore", invalid="ignore"):
            along = np.float32(-facing) / (part @ panel.normal.astype(np.float32))
            hit = (along > 0) & (along < nearest[top:bottom, left:right])
            offset = camera.place - panel.corner
            for edge, size in ((panel.right, panel.wide), (panel.down, panel.tall)):
                share = (offset @ edge + along * (part @ edge.astype(np.float32))) / size ** 2
                hit &= (share >= 0) & (share < 1)
        nearest[top:bottom, left:right][hit] = along[hit]
        owner[top:bottom, left:right][hit] = index
    return owner, nearest


def texture_of(camera, panel, direction, along):
    """The panel's own colour at each ray, from the mip level that fits the size of a sample on the panel."""
    level0 = panel.pyramid[0]
    per_metre = np.array([level0.shape[1] / (panel.repeat or panel.wide), level0.shape[0] / (panel.repeat or panel.tall)])
    offset = (camera.place - panel.corner)[None] + along[:, None] * direction
    x = offset @ (panel.right / panel.wide) * per_metre[0]
    y = offset @ (panel.down / panel.tall) * per_metre[1]
    slope = np.abs(direction @ panel.normal) / np.linalg.norm(direction, axis=1)
    footprint = along / SAMPLES * max(per_metre)  # texels across one fine sample, square on
    lod = np.log2(np.maximum(footprint * np.minimum(1 / np.maximum(slope, 0.02), 3.0) ** 0.5, 1e-6))
    lod = np.clip(lod, 0, len(panel.pyramid) - 1.001)
    colour = np.zeros((len(along), 3), np.float32)
    for number, level in enumerate(panel.pyramid):
        weight = np.clip(1 - np.abs(lod - number), 0, 1).astype(np.float32)
        used = weight > 0
        if not used.any():
            continue
        mapx, mapy = x[used] / 2 ** number - 0.5, y[used] / 2 ** number - 0.5
        mode = cv2.BORDER_WRAP if panel.repeat else cv2.BORDER_REPLICATE
        if panel.repeat:
            mapx, mapy = np.mod(mapx, level.shape[1]), np.mod(mapy, level.shape[0])
        colour[used] += weight[used, None] * sample(level, mapx, mapy, mode)
    return colour


def sample(level, x, y, mode):
    """cv2.remap on a list of places, folded so that no side is over its limit of 32767."""
    rows = -(-len(x) // 4096)
    fold = lambda v: np.resize(v, rows * 4096).reshape(rows, 4096).astype(np.float32)
    return cv2.remap(level, fold(x), fold(y), cv2.INTER_LINEAR, borderMode=mode).reshape(-1, 3)[:len(x)]


def light_on(panel, points, lamps):
    """Light that falls on points of a panel: a soft share from everywhere, lamps of its room, dimmer near the corners."""
    total = np.full((len(points), 3), 0.30, np.float32)
    for place, colour in lamps.get(panel.room, []):
        towards = place[None] - points
        square = np.sum(towards ** 2, axis=1) + 0.15
        cosine = np.abs(towards @ panel.normal) / np.sqrt(square)
        fall = np.maximum(towards[:, 2], 0.25) / np.sqrt(square)
        total += (cosine * fall * 2.1 / square)[:, None] * colour[None]
    from_floor, from_ceiling = points[:, 2], 2.7 - points[:, 2]
    if abs(panel.normal[2]) < 0.5:
        total *= (0.72 + 0.28 * np.clip(from_floor / 0.5, 0, 1) ** 0.6)[:, None]
        total *= (0.82 + 0.18 * np.clip(from_ceiling / 0.35, 0, 1) ** 0.6)[:, None]
    elif panel.normal[2] < 0:
        total += 0.26  # what the floor throws back
    return total


def shade(camera, panels, lamps, owner, nearest, rays):
    picture = np.zeros(owner.shape + (3,), np.float32)
    for index in np.unique(owner):
        if index < 0:
            continue
        panel, mask = panels[index], owner == index
        direction, along = rays[mask], nearest[mask]
        colour = texture_of(camera, panel, direction, along)
        if panel.glow:
            picture[mask] = colour * panel.glow
        else:
            picture[mask] = colour * light_on(panel, camera.place + along[:, None] * direction, lamps)
    return picture


def reflections(camera, panels, lamps):
    """What polished floors mirror: the scene seen from under the floor, at half size and smeared downwards."""
    above = [panel for panel in panels if not (abs(panel.normal[2]) > 0.5 and panel.corner[2] < 0.1)]
    flipped = Camera(0, 0, 0)
    flipped.place = camera.place * (1, 1, -1)
    flipped.ahead, flipped.right, flipped.down = (v * (1, 1, -1) for v in (camera.ahead, camera.right, camera.down))
    rays = flipped.rays(1)
    owner, nearest = cast(flipped, above, 1, rays)
    picture = shade(flipped, above, lamps, owner, nearest, rays)
    return cv2.GaussianBlur(cv2.blur(picture, (3, 13)), (0, 0), 2.0)


def look(camera, panels, lamps, warmth=0.0, gain=1.0, grain=0.8, seed=0):
    """One 8-bit BGR picture as a camera would take it, and the panel that each fine sample shows."""
    rays = camera.rays(SAMPLES)
    owner, nearest = cast(camera, panels, SAMPLES, rays)
    picture = shade(camera, panels, lamps, owner, nearest, rays)
    mirror = np.array([panel.mirror for panel in panels] + [0.0], np.float32)[owner]
    picture = cv2.resize(picture, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
    share = cv2.resize(mirror, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)[..., None]
    if share.max() > 0:
        picture = picture * (1 - share) + share * reflections(camera, panels, lamps)
    picture += 0.05 * cv2.GaussianBlur(np.maximum(picture - 0.9, 0), (0, 0), 14)
    picture *= gain * EXPOSURE * np.array([1 - warmth, 1.0, 1 + warmth], np.float32)
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    off_axis = ((u - WIDTH / 2) ** 2 + (v - HEIGHT / 2) ** 2) / FOCAL ** 2
    picture *= (1 / (1 + off_axis) ** 0.9)[..., None].astype(np.float32)
    picture = cv2.GaussianBlur(picture, (0, 0), 0.5)
    picture = 1 - np.exp(-1.25 * picture)  # a shoulder, as film and sensors have
    picture = 255 * np.clip(picture / (1 - np.exp(-1.25 * 1.25)), 0, 1) ** (1 / 2.2)
    picture += 0.6 * (picture - cv2.GaussianBlur(picture, (0, 0), 1.0))  # cameras sharpen
    noise = np.random.RandomState(seed).normal(0, 1, (HEIGHT, WIDTH, 1)).astype(np.float32)
    return np.clip(picture + grain * cv2.GaussianBlur(noise, (0, 0), 0.6)[..., None] * 1.6, 0, 255).astype(np.uint8), owner
