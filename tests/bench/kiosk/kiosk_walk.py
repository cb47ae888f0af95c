#!/usr/bin/env python3
"""Walks in the demo building by speech alone.

    tests/bench/kiosk/kiosk_walk.py [--build build/release] [--way arrows|typing|number-pad|two-keys]... [--from WHERE]

It starts `farol --kiosk` as its users do, on a screen and a sound card of its own, with the simulated user in the
demo building. It presses keys, and of the program it knows nothing but what is said (the log of --utterances): it goes
through the list until it hears its destination, hears the way, starts, is led, and hears that it has arrived. Only
then it looks where the simulated user really stands. Exit code 1 if a walk did not arrive, or not where it was told.
"""

import argparse
import pathlib
import shutil
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from desk import Kiosk, Screen, SoundCard  # noqa: E402

MOST_KEYS = 200
QUIET_SECONDS = 25.0  # then a user asks


def choose_by_arrows(kiosk, name):
    """Arrow down until it is heard."""
    for _ in range(MOST_KEYS):
        kiosk.press("Down")
        if name in kiosk.hear(" of ", "last place"):
            kiosk.press("Return")
            return
    raise LookupError(f"{name} was not heard in the list")


def choose_by_typing(kiosk, name):
    kiosk.press("f")
    kiosk.hear("Type part of a name")
    for letter in name.lower():
        kiosk.press({" ": "space", ".": "period"}.get(letter, letter))
        kiosk.hear(f"{letter}:", "space:")
    kiosk.press("Return")
    kiosk.hear("fit: ", "fits: ")
    for _ in range(MOST_KEYS):
        if name in kiosk.heard[-1]["text"]:
            kiosk.press("Return")
            return
        kiosk.press("Down")
        kiosk.hear(" of ")
    raise LookupError(f"{name} was not found by typing")


def choose_on_the_number_pad(kiosk, name):
    """A kind of places first (6), then down (2) and take it (5)."""
    for _ in range(20):
        kiosk.press("KP_Right")
        if "Rooms" in kiosk.hear(" place"):
            break
    for _ in range(MOST_KEYS):
        if name in kiosk.heard[-1]["text"]:
            kiosk.press("KP_Begin")
            return
        kiosk.press("KP_Down")
        kiosk.hear(" of ")
    raise LookupError(f"{name} was not heard in the list")


def take(kiosk, part):
    """With two keys: space until it is offered, then Enter."""
    for _ in range(MOST_KEYS):
        if part in kiosk.answer("space"):
            kiosk.press("Return")
            return
    raise LookupError(f"{part} was not offered")


def choose_with_two_keys(kiosk, name):
    kiosk.press("F4")
    kiosk.hear("Two keys")
    take(kiosk, "Rooms")
    kiosk.hear("first place")
    take(kiosk, name)


WAYS = {
    "arrows": (choose_by_arrows, "Return", "space", "Office 0.06"),
    "typing": (choose_by_typing, "Return", "space", "Toilets 0.08"),
    "number-pad": (choose_on_the_number_pad, "KP_Begin", "KP_Insert", "Office 0.01"),
    "two-keys": (choose_with_two_keys, None, None, "Storage 0.11"),
}


def start(kiosk, key):
    """Hears the whole way first."""
    if key is None:
        take(kiosk, "whole way")
        kiosk.hear("Destination: ")
        take(kiosk, "Start")
    else:
        kiosk.press("KP_Prior" if key.startswith("KP") else "l")
        kiosk.hear("Destination: ")
        kiosk.press(key)


def be_led(kiosk, again, patience):
    """Listens until the arrival; who hears nothing for long asks."""
    began = last = time.monotonic()
    asked = 0
    while time.monotonic() - began < patience:
        for line in kiosk.listen():
            last = time.monotonic()
            if "You have arrived" in line["text"] or "You have probably arrived" in line["text"]:
                return line["text"], time.monotonic() - began, asked
        if time.monotonic() - last > QUIET_SECONDS:
            asked += 1
            last = time.monotonic()
            if again:
                kiosk.press(again)
            else:
                take(kiosk, "Say again")
        time.sleep(0.05)
    raise TimeoutError("the arrival was not heard")


def give_up(kiosk, way):
    kiosk.press("Escape")
    kiosk.hear("Stop the guidance?")
    kiosk.press("Escape")
    kiosk.hear("Choose a destination")
    if way == "two-keys":
        kiosk.press("F4")
    return False


def walk(kiosk, way, to, patience):
    choose, enter, again, name = WAYS[way]
    name = to or name
    choose(kiosk, name)
    kiosk.hear(f"To: {name}")
    first = len(kiosk.heard)
    start(kiosk, enter)
    try:
        told, seconds, asked = be_led(kiosk, again, patience)
    except TimeoutError as late:
        print(f"| {way} | {name} | {late} | {place(kiosk)} | NO | {patience:.0f} | {len(kiosk.heard) - first} | |",
              flush=True)
        return give_up(kiosk, way)
    for _ in range(100):  # a door takes a few steps more
        if place(kiosk) == kiosk.places[name]:
            break
        time.sleep(0.1)
        kiosk.listen()
    there = place(kiosk) == kiosk.places[name]
    print(f"| {way} | {name} | {told} | {place(kiosk)} | {'yes' if there else 'NO'} | {seconds:.0f} | "
          f"{len(kiosk.heard) - first} | {asked} |", flush=True)
    if way == "two-keys":
        take(kiosk, "another place")
        kiosk.press("F4")
    else:
        kiosk.press(enter)
    kiosk.hear("Choose a destination")
    return there


def place(kiosk):
    """Where the simulated user really is. Only for the table: nothing is decided by it."""
    return next((line["region"] for line in reversed(kiosk.lines) if line["type"] == "truth"), "?")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    root = pathlib.Path(__file__).resolve().parents[3]
    parser.add_argument("--build", type=pathlib.Path, default=root / "build" / "release")
    parser.add_argument("--way", action="append", choices=list(WAYS))
    parser.add_argument("--to", help="with one --way: another destination")
    parser.add_argument("--from", dest="start", default="0.03")
    parser.add_argument("--patience", type=float, default=400.0, help="seconds until a walk is given up")
    parser.add_argument("--log", type=pathlib.Path, help="keep there what was said, and where the user really was")
    parser.add_argument("--quiet", action="store_true", help="print the table alone")
    arguments = parser.parse_args()

    show = None if arguments.quiet else lambda text: print(text, file=sys.stderr, flush=True)
    screen, sound = Screen(), SoundCard()
    kiosk = Kiosk(arguments.build / "bin" / "farol", screen, sound,
                  ["--lang", "en", "--map", str(root / "resources/demo/demo.gpkg"),
                   "--library", str(arguments.build / "demo-library.gpkg"), "--source", f"sim:{arguments.start}"], show)
    kiosk.places = names_in(root / "resources/demo/demo.gpkg")
    try:
        kiosk.hear("Choose a destination", seconds=120)
        print("| way | destination | heard at the end | really in | there | seconds | utterances | asked again |")
        print("|---|---|---|---|---|---:|---:|---:|")
        fine = all([walk(kiosk, way, arguments.to, arguments.patience) for way in arguments.way or WAYS])
        kiosk.leave()
        left = kiosk.process.returncode == 0
        print(f"left by holding Escape: {'well' if left else 'NOT well'}")
        return 0 if fine and left else 1
    finally:
        if arguments.log:
            shutil.copyfile(kiosk.log, arguments.log)
        kiosk.close()
        sound.close()
        screen.close()


def names_in(building):
    import sqlite3
    with sqlite3.connect(f"file:{building}?mode=ro", uri=True) as file:
        return dict(file.execute("select name, region_id from regions"))


if __name__ == "__main__":
    sys.exit(main())
