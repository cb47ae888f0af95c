#!/usr/bin/python3
"""Every dialog and every step of the workstation over AT-SPI: opened by the keyboard, each control named and with a
role, Tab through all of them and round again, and out by Escape. The list is printed.

usage: check_atspi_dialogs.py FAROL MAP PICTURES_FOLDER
"""
import pathlib
import sys
import time

from atspi_desk import Desk, alone, until


class Walker:
    def __init__(self, desk, pictures):
        self.desk = desk
        self.pictures = pictures
        self.seen = 0

    def walk(self, name, own=True, leave=("Escape",)):
        """The dialog that has just been opened."""
        top = until(f"{name} does not open", self.desk.dialog)
        self.seen += 1
        self.desk.look(name, top, own)
        self.desk.tab_round(name, top)
        if leave:
            self.desk.key(*leave)
            self.gone(name)

    def gone(self, name):
        until(f"{name} does not close", lambda: self.desk.dialog() is None)
        self.desk.to_the_front()

    def by_key(self, name, *keys, own=True):
        self.desk.key(*keys)
        self.walk(name, own)

    def by_menu(self, name, letter, item):
        """By the menu, for what has no key of its own."""
        self.desk.key(f"alt+{letter}")
        for _ in range(30):
            found = until(f"there is no {item} in the menu", lambda: self.item(item))
            if self.desk.is_on(found, self.desk.atspi.StateType.FOCUSED):
                break
            self.desk.key("Down")
            time.sleep(0.1)
        self.desk.key("Return")
        self.walk(name)

    def item(self, name):
        for top in self.desk.tops():
            found = self.desk.find("menu item", name, top)
            if found:
                return found
        return None

    def tabs_of(self, name, key):
        """A dialog with pages: each of them."""
        self.desk.key(key)
        top = until(f"{name} does not open", self.desk.dialog)
        pages = [node.get_name() for node in self.desk.nodes(top) if node.get_role_name() == "page tab"]
        for page in pages:
            self.desk.find("page tab", page, top).do_action(0)
            until(f"{name}: {page} is not shown", lambda: self.desk.is_on(
                self.desk.find("page tab", page, top), self.desk.atspi.StateType.FOCUSED))
            self.walk(f"{name}, {page}", leave=())
        self.desk.key("Escape")
        self.gone(name)
        if len(pages) < 3:
            self.desk.failures.append(f"{name}: only {pages}")

    def file(self, path):
        """Into the file dialog that has just been opened."""
        until("no file dialog", self.desk.dialog)
        self.desk.key("ctrl+a")
        self.desk.type(str(path))
        for _ in range(3):  # the first may go to the list of names that begin so
            self.desk.key("Return")
            try:
                until("", lambda: self.desk.dialog() is None, 2)
                break
            except SystemExit:
                continue
        self.gone("the file dialog")

    def press(self, name):
        until(f"there is no button {name}", lambda: self.desk.find("push button", name))
        until(f"{name} cannot be pressed",
              lambda: self.desk.is_on(self.desk.find("push button", name), self.desk.atspi.StateType.SENSITIVE))
        try:
            self.desk.find("push button", name).do_action(0)
        except Exception:  # Qt's own file dialog answers only when it is closed
            print(f"({name} is waited for)")


def on_the_walk_page(walker):
    walker.desk.page("Walk")
    walker.by_key("Help", "F1")
    walker.by_key("Keys", "shift+F1")
    walker.by_menu("Welcome", "h", "Welcome")
    walker.tabs_of("Settings", "ctrl+comma")
    walker.by_key("Open pictures", "ctrl+p")
    walker.by_key("Say this", "ctrl+e")
    walker.by_key("Figures", "ctrl+shift+f")
    walker.by_menu("A recorded walk anew", "w", "Work out a recorded walk anew…")
    walker.by_key("Open a map (Qt's own)", "ctrl+o", own=False)


def row_of(walker, sort):
    """The first row of this sort in the table of the Map page, which then has the keyboard."""
    desk = walker.desk
    desk.key("ctrl+f")
    desk.key("shift+Tab")
    until("the choice of the table has not the keyboard", lambda: (desk.focused(desk.frame) or ("",))[0] == "combo box")
    desk.key("Home", *["Down"] * sort)
    for _ in range(4):
        before = desk.focused(desk.frame)
        if "table" in before[0]:
            break
        desk.key("Tab")
        until("Tab does not leave the search", lambda: desk.focused(desk.frame) not in (None, before))
    else:
        raise SystemExit("FAILED: Tab does not come to the table")
    desk.key("Home")
    desk.key("Down", "Up")


def on_the_map_page(walker, building):
    desk = walker.desk
    desk.page("Map")
    desk.key("ctrl+o")
    walker.file(building)
    until("the map is not open", lambda: (lambda table: table and table.get_child_count() > 0)(
        desk.find("table", "Attributes")))
    walker.by_key("Import a map", "ctrl+i")
    for sort, name in enumerate(("Change the region", "Change the door", "Change the landmark")):
        row_of(walker, sort)
        walker.by_key(name, "F2")
    walker.by_key("Missing routes", "ctrl+shift+n")
    row_of(walker, 2)
    desk.key("Delete")
    walker.by_key("Changes are not saved", "ctrl+q")
    desk.key("ctrl+z")


def on_the_landmarks_page(walker):
    desk = walker.desk
    desk.page("Landmarks")
    walker.press("New")
    walker.file(pathlib.Path(desk.home.name) / "fresh.gpkg")
    until("nothing can be taught", lambda: (lambda button: button and desk.is_on(
        button, desk.atspi.StateType.SENSITIVE))(desk.find("push button", "Teach")))
    desk.key("ctrl+t")
    until("the first step does not come", lambda: desk.find("text", "Name") or desk.find("entry", "Name"))
    desk.type("Notice")
    step(walker, "Teach, step 1")
    walker.press("Go on")
    walker.press("Pictures")
    walker.file(walker.pictures)
    until("no picture is shown", lambda: desk.find("push button", "Outline the whole picture"))
    walker.press("Outline the whole picture")
    walker.press("Add this view")
    step(walker, "Teach, step 2")
    walker.press("Give up")
    walker.walk("Give up?")
    walker.press("Go on")
    step(walker, "Teach, step 3")
    walker.press("Save it")
    until("the landmark is not saved", lambda: desk.find("push button", "Done"))
    step(walker, "Teach, step 4")
    walker.press("Done")
    until("the library does not come back", lambda: (lambda button: button and desk.is_on(
        button, desk.atspi.StateType.SENSITIVE))(desk.find("push button", "Change")))
    until("the list of landmarks has not the keyboard", lambda: "table" in (desk.focused(desk.frame) or ("",))[0])
    walker.by_key("Change the landmark of the library", "F2")


def step(walker, name):
    desk = walker.desk
    desk.settle()
    walker.seen += 1
    desk.look(name, desk.frame)
    desk.key("F6")
    desk.tab_round(name, desk.frame)


def inside(farol, building, pictures):
    building = str(pathlib.Path(building).resolve())
    desk = Desk(farol, building)
    walker = Walker(desk, sorted(pathlib.Path(pictures).resolve().glob("*.jpg"))[0])
    try:
        on_the_walk_page(walker)
        on_the_map_page(walker, building)
        on_the_landmarks_page(walker)
    finally:
        desk.close()
    print(f"{walker.seen} dialogs and steps")
    return desk.told()


if __name__ == "__main__":
    if len(sys.argv) > 1 and sys.argv[1] == "--inside":
        sys.exit(inside(*sys.argv[2:5]))
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(alone(__file__, sys.argv[1:]))
