#!/usr/bin/env bash
# find_object.sh FIND_OBJECT FAROL_CLI DATA: Farol and introlab/find-object on DATA/images/planar_landmarks, at the
# same time. FIND_OBJECT is a checkout of find-object built in its folder build (needs qtbase5-dev, libopencv-dev):
#   cmake -S FIND_OBJECT -B FIND_OBJECT/build -DCMAKE_BUILD_TYPE=Release -DWITH_TORCH=OFF && cmake --build FIND_OBJECT/build
# Prints Markdown rows of the peer: recall easy, medium, hard; precision; false; frames without a template; CPU ms.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
peer=$1 farol=$2 data=$3
folder=$(mktemp -d "${TMPDIR:-/tmp}/farol-find-object.XXXXXX")
trap 'rm -rf "$folder"' EXIT
library=$(find "$peer/bin" "$peer/build" -name 'libfind_object.so' | head -1)
# shellcheck disable=SC2046
g++ -std=c++17 -O2 -fPIC -w "$here/find_object_run.cpp" -o "$folder/run" -I"$peer/include" -I"$peer/build/include" \
  $(pkg-config --cflags --libs Qt5Core Qt5Gui opencv4) "$library" -Wl,-rpath,"$(dirname "$library")"
best=(--Feature2D/SIFT_rootSIFT true --Feature2D/SIFT_contrastThreshold 0.01 --NearestNeighbor/4nndrRatio 0.9
  --Homography/minimumInliers 8 --Homography/ransacReprojThr 5)
set=$data/images/planar_landmarks
export QT_QPA_PLATFORM=offscreen
# All three at once: what else the machine does slows them alike.
"$folder/run" "$set" >"$folder/default" 2>/dev/null &
"$folder/run" "$set" "${best[@]}" >"$folder/best" 2>/dev/null &
"$farol" evaluate recognition --data "$data"
wait
echo "find-object, default:"
grep '^|' "$folder/default"
echo "find-object, best (${best[*]}):"
grep '^|' "$folder/best"
