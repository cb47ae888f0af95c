#!/usr/bin/env python3
"""The kiosk is killed in the middle of a way: it starts again by itself, says where the user was, and offers the same
destination.

    check_kiosk_restart.py FAROL MAP
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

PATIENCE_S = 120.0


def wait_for(check, what):
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        found = check()
        if found:
            return found
        time.sleep(0.05)
    raise TimeoutError(f"{what} did not come")


def said(log, part):
    """What was spoken that contains this, in its order."""
    lines = log.read_text(encoding="utf-8").split("\n")[:-1] if log.exists() else []
    every = [json.loads(line) for line in lines]
    return [line["text"] for line in every if line.get("state") == "speaking" and part in line["text"]]


def child_of(process):
    """The kiosk itself: the process that was started only watches over it."""
    try:
        children = pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        return None
    return int(children[0]) if children else None


def remembered(file):
    try:
        return json.loads(file.read_text(encoding="utf-8")).get("region")
    except (OSError, ValueError):
        return None


def main():
    farol, building = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="farol-restart-") as name:
        folder = pathlib.Path(name)
        log = folder / "said.jsonl"
        environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": name, "LC_ALL": "C.UTF-8",
                       "XDG_CONFIG_HOME": f"{name}/config", "XDG_DATA_HOME": f"{name}/data",
                       "FAROL_SPEECH_WAV": f"{name}/speech"}
        kiosk = subprocess.Popen([farol, "--kiosk", "--lang", "en", "--map", building, "--source", "sim:0.03",
                                  "--from", "0.03", "--to", "0.06", "--utterances", log], env=environment)
        try:
            wait_for(lambda: said(log, "To: Office 0.06"), "the destination")
            wait_for(lambda: remembered(folder / "data/farol/kiosk.json"), "the place of the user")
            for kills in (1, 2):
                killed = wait_for(lambda: child_of(kiosk.pid), "the kiosk")
                os.kill(killed, signal.SIGKILL)
                again = wait_for(lambda: said(log, "started again")[kills - 1:], "the new start")[0]
                print(again)
                assert "You were last here: Office 0.03" in again and "To: Office 0.06" in again, again
                assert not said(log, "already running"), "the killed one is taken for a second kiosk"
                assert child_of(kiosk.pid) != killed
        finally:
            kiosk.terminate()  # what it watches over ends with it
            kiosk.wait(timeout=60)
    print("ok")


if __name__ == "__main__":
    main()
