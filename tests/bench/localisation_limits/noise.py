#!/usr/bin/env python3
"""How much the figures of 48 walks would differ on 48 others of their kind.

    tests/bench/localisation_limits/noise.py FAROL_CLI ../shared/data

Walks are drawn again with replacement (bootstrap): what happens within one hangs together, so the seconds of a
walk are no samples of their own. For the calibration error it is told besides what a perfectly calibrated filter
would show on so few walks: the error of what is left of each bin when its own mean is taken off.
"""

import argparse
import bisect
import json
import random
import subprocess
import sys
from pathlib import Path

DRAWS, BINS = 2000, 10


def seconds_of(cli, building, truth):
    """Confidence, right?, near confidence, right or next to?, level right? for each line of the truth."""
    log = truth.with_name(truth.name.replace(".truth", ""))
    done = subprocess.run([cli, "locate", building / "map.gpkg", log, "--localiser", "bayes", "--every", "1",
                           "--json-lines"], stdout=subprocess.PIPE, text=True, check=True)
    fixes = [json.loads(line) for line in done.stdout.splitlines()]
    times = [fix["t"] for fix in fixes]
    rows = []
    for line in truth.read_text().splitlines():
        true = json.loads(line)
        latest = bisect.bisect_right(times, true["t"] + 1e-6) - 1
        if latest < 0:
            continue
        fix = fixes[latest]
        right = fix["region"] == true["region"]
        rows.append((fix["confidence"], right, fix["near_confidence"],
                     right or true["region"] in fix["near"], fix.get("level") == true["level"]))
    return rows


def bins_of(rows, column):
    counts, over = [0] * BINS, [0.0] * BINS
    for row in rows:
        cell = min(BINS - 1, int(row[column] * BINS))
        counts[cell] += 1
        over[cell] += row[column] - row[column + 1]
    return counts, over


def quantiles(values):
    values = sorted(values)
    return [values[int(share * (len(values) - 1))] for share in (0.025, 0.1, 0.5, 0.9, 0.975)]


def share(name, walks, column):
    per = [(sum(row[column] for row in rows), len(rows)) for rows in walks]
    drawn = []
    for _ in range(DRAWS):
        pick = random.choices(per, k=len(per))
        drawn.append(100.0 * sum(hits for hits, _ in pick) / sum(count for _, count in pick))
    low, _, _, _, high = quantiles(drawn)
    value = 100.0 * sum(hits for hits, _ in per) / sum(count for _, count in per)
    print(f"{name}: {value:.1f} %, 95 % of draws {low:.1f} to {high:.1f}")


def calibration(name, walks, column):
    per = [bins_of(rows, column) for rows in walks]
    counts = [sum(walk[0][i] for walk in per) for i in range(BINS)]
    mean = [sum(walk[1][i] for walk in per) / max(1, counts[i]) for i in range(BINS)]
    error = sum(abs(mean[i]) * counts[i] for i in range(BINS)) / sum(counts)
    drawn = []
    for _ in range(DRAWS):
        pick = random.choices(per, k=len(per))
        total = sum(sum(walk[0]) for walk in pick)
        drawn.append(sum(abs(sum(walk[1][i] - mean[i] * walk[0][i] for walk in pick)) for i in range(BINS)) / total)
    _, low, middle, high, highest = quantiles(drawn)
    print(f"{name}: {error:.3f}; of a perfectly calibrated one: median {middle:.3f}, 80 % {low:.3f} to {high:.3f}, "
          f"2.5 % above {highest:.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli")
    parser.add_argument("data")
    arguments = parser.parse_args()
    random.seed(1)
    walks = [seconds_of(arguments.cli, building, truth)
             for building in sorted(Path(arguments.data, "walks").iterdir())
             for truth in sorted(building.glob("*.truth.jsonl"))]
    share("region right", walks, 1)
    share("region or neighbour", walks, 3)
    share("level", walks, 4)
    calibration("calibration error, region", walks, 0)
    calibration("calibration error, in or next to", walks, 2)
    return 0


if __name__ == "__main__":
    sys.exit(main())
