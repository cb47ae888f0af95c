#!/usr/bin/python3
"""The pages of the workstation as a screen reader gets them: over AT-SPI, on an X server and a session bus of its own.

Every control of every page and tab has a name and a role, Tab comes round through all of them, and a page can be
changed by the screen reader's own press. The list is printed. Dialogs and steps: check_atspi_dialogs.py.
usage: check_atspi.py FAROL MAP
"""
import sys

from atspi_desk import Desk, alone


def inside(farol, building):
    desk = Desk(farol, building)
    try:
        for page in ("Walk", "Map", "Landmarks"):
            desk.page(page)
            if desk.look(page, desk.frame) < 5:
                desk.failures.append(f"{page}: few controls take the keyboard")
            desk.key("F6")  # into the page
            desk.tab_round(page, desk.frame)
    finally:
        desk.close()
    return desk.told()


if __name__ == "__main__":
    if len(sys.argv) > 1 and sys.argv[1] == "--inside":
        sys.exit(inside(*sys.argv[2:4]))
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(alone(__file__, sys.argv[1:]))
