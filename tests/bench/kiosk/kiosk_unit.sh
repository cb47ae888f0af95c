#!/bin/bash
# The kiosk as a systemd user unit: it starts with the graphical session, comes back after a crash, and ends with the
# session. A user manager of its own is started for this, with a home of its own and an Xvfb for a screen.
#
#   tests/bench/kiosk/kiosk_unit.sh [build/release]
#
# Needs systemd, Xvfb and a session's right to a control group (root in a container has it). Exit code 1: it does not hold.
set -euo pipefail
root=$(cd "$(dirname "$0")/../../.." && pwd)
build=$(realpath "${1:-$root/build/release}")
work=$(mktemp -d)
jobs_started=()
tidy() {
  for job in "${jobs_started[@]}"; do kill "$job" 2>/dev/null || true; done
  wait
  rm -rf "$work"
}
trap tidy EXIT

export HOME=$work/home XDG_RUNTIME_DIR=$work/run FAROL_SPEECH_WAV=$work/speech LC_ALL=C.UTF-8
unset XDG_CONFIG_HOME XDG_DATA_HOME DBUS_SESSION_BUS_ADDRESS
mkdir -p "$HOME/.config/systemd/user/farol-kiosk.service.d"
mkdir -m 700 "$XDG_RUNTIME_DIR"
cmake --install "$build" --prefix "$work/farol" >/dev/null
units=$HOME/.config/systemd/user log=$work/utterances.jsonl
cp "$work/farol/lib/systemd/user/farol-kiosk.service" "$units/"
systemd-analyze --user verify "$units/farol-kiosk.service"

Xvfb -displayfd 3 -screen 0 1280x800x24 3>"$work/display" 2>/dev/null &
jobs_started+=($!)
until [ -s "$work/display" ]; do sleep 0.1; done
export DISPLAY=:$(cat "$work/display")

# What it says since the last time it was asked.
told=0
said() {
  tail -n "+$((told + 1))" "$log" | sed -n '/"speaking"/s/.*"text":"\([^"]*\)".*/\1/p'
  told=$(wc -l <"$log")
}
hear() { # until these words come
  for _ in $(seq 600); do
    if [ -e "$log" ] && tail -n "+$((told + 1))" "$log" | grep -q "$1"; then return; fi
    sleep 0.1
  done
  echo "\"$1\" was not said within a minute" >&2
  exit 1
}
expect() {
  echo "$1: $2"
  [ "$2" = "$3" ] || { echo "$3 was expected" >&2; exit 1; }
}

# By hand once, as the unit's own head says: map, landmarks and camera are those of the last time.
"$work/farol/bin/farol" --kiosk --lang en --map "$root/resources/demo/demo.gpkg" \
  --library "$build/demo-library.gpkg" --source sim:0.03 --utterances "$log" >/dev/null 2>&1 &
by_hand=$!
hear "Choose a destination"
kill "$by_hand"
wait "$by_hand" 2>/dev/null || true
said >/dev/null

printf '[Service]\nExecStart=\nExecStart="%s" --kiosk --utterances "%s"\n' "$work/farol/bin/farol" "$log" \
  >"$units/farol-kiosk.service.d/log.conf"
printf '[Unit]\nBindsTo=graphical-session.target\n' >"$units/a-session.target" # as desktops do it
made=
if [ ! -d /run/systemd/system ]; then # a container that was not booted by systemd
  mkdir -p /run/systemd/system
  made=yes
fi
/lib/systemd/systemd --user >/dev/null 2>&1 &
jobs_started+=($!)
until systemctl --user is-system-running >/dev/null 2>&1; do sleep 0.1; done
if [ -n "$made" ]; then rmdir /run/systemd/system; fi
systemctl --user import-environment DISPLAY FAROL_SPEECH_WAV LC_ALL
systemctl --user enable --quiet farol-kiosk.service

unit() { systemctl --user show --property "$1" --value farol-kiosk.service; }
expect "before the session" "$(unit ActiveState)" inactive
systemctl --user start a-session.target
hear "Choose a destination"
expect "in the session" "$(unit ActiveState)" active
said
kill -SEGV "$(unit MainPID)"
hear "Choose a destination"
expect "after a crash" "$(unit ActiveState)" active
expect "restarts" "$(unit NRestarts)" 1
said
systemctl --user stop a-session.target
for _ in $(seq 100); do
  [ "$(unit ActiveState)" = inactive ] && break
  sleep 0.1
done
expect "after the session" "$(unit ActiveState)" inactive
expect "ended with" "$(unit Result)" success
