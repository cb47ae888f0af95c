"""The workstation on an X server and a session bus of its own, as a screen reader gets it: over AT-SPI."""
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


def alone(script, arguments):
    """Runs the script again inside a display and a bus of its own."""
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "dbus-run-session", "--", sys.executable,
               os.path.abspath(script), "--inside", *arguments]
    environment = {**os.environ, "QT_QPA_PLATFORM": "xcb", "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1", "LC_ALL": "C.UTF-8",
                   "PYTHONDONTWRITEBYTECODE": "1"}
    environment.pop("WAYLAND_DISPLAY", None)
    return subprocess.run(command, env=environment).returncode


def until(what, condition, patience=PATIENCE):
    end = time.monotonic() + patience
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.1)
    raise SystemExit(f"FAILED: {what}")


class Desk:
    """The program, what it shows, and the keys that are pressed in it. Failures are collected, not thrown."""

    def __init__(self, farol, building, *options):
        import gi
        gi.require_version("Atspi", "2.0")
        from gi.repository import Atspi, GLib
        self.atspi, self._glib = Atspi, GLib
        self.failures, self.controls = [], 0
        self._launcher = subprocess.Popen(["/usr/libexec/at-spi-bus-launcher", "--launch-immediately"])
        self.home = tempfile.TemporaryDirectory()
        environment = {**os.environ, "HOME": self.home.name, "XDG_CONFIG_HOME": self.home.name,
                       "XDG_DATA_HOME": self.home.name, "XDG_RUNTIME_DIR": self.home.name}
        self._program = subprocess.Popen([farol, "--lang", "en", "--map", building, *options], env=environment,
                                         stderr=subprocess.DEVNULL)
        try:
            self._app = until("the program is not on the bus", self._application)
            self.frame = until("the program has no window", self._window)
            until("the map is not shown", lambda: " – " in self.frame.get_name())
            found = subprocess.run(["xdotool", "search", "--all", "--onlyvisible", "--pid", str(self._program.pid), "--name",
                                    self.frame.get_name()], check=True, capture_output=True, text=True)
            self._id = found.stdout.split()[0]
            self.to_the_front()
        except BaseException:
            self.close()
            raise

    def close(self):
        self._program.terminate()
        try:
            self._program.wait(20)
        except subprocess.TimeoutExpired:
            self._program.kill()
        self._launcher.terminate()
        self._launcher.wait(20)
        self.home.cleanup()

    def to_the_front(self):
        """What a window manager does when a dialog closes; there is none here."""
        subprocess.run(["xdotool", "windowfocus", "--sync", self._id], check=True, timeout=PATIENCE)

    def settle(self):
        context = self._glib.MainContext.default()
        while context.pending():
            context.iteration(False)

    def _application(self):
        self.settle()
        desktop = self.atspi.get_desktop(0)
        desktop.clear_cache()
        for i in range(desktop.get_child_count()):
            each = desktop.get_child_at_index(i)
            if each is not None and each.get_process_id() == self._program.pid:
                return each
        return None

    def tops(self):
        self.settle()
        self._app.clear_cache()
        found = []
        for i in range(self._app.get_child_count()):
            child = self._app.get_child_at_index(i)
            if child is not None and child.get_state_set().contains(self.atspi.StateType.SHOWING):
                found.append(child)
        return found

    def _window(self):
        return next((top for top in self.tops() if top.get_role_name() == "frame"), None)

    def dialog(self):
        """The newest that lies over the window."""
        over = [top for top in self.tops() if top.get_role_name() not in ("frame", "popup menu", "menu", "tool tip", "list")]
        return over[-1] if over else None

    def nodes(self, top):
        """All that is shown, from the outside in."""
        top.clear_cache()
        yield top
        for i in range(top.get_child_count()):
            child = top.get_child_at_index(i)
            if child is not None and child.get_state_set().contains(self.atspi.StateType.SHOWING):
                yield from self.nodes(child)

    def is_on(self, node, *states):
        held = node.get_state_set()
        return all(held.contains(state) for state in states)

    def find(self, role, name, top=None):
        self.settle()
        for node in self.nodes(top or self.frame):
            if node.get_role_name() == role and node.get_name() == name:
                return node
        return None

    def key(self, *names):
        subprocess.run(["xdotool", "key", *names], check=True)

    def type(self, text):
        subprocess.run(["xdotool", "type", "--delay", "20", text], check=True)

    def page(self, name):
        until(f"there is no page tab {name}", lambda: self.find("page tab", name)).do_action(0)
        until(f"the page {name} does not come", lambda: self.find("tool bar", name))
        self.settle()

    def look(self, where, top, own=True):
        """Prints each control; it has a name and a role. How many take the keyboard."""
        state = self.atspi.StateType
        reachable = 0
        for node in self.nodes(top):
            role, name = node.get_role_name(), node.get_name().strip()
            acts = self.is_on(node, state.FOCUSABLE) or role in CONTROLS
            if not acts or role in NAMELESS or not self.is_on(node, state.SENSITIVE):
                continue
            self.controls += 1
            reachable += self.is_on(node, state.FOCUSABLE)
            print(f"{where} | {role} | {name} | {node.get_description().strip()[:60]}")
            if own and not name and role not in ("table cell", "dialog", "alert"):  # a cell may well be empty
                self.failures.append(f"{where}: a {role} has no name (inside {node.get_parent().get_name()!r})")
            if role in ("unknown", "invalid"):
                self.failures.append(f"{where}: {name!r} has no role")
        return reachable

    def focused(self, top):
        self.settle()
        for node in self.nodes(top):
            # Of the chosen one of several Qt always says that it has the keyboard: the whole is asked.
            if node.get_role_name() not in PARTS and self.is_on(node, self.atspi.StateType.FOCUSED):
                place = node.get_extents(self.atspi.CoordType.WINDOW)
                return (node.get_role_name(), node.get_name(), place.x, place.y)
        return None

    def tab_round(self, where, top):
        """Tab leaves each control and comes back to where it began."""
        seen = [until(f"{where}: nothing has the keyboard", lambda: self.focused(top))]
        for _ in range(80):
            before = seen[-1]
            self.key("Tab")
            patience = 3 if len(seen) == 1 else PATIENCE  # the only control of all is no trap
            try:
                seen.append(until(f"{where}: Tab does not leave {before}",
                                  lambda: (lambda now: now if now not in (None, before) else None)(self.focused(top)),
                                  patience))
            except SystemExit:
                if len(seen) == 1 and self.alone_in(top):
                    print(f"{where} | the only control has the keyboard")
                    return
                raise
            if seen[-1] in seen[:-1]:
                break
        if seen.index(seen[-1]) > 1:  # the first may have been seen before the key was heard
            self.failures.append(f"{where}: Tab does not come round: {seen[-3:]}")
        print(f"{where} | Tab comes round through {len(seen) - 1 - seen.index(seen[-1])} controls")

    def alone_in(self, top):
        state = self.atspi.StateType
        return sum(self.is_on(node, state.FOCUSABLE, state.SENSITIVE) and node.get_role_name() not in PARTS
                   for node in self.nodes(top)) < 2

    def told(self):
        print(f"{self.controls} controls over AT-SPI")
        for failure in self.failures:
            print("FAILED:", failure)
        return 1 if self.failures else 0
