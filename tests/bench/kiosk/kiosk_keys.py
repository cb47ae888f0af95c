#!/usr/bin/env python3
"""From a key to the voice: every key in every state of the kiosk.

    tests/bench/kiosk/kiosk_keys.py [--build build/release] [--rounds 1] [--state walking]...

It starts `farol --kiosk` in the demo building, brings it to each state by keys, presses each key there and takes the
time until the first word of the answer is handed to the voice (the log of --utterances; both ends on the machine's
monotonic clock, the key as it leaves the X client). Keys that bring the kiosk elsewhere are followed by the way back.
It prints a table of milliseconds. Exit code 1 when a key says nothing, or a state's median is over 300 ms.
"""

import argparse
import pathlib
import statistics
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from desk import Kiosk, Screen  # noqa: E402

GOAL_MS = 300.0
SILENT_S = 8.0
LED_S = 400.0
KEYS = (["Up", "Down", "Left", "Right", "Home", "End", "Return", "space", "Escape", "Tab", "BackSpace", "Delete",
         "Insert", "Prior", "Next", "plus", "minus", "period", "Caps_Lock", "Num_Lock", "F1", "F2", "F3", "F4", "F12"]
        + list("wanlsmvdufbz05")
        + ["KP_Up", "KP_Right", "KP_Begin", "KP_Enter", "KP_Insert", "KP_End", "KP_Next", "KP_Home", "KP_Prior", "KP_Add",
           "KP_Multiply", "KP_Divide", "KP_Delete"])


class Driver:
    """Knows the ways between the states, by keys and by ear."""

    def __init__(self, kiosk):
        self.kiosk = kiosk

    def say(self, key, *parts):
        self.kiosk.listen()
        self.kiosk.press(key)
        return self.kiosk.hear(*parts)

    def to_list(self):
        """From anywhere: F1 tells where help is, two Escapes lead out of all but the list itself."""
        self.kiosk.listen()
        told = (line["text"] for line in reversed(self.kiosk.heard) if line.get("cause") == "key")
        if next(told, "").startswith("Leave Farol?"):  # where Escape is a yes
            self.say("Down", "Going on")
            return
        for _ in range(12):
            _, said = self.measure("Escape", own=True)
            if "Leave Farol?" in said:
                self.say("Down", "Going on")
                return
        raise LookupError(f"the list of places was not reached; heard: {[line['text'] for line in self.kiosk.heard[-12:]]}")

    def two_keys(self, wanted):
        told = (line["text"] for line in reversed(self.kiosk.heard)
                if line["text"].startswith(("Two keys:", "All keys are")))
        if next(told, "").startswith("Two keys:") != wanted:
            self.say("F4", "Two keys", "All keys")

    def quiet(self, wanted):
        told = (line["text"] for line in reversed(self.kiosk.heard)
                if line["text"].startswith("Quiet:") or "everything again" in line["text"])
        if next(told, "").startswith("Quiet:") != wanted:
            self.say("m", "Quiet", "everything again")

    def bring(self, state):
        self.to_list()
        self.two_keys(False)
        way = state.split(": ")[-1]
        if way != "quiet":
            self.quiet(False)
        if way == "search":
            self.say("f", "Type part")
        elif way == "help":
            self.say("F1", "Keys.")
        elif way == "leave?":
            self.say("Escape", "Leave Farol?")
        elif way == "category":
            self.say("Right", "place")
        elif way in ("preview", "walking", "quiet", "stop?"):
            self.choose("Library", "l", "i", "b")
            if way != "preview":
                self.say("Return", "")
            if way == "quiet":
                self.quiet(True)
            if way == "stop?":
                self.say("Escape", "Stop the guidance?")
        elif way == "arrived":
            self.choose("Office 0.03", "0", "period", "0", "3")
            arrival = ("already there", "there already", "have arrived", "have probably arrived")
            try:
                self.kiosk.hear_since_key(*arrival, seconds=5.0)
            except TimeoutError:  # the states before have led the user away
                self.say("Return", "")
                self.kiosk.hear_since_key(*arrival, seconds=LED_S)
        if state.startswith("two keys"):
            self.two_keys(True)

    def choose(self, name, *letters):
        if letters[0] != "0":
            self.say("f", "Type part")
        for letter in letters:
            self.say(letter, " place")
        for _ in range(30):
            if name in self.kiosk.heard[-1]["text"]:
                break
            self.say("Down", " of ")
        self.say("Return", "To: ")

    def measure(self, key, own=False):
        """Milliseconds until the answer to this key; what was said. None: silence."""
        self.kiosk.listen()
        seen = len(self.kiosk.lines)
        pressed = self.kiosk.press(key)
        deadline = pressed + SILENT_S
        while time.monotonic() < deadline:
            self.kiosk.listen()
            for line in self.kiosk.lines[seen:]:
                begun = line["type"] == "utterance" and line["state"] in ("speaking", "shown")
                if own and line.get("cause") != "key":
                    continue  # a late answer to an older question
                if begun and line["at"] >= pressed and ("key" in line or line["text"] == "One moment."):
                    return 1000.0 * (line["at"] - pressed), line["text"]
            time.sleep(0.005)
        return None, ""


STATES = ["list", "category", "search", "preview", "walking", "quiet", "arrived", "stop?", "leave?", "help",
          "two keys: list", "two keys: preview", "two keys: walking"]


def leaves(state, key):
    """Keys that mean yes to "Leave Farol?" end the program."""
    return state == "leave?" and key in ("Return", "Escape", "KP_Enter", "KP_Begin", "KP_Delete")


def measure_state(driver, state, rounds):
    times, silent = [], []
    stays = False
    for _ in range(rounds):
        for key in KEYS:
            if leaves(state, key):
                continue
            if not stays:
                driver.bring(state)
            taken, said = driver.measure(key)
            if taken is None:
                silent.append(key)
            else:
                times.append((taken, key, said))
            # What certainly leaves the state as it is needs no way back.
            stays = "does nothing" in said or said == "One moment."
            if key in ("F4", "KP_Subtract", "KP_Add", "F2", "m", "KP_Divide"):
                restore(driver, key, said)
                stays = False
    return times, silent


LANGUAGES = ["português agora", "Ahora hablo español", "Je parle français", "Ich spreche jetzt Deutsch", "English now"]


def restore(driver, key, said):
    """Settings are as before for the next key."""
    # (In the list of keys it is only told of; to a question it is a no like any other key.)
    if key == "F2" and not said.startswith(("F2:", "Going on")):
        # By what each language says: a new voice begins the sentence again that it found, so that counting misleads.
        if not any(words in said for words in LANGUAGES):  # an answer to the key before came first
            said = driver.kiosk.hear_since_key(*LANGUAGES)
        at = next(i for i, words in enumerate(LANGUAGES) if words in said)
        for words in LANGUAGES[at + 1:]:
            driver.say("F2", words)
    if key in ("m", "KP_Divide") and "Quiet" in said:
        driver.say("m", "everything again")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    root = pathlib.Path(__file__).resolve().parents[3]
    parser.add_argument("--build", type=pathlib.Path, default=root / "build" / "release")
    parser.add_argument("--state", action="append", choices=STATES)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--show", action="store_true", help="every key and what it said")
    arguments = parser.parse_args()

    screen = Screen()
    kiosk = Kiosk(arguments.build / "bin" / "farol", screen, None,
                  ["--lang", "en", "--map", str(root / "resources/demo/demo.gpkg"),
                   "--library", str(arguments.build / "demo-library.gpkg"), "--source", "sim:0.03"])
    fine = True
    every = []
    try:
        kiosk.hear("Choose a destination", seconds=120)
        driver = Driver(kiosk)
        driver.choose("Office 0.06", "0", "period", "0", "6")
        kiosk.hear("Destination: ", seconds=240)  # the camera runs
        print("| state | keys | silent | median, ms | 95th | worst | the slowest |")
        print("|---|---:|---:|---:|---:|---:|---|")
        for state in arguments.state or STATES:
            times, silent = measure_state(driver, state, arguments.rounds)
            times.sort()
            every += times
            fine = fine and not silent and statistics.median(t[0] for t in times) <= GOAL_MS
            print(f"| {state} | {len(times) + len(silent)} | {len(silent)}{': ' + ' '.join(silent) if silent else ''} | "
                  f"{statistics.median(t[0] for t in times):.1f} | {times[int(0.95 * (len(times) - 1))][0]:.1f} | "
                  f"{times[-1][0]:.1f} | {times[-1][1]} |", flush=True)
            if arguments.show:
                for taken, key, said in times:
                    print(f"    {key}: {taken:.1f} ms \"{said[:90]}\"", file=sys.stderr)
        every.sort()
        print(f"| all | {len(every)} | | {statistics.median(t[0] for t in every):.1f} | "
              f"{every[int(0.95 * (len(every) - 1))][0]:.1f} | {every[-1][0]:.1f} | {every[-1][1]} |")
        driver.to_list()
        began = kiosk.leave()
        goodbye = next(line["at"] for line in reversed(kiosk.lines) if line.get("text") == "Goodbye.")
        print(f"\nEscape held down: \"Goodbye.\" {goodbye - began:.2f} s after it went down")
        return 0 if fine else 1
    finally:
        kiosk.close()
        screen.close()


if __name__ == "__main__":
    sys.exit(main())
