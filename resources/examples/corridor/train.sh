#!/usr/bin/env bash
# Trains the corridor's landmark library from the first lap of the walk. Usage: train.sh OUT.gpkg [objects]
# objects: only these; the places come from a survey (tests/walk/check_corridor_survey.py).
# FAROL_CLI: the farol-cli to use (default build/release/bin/farol-cli). FAROL_DATA: where the photographs are.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
top="$(cd "$here/../../.." && pwd)"
out="${1:?usage: train.sh OUT.gpkg [objects]}"
cli="${FAROL_CLI:-$top/build/release/bin/farol-cli}"
lap="${FAROL_DATA:-$top/../shared/data}/images/corridor_walk"

[ -x "$cli" ] || { echo "train.sh: there is no $cli; build first, or name it in FAROL_CLI" >&2; exit 1; }
[ -d "$lap" ] || { echo "train.sh: the photographs are not in $lap; name their folder in FAROL_DATA" >&2; exit 1; }

# Objects: template, kind, real width in metres, picture of the first lap, outline clockwise from the object's top left.
object() { # template kind width name picture outline
  "$cli" train "$out" --template "$1" --kind "$2" --width-m "$3" --name "$4" --outline "$6" "$lap/$5.jpg" >/dev/null
}
while read -r template kind width picture outline name; do
  case "$template" in ''|'#'*) continue ;; esac
  object "$template" "$kind" "$width" "$name" "$picture" "$outline"
done <"$here/objects.txt"

# Places: the whole view of the spot.
[ "${2:-}" = objects ] || while read -r picture template _; do
  case "$picture" in ''|'#'*) continue ;; esac
  "$cli" train "$out" --template "$template" --kind place "$lap/$picture.jpg" >/dev/null
done <"$here/places.txt"
echo "trained $("$cli" library list "$out" --json | grep -o '"template"' | wc -l) templates into $out" >&2
