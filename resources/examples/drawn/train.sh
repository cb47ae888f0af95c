#!/usr/bin/env bash
# Trains the landmark library of the drawn example from the pictures in train/. Usage: train.sh OUT.gpkg
# FAROL_CLI: the farol-cli to use (default build/release/bin/farol-cli). OUT.gpkg appears only when all went well.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
top="$(cd "$here/../../.." && pwd)"
out="${1:?usage: train.sh OUT.gpkg}"
cli="${FAROL_CLI:-$top/build/release/bin/farol-cli}"

[ -x "$cli" ] || { echo "train.sh: there is no $cli; build first, or name it in FAROL_CLI" >&2; exit 1; }
[ ! -e "$out" ] || { echo "train.sh: $out exists already; remove it first" >&2; exit 1; }

unfinished="$(dirname "$out")/unfinished-$$-$(basename "$out")"
trap 'rm -f "$unfinished"' EXIT
views=0
while read -r picture template kind width outline; do
  case "$picture" in ''|'#'*) continue ;; esac
  "$cli" train "$unfinished" --template "$template" --kind "$kind" --width-m "$width" --outline "$outline" \
    "$here/train/$picture" >/dev/null </dev/null
  views=$((views + 1))
done <"$here/train/views.txt"
mv "$unfinished" "$out"
echo "trained $views views into $out" >&2
