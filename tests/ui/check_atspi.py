#!/usr/bin/python3
"""The workstation as a screen reader gets it: over AT-SPI, on an X server and a session bus of its own.

Every control of every page and tab has a name and a role, Tab comes round through all of them, and a page can be
changed by the screen reader's own press. The list is printed.
usage: check_atspi.py FAROL MAP
"""
import os
import subprocess
import sys
import tempfile
import time

PATIENCE = 60
NAMELESS = {"scroll bar", "separator", "filler", "panel", "viewport", "layered pane", "scroll pane"}
PARTS = {"page tab", "table cell", "tree item", "list item"}
CONTROLS = {"push button", "toggle button", "check box", "radio button", "combo box", "text", "entry", "slider", "table",
            "page tab list", "page tab", "spin button", "tree", "tree table", "list", "password text", "menu item",
            "check menu item", "radio menu item", "menu"}


def alone():
    """Runs again inside a display and a bus of its own."""
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "dbus-run-session", "--", sys.executable,
               os.path.abspath(__file__), "--inside", *sys.argv[1:]]
    environment = {**os.environ, "QT_QPA_PLATFORM": "xcb", "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1", "LC_ALL": "C.UTF-8"}
    environment.pop("WAYLAND_DISPLAY", None)
    return subprocess.run(command, env=environment).returncode


def until(what, condition):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.1)
    raise SystemExit(f"FAILED: {what}")


def inside(farol, building):
    import gi
    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib

    def settle():
        context = GLib.MainContext.default()
        while context.pending():
            context.iteration(False)

    def nodes(top):
        """All that is shown, from the outside in."""
        top.clear_cache()
        yield top
        for i in range(top.get_child_count()):
            child = top.get_child_at_index(i)
            if child is not None and child.get_state_set().contains(Atspi.StateType.SHOWING):
                yield from nodes(child)

    def is_on(node, *states):
        held = node.get_state_set()
        return all(held.contains(state) for state in states)

    def application():
        settle()
        desktop = Atspi.get_desktop(0)
        desktop.clear_cache()
        for i in range(desktop.get_child_count()):
            each = desktop.get_child_at_index(i)
            if each is not None and each.get_name().lower().startswith("farol"):
                return each
        return None

    def window():
        settle()
        for i in range(app.get_child_count()):
            child = app.get_child_at_index(i)
            if child is not None and child.get_role_name() == "frame":
                return child
        return None

    def find(role, name):
        settle()
        for node in nodes(frame):
            if node.get_role_name() == role and node.get_name() == name:
                return node
        return None

    launcher = subprocess.Popen(["/usr/libexec/at-spi-bus-launcher", "--launch-immediately"])
    home = tempfile.TemporaryDirectory()
    environment = {**os.environ, "HOME": home.name, "XDG_CONFIG_HOME": home.name, "XDG_DATA_HOME": home.name,
                   "XDG_RUNTIME_DIR": home.name}
    program = subprocess.Popen([farol, "--lang", "en", "--map", building], env=environment, stderr=subprocess.DEVNULL)
    failures, controls = [], 0
    try:
        app = until("the program is not on the bus", application)
        frame = until("the program has no window", window)
        until("the map is not shown", lambda: " – " in frame.get_name())
        subprocess.run(["xdotool", "search", "--onlyvisible", "--name", frame.get_name(), "windowfocus"], check=True)
        for page in ("Walk", "Map", "Landmarks"):
            tab = until(f"there is no page tab {page}", lambda: find("page tab", page))
            tab.do_action(0)
            until(f"the page {page} does not come", lambda: find("tool bar", page))
            settle()
            reachable = 0
            for node in nodes(frame):
                role, name = node.get_role_name(), node.get_name().strip()
                acts = is_on(node, Atspi.StateType.FOCUSABLE) or role in CONTROLS
                if not acts or role in NAMELESS or not is_on(node, Atspi.StateType.SENSITIVE):
                    continue
                controls += 1
                reachable += is_on(node, Atspi.StateType.FOCUSABLE)
                print(f"{page} | {role} | {name} | {node.get_description().strip()[:60]}")
                if not name and role != "table cell":  # it may well be empty
                    failures.append(f"{page}: a {role} has no name (inside {node.get_parent().get_name()!r})")
                if role in ("unknown", "invalid"):
                    failures.append(f"{page}: {name!r} has no role")
            if reachable < 5:
                failures.append(f"{page}: only {reachable} controls take the keyboard")

            def focused():
                settle()
                for node in nodes(frame):
                    # Of the chosen one of several Qt always says that it has the keyboard: the whole is asked.
                    if node.get_role_name() not in PARTS and is_on(node, Atspi.StateType.FOCUSED):
                        place = node.get_extents(Atspi.CoordType.WINDOW)
                        return (node.get_role_name(), node.get_name(), place.x, place.y)
                return None

            subprocess.run(["xdotool", "key", "F6"], check=True)  # into the page
            seen = [until("nothing has the keyboard", focused)]
            for _ in range(80):
                before = seen[-1]
                subprocess.run(["xdotool", "key", "Tab"], check=True)
                seen.append(until(f"{page}: Tab does not leave {before}",
                                  lambda: focused() if focused() not in (None, before) else None))
                if seen[-1] in seen[:-1]:
                    break
            if seen.index(seen[-1]) > 1:  # the first may have been seen before the key was heard
                failures.append(f"{page}: Tab does not come round: {seen[-3:]}")
            print(f"{page} | Tab comes round through {len(seen) - 1 - seen.index(seen[-1])} controls")
    finally:
        program.terminate()
        program.wait(20)
        launcher.terminate()
        launcher.wait(20)
    print(f"{controls} controls over AT-SPI")
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    if len(sys.argv) > 1 and sys.argv[1] == "--inside":
        sys.exit(inside(*sys.argv[2:4]))
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(alone())
