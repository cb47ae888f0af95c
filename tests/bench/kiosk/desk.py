"""A desk without people: a screen (Xvfb), a sound card that plays to nobody (PulseAudio), real key events (XTest)
and the kiosk's log of what it said. Everything it starts it also ends."""

import ctypes
import ctypes.util
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time


KEY_PAUSE_S = 0.06


def wait_for(check, seconds, what):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = check()
        if found:
            return found
        time.sleep(0.02)
    raise TimeoutError(f"{what} did not come within {seconds:g} s")


class Screen:
    """An X server of its own, and keys pressed in it."""

    def __init__(self, size="1280x800"):
        read_end, write_end = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{size}x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as number:
            self.name = ":" + number.readline().strip()
        self._x = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
        self._test = ctypes.CDLL(ctypes.util.find_library("Xtst") or "libXtst.so.6")
        self._x.XOpenDisplay.restype = ctypes.c_void_p
        self._x.XStringToKeysym.restype = ctypes.c_ulong
        self._x.XKeysymToKeycode.argtypes = [ctypes.c_void_p, ctypes.c_ulong]
        self._x.XKeysymToKeycode.restype = ctypes.c_ubyte
        self._x.XFlush.argtypes = self._x.XCloseDisplay.argtypes = [ctypes.c_void_p]
        self._test.XTestFakeKeyEvent.argtypes = [ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_ulong]
        self._released = 0.0
        self._display = self._x.XOpenDisplay(self.name.encode())
        if not self._display:
            raise OSError(f"no X server at {self.name}")

    def code(self, key):
        return self._x.XKeysymToKeycode(self._display, self._x.XStringToKeysym(key.encode()))

    def down(self, key):
        """Returns when it was pressed, on the monotonic clock."""
        # As fingers do: a press right behind a release is taken for a key that repeats itself.
        time.sleep(max(0.0, self._released + KEY_PAUSE_S - time.monotonic()))
        at = time.monotonic()
        self._test.XTestFakeKeyEvent(self._display, self.code(key), 1, 0)
        self._x.XFlush(self._display)
        return at

    def up(self, key):
        self._test.XTestFakeKeyEvent(self._display, self.code(key), 0, 0)
        self._x.XFlush(self._display)
        self._released = time.monotonic()

    def press(self, key):
        """A key by its X name: Down, Return, w, KP_5, F1."""
        at = self.down(key)
        self.up(key)
        return at

    def close(self):
        self._x.XCloseDisplay(self._display)
        self._server.terminate()
        self._server.wait()


class SoundCard:
    """PulseAudio with a sink that nobody hears: speech takes its time, and can be recorded."""

    def __init__(self):
        if shutil.which("pulseaudio") is None:
            raise OSError("PulseAudio is needed (packages pulseaudio, pulseaudio-utils)")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="farol-sound-"))
        self.folder.chmod(0o700)
        self.environment = {"XDG_RUNTIME_DIR": str(self.folder), "HOME": str(self.folder),
                            "PULSE_SERVER": f"unix:{self.folder}/pulse/native"}
        self._server = subprocess.Popen(
            ["pulseaudio", "--daemonize=no", "--exit-idle-time=-1", "-n", "--use-pid-file=no",
             "-L", "module-null-sink sink_name=nobody rate=48000",
             "-L", f"module-native-protocol-unix socket={self.folder}/pulse/native"],
            env={**os.environ, **self.environment}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_for(lambda: (self.folder / "pulse" / "native").exists(), 20, "PulseAudio")

    def record(self, file):
        """Until the process that is returned is terminated."""
        return subprocess.Popen(
            ["parec", "--device=nobody.monitor", "--rate=16000", "--channels=1", "--format=s16le",
             "--file-format=wav", "--latency-msec=20", str(file)],
            env={**os.environ, **self.environment}, stderr=subprocess.DEVNULL)

    def close(self):
        self._server.terminate()
        self._server.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


class Kiosk:
    """The kiosk as its users start it. All that is known of it is what it says."""

    def __init__(self, farol, screen, sound, arguments, show=None):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="farol-kiosk-"))
        self.log = self.folder / "utterances.jsonl"
        self.log.touch()
        self._screen = screen
        self._show = show
        self._read = 0
        self._rest = ""
        self.heard = []  # every utterance as it began
        self._asked = 0  # how many of them had begun at the last key
        self.lines = []  # the whole log
        environment = {**os.environ, **(sound.environment if sound else {}), "DISPLAY": screen.name,
                       "HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder / "config"),
                       "XDG_DATA_HOME": str(self.folder / "data"), "QT_QPA_PLATFORM": "xcb", "LC_ALL": "C.UTF-8"}
        if not sound:
            environment["FAROL_SPEECH_WAV"] = str(self.folder / "speech")
        self.process = subprocess.Popen([str(farol), "--kiosk", "--utterances", str(self.log), *arguments],
                                        env=environment)

    def listen(self):
        """What began to be said since the last time, as sentences."""
        with self.log.open(encoding="utf-8") as file:
            file.seek(self._read)
            text = self._rest + file.read()
            self._read = file.tell()
        *lines, self._rest = text.split("\n")
        new = [json.loads(line) for line in lines if line]
        self.lines += new
        begun = [line for line in new if line["type"] == "utterance" and line["state"] in ("speaking", "shown")]
        self.heard += begun
        for line in begun:
            if self._show:
                self._show(f'   "{line["text"]}"')
        return begun

    def press(self, key):
        if self._show:
            self._show(f"[{key}]")
        self._asked = len(self.heard)
        return self._screen.press(key)

    def hear(self, *parts, seconds=60.0):
        """Waits until something is said that contains one of these; the sentence."""

        def check():
            return next((line["text"] for line in self.listen() if any(part in line["text"] for part in parts)), None)

        return wait_for(check, seconds, " or ".join(parts))

    def hear_since_key(self, *parts, seconds=60.0):
        """The same, but it may have begun since the last key already."""
        for line in self.heard[self._asked:]:
            if any(part in line["text"] for part in parts):
                return line["text"]
        return self.hear(*parts, seconds=seconds)

    def answer(self, key, seconds=60.0):
        """What is said to this key, whatever the walk says at the same moment."""
        self.listen()
        before = len(self.heard)
        self.press(key)

        def check():
            self.listen()
            return next((line["text"] for line in self.heard[before:] if line["cause"] == "key"), None)

        return wait_for(check, seconds, f"an answer to {key}")

    def leave(self):
        """Escape held down, as the user leaves."""
        at = self._screen.down("Escape")
        try:
            self.hear("Goodbye", seconds=20.0)
        finally:
            self._screen.up("Escape")
        self.process.wait(timeout=60)
        return at

    def close(self):
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait(timeout=60)
        shutil.rmtree(self.folder, ignore_errors=True)
