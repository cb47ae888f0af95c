#!/usr/bin/python3
"""Two programs on one library of landmarks, driven by keys on one screen: what is deleted in one and in the other at the
same moment is gone from the file, the rest is kept, and both say what happened.

usage: check_two_windows.py FAROL FAROL_CLI MAP TRAIN_SCRIPT
"""
import os
import pathlib
import sqlite3
import subprocess
import sys
import tempfile

from atspi_desk import Desk, alone, until

LIST = "Landmarks of the library"


def landmarks(library):
    try:
        with sqlite3.connect(f"file:{library}?mode=ro", uri=True) as file:
            return {name for (name,) in file.execute("select template from templates")}
    except sqlite3.OperationalError:
        return None  # it is being written


def choose(desk, key):
    """The first (Home) or the last (End) landmark of the list, to which Tab leads."""
    desk.to_the_front()
    desk.key("F6")
    for _ in range(40):
        before = until("nothing has the keyboard", lambda: desk.focused(desk.frame))
        if before[1] == LIST:
            break
        desk.key("Tab")
        until(f"Tab does not leave {before}", lambda: desk.focused(desk.frame) not in (None, before))
    else:
        raise SystemExit("FAILED: Tab does not come to the list of landmarks")
    back, forth = ("Down", "Up") if key == "Home" else ("Up", "Down")
    desk.key(key, back, forth)


def remarks(desk):
    """What stands in the window's banners."""
    desk.settle()
    words = [node.get_name() for node in desk.nodes(desk.frame) if node.get_role_name() in ("label", "alert", "notification")]
    return [text for text in words if "nother program" in text]


def inside(farol, cli, building, train):
    with tempfile.TemporaryDirectory(prefix="farol-two-") as name:
        library = pathlib.Path(name) / "library.gpkg"
        subprocess.run(["bash", train, str(library)], check=True, env={**os.environ, "FAROL_CLI": cli})
        one = Desk(farol, building, "--library", str(library))
        try:
            other = Desk(farol, building, "--library", str(library))
            try:
                for desk in (one, other):
                    desk.to_the_front()
                    desk.page("Landmarks")
                at_once(one, other, library)
            finally:
                other.close()
        finally:
            one.close()
    print("ok")
    return 0


def at_once(one, other, library):
    before = landmarks(library)
    choose(one, "Home")
    choose(other, "End")
    other.key("Delete")
    one.to_the_front()
    one.key("Delete")
    until("two landmarks are not gone from the file", lambda: len(landmarks(library) or before) == len(before) - 2)
    told = [until(f"{which} window does not tell of the other one", lambda: remarks(desk))
            for which, desk in (("the first", one), ("the second", other))]
    after = landmarks(library)
    print(f"{len(before)} landmarks, gone: {sorted(before - after)}, new: {sorted(after - before)}; told: {told}")
    if not after < before:
        raise SystemExit("FAILED: a landmark came from nowhere")


if __name__ == "__main__":
    if len(sys.argv) > 1 and sys.argv[1] == "--inside":
        sys.exit(inside(*sys.argv[2:6]))
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    sys.exit(alone(__file__, sys.argv[1:]))
