"""The drawn building: its plan in metres (x east, y north, from a corner of the entrance hall) and the walk through it.
The map file and the pictures are both made from these tables."""

CEILING, DOOR_TALL = 2.7, 2.08

# id: (name, ref, kind, west, south, east, north)
REGIONS = {
    "forecourt": ("Forecourt", "", "outside", -4.0, 0.0, 0.0, 6.0),
    "hall": ("Entrance hall", "", "hall", 0.0, 0.0, 6.0, 6.0),
    "long-corridor": ("Long corridor", "", "corridor", 6.0, 2.0, 14.0, 4.4),
    "north-corridor": ("North corridor", "", "corridor", 14.0, 2.0, 16.4, 11.0),
    "side-corridor": ("Side corridor", "", "corridor", 8.0, 8.6, 14.0, 11.0),
    "office": ("Office", "101", "room", 6.0, -2.0, 10.0, 2.0),
    "meeting-room": ("Meeting room", "102", "room", 10.0, -2.0, 14.0, 2.0),
    "kitchen": ("Kitchen", "103", "room", 6.0, 4.4, 10.0, 8.6),
    "classroom": ("Classroom", "104", "room", 10.0, 4.4, 14.0, 8.6),
    "library": ("Library", "105", "room", 16.4, 5.2, 23.0, 11.4),
    "toilets": ("Toilets", "106", "toilet", 8.0, 11.0, 14.0, 14.0),
}

# id: (kind, region a, region b, (x, y) to (x, y), drawn open)
ACCESSES = {
    "entrance": ("door", "forecourt", "hall", (0.0, 2.3), (0.0, 3.7), False),
    "hall-opening": ("opening", "hall", "long-corridor", (6.0, 2.0), (6.0, 4.4), True),
    "corner-opening": ("opening", "long-corridor", "north-corridor", (14.0, 2.0), (14.0, 4.4), True),
    "side-opening": ("opening", "side-corridor", "north-corridor", (14.0, 8.6), (14.0, 11.0), True),
    "door-101": ("door", "office", "long-corridor", (7.55, 2.0), (8.45, 2.0), False),
    "door-102": ("door", "meeting-room", "long-corridor", (11.95, 2.0), (12.85, 2.0), False),
    "door-103": ("door", "long-corridor", "kitchen", (8.75, 4.4), (9.65, 4.4), False),
    "door-104": ("door", "classroom", "north-corridor", (14.0, 6.55), (14.0, 7.45), False),
    "door-105": ("door", "north-corridor", "library", (16.4, 7.8), (16.4, 8.8), True),
    "door-106": ("door", "side-corridor", "toilets", (10.55, 11.0), (11.45, 11.0), False),
}

# id: (kind, template, text, region, x, y, heading it faces in degrees, height of its middle, width, height)
# An empty template is a landmark that is known by its text or its kind alone.
LANDMARKS = {
    "welcome-board": ("sign", "welcome", "WELCOME", "hall", 6.0, 5.2, 180, 1.60, 1.20, 0.90),
    "timetable": ("poster", "timetable", "TIMETABLE", "hall", 6.0, 1.0, 180, 1.55, 0.68, 0.95),
    "ocean-poster": ("poster", "ocean", "OCEANS", "long-corridor", 8.2, 4.4, 270, 1.55, 0.68, 0.956),
    "noticeboard": ("poster", "noticeboard", "", "long-corridor", 9.75, 2.0, 90, 1.55, 1.05, 0.744),
    "cafe-sign": ("sign", "cafe", "", "long-corridor", 13.20, 4.08, 180, 1.95, 0.50, 0.50),
    "jazz-poster": ("poster", "jazz", "JAZZ NIGHT", "long-corridor", 11.2, 2.0, 90, 1.55, 0.68, 0.956),
    "skyline-picture": ("picture", "skyline", "CITY LIGHTS", "long-corridor", 12.0, 4.4, 270, 1.60, 0.95, 0.669),
    "extinguisher-1": ("extinguisher", "extinguisher", "", "long-corridor", 13.65, 2.0, 90, 1.45, 0.36, 0.576),
    "abstract-picture": ("picture", "abstract", "", "north-corridor", 16.4, 6.10, 180, 1.55, 0.75, 0.814),
    "town-map": ("poster", "town-map", "TOWN MAP", "north-corridor", 14.0, 5.60, 0, 1.55, 0.90, 0.700),
    "leaves-poster": ("poster", "leaves", "LEAVES", "north-corridor", 16.4, 7.0, 180, 1.55, 0.68, 0.935),
    "extinguisher-2": ("extinguisher", "extinguisher", "", "north-corridor", 14.0, 8.05, 0, 1.45, 0.36, 0.576),
    "exit-sign": ("exit_sign", "exit", "EXIT", "north-corridor", 15.2, 9.5, 270, 2.32, 0.80, 0.34),
    "reading-poster": ("poster", "reading", "READ", "library", 19.4, 5.2, 90, 1.60, 0.80, 1.091),
    "star-chart": ("poster", "stars", "THE NIGHT SKY", "library", 21.3, 5.2, 90, 1.60, 1.15, 0.869),
    "sign-101": ("text", "", "101", "long-corridor", 8.72, 2.0, 90, 1.60, 0.34, 0.201),
    "sign-102": ("text", "", "102", "long-corridor", 13.10, 2.0, 90, 1.60, 0.34, 0.201),
    "sign-103": ("text", "", "103", "long-corridor", 9.95, 4.4, 270, 1.60, 0.34, 0.201),
    "sign-104": ("text", "", "104", "north-corridor", 14.0, 6.30, 0, 1.60, 0.34, 0.201),
    "sign-105": ("text", "", "105", "north-corridor", 16.4, 9.08, 180, 1.60, 0.34, 0.201),
    "sign-106": ("text", "", "106", "side-corridor", 10.30, 11.0, 270, 1.60, 0.34, 0.201),
}

# Doors are landmarks too, on the side of a corridor or hall: (access, region, heading the door faces)
DOOR_LANDMARKS = [
    ("entrance", "hall", 0), ("door-101", "long-corridor", 90), ("door-102", "long-corridor", 90),
    ("door-103", "long-corridor", 270), ("door-104", "north-corridor", 0), ("door-105", "north-corridor", 180),
    ("door-106", "side-corridor", 270), ("door-105", "library", 0),
]

WINDOWS = {  # (x, y) of its left and right as seen from inside, sill, head
    "north-corridor": [((16.4, 4.3), (16.4, 2.5), 0.9, 2.2)],
    "library": [((23.0, 10.6), (23.0, 8.9), 0.9, 2.3), ((23.0, 7.7), (23.0, 6.0), 0.9, 2.3)],
}

# x, y, heading of the camera: from the entrance hall to the library, the camera held now to one side, now to the other.
WALK = [
    (0.9, 3.1, 4), (1.8, 3.1, 16), (2.7, 3.2, 22), (3.6, 3.2, -30), (4.5, 3.2, -32),
    (5.4, 3.2, 2), (6.3, 3.2, 24), (7.2, 3.2, 30), (8.1, 3.3, -22), (9.0, 3.3, -8),
    (9.9, 3.2, -30), (10.7, 3.2, 26), (11.5, 3.1, 2), (12.3, 3.2, -30), (13.2, 3.2, -6),
    (14.3, 3.3, 30), (14.9, 3.6, 52), (15.2, 4.0, 86), (15.3, 4.6, 125), (15.2, 5.5, 78), (15.2, 6.4, 92),
    (15.2, 7.2, 78), (15.3, 7.9, 44), (15.6, 8.25, 12),
    (16.9, 8.3, -24), (17.7, 8.2, -50), (18.3, 8.1, -72), (19.1, 8.0, -54), (19.8, 7.4, -60),
]
