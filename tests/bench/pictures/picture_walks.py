#!/usr/bin/env python3
"""Closed-loop walks through rendered pictures, many of them, a few at a time.

    tests/bench/pictures/picture_walks.py --walks 200 --seed 4000 --log walks.jsonl [--jobs 2] [-- --unknown-start]

A walk takes minutes of a core, so each one is written down as it ends and a second start goes on where the
first stopped. The pairs are those that `farol-cli simulate --walks N --seed S` draws, in its order; what stands
behind `--` goes to every walk. With --summary nothing is walked: the log's figures are printed.
"""

import argparse
import json
import math
import os
import statistics
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

FPS = "8"


def asked(command):
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    except OSError as failure:
        raise RuntimeError(f"{command[0]} cannot be started ({failure.strerror}): ./dev build makes it") from failure
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip()[-400:]}")
    return done.stdout


def engine(cli):
    """The last commit that changed the engine: a log may hold walks of several. Of another program only its name is known."""
    if cli:
        return Path(cli).name
    git = ["git", "-C", str(Path(__file__).parent)]
    try:
        changed = asked(git + ["status", "--porcelain", "--", ":/core"]).strip()
        return asked(git + ["log", "-1", "--format=%h", "--", ":/core"]).strip() + (" changed" if changed else "")
    except RuntimeError:
        return "unknown"


def walks_in(log):
    """What was walked before; a last line that was cut off when the program was ended is walked again."""
    lines = log.read_text().splitlines(keepends=True) if log.exists() else []
    if lines and not lines[-1].endswith("\n"):
        log.write_text("".join(lines[:-1]))
        lines.pop()
    return [json.loads(line) for line in lines]


def drawn_pairs(cli, arguments):
    """Pairs and seeds do not depend on how the walks go: they are drawn before each."""
    command = [cli, "simulate", arguments.map, "--obey", "--no-vision", "--walks", str(arguments.walks), "--seed",
               str(arguments.seed), "--json"]
    if "--sparse-landmarks" in arguments.rest:
        command.append("--sparse-landmarks")
    return [(walk["from"], walk["to"], walk["seed"]) for walk in json.loads(asked(command))["walks"]]


def ended(walk):
    if walk["arrived"] and walk["announced_arrival"]:
        return "arrived"
    if walk["reason"].startswith("told of the arrival"):
        return "told elsewhere"
    return "taken for another place" if "taken for another" in walk["reason"] else "not found"


def interval(hits, count):
    """Wilson's 95 % interval of a share."""
    if count == 0:
        return 0.0, 1.0
    z, p = 1.96, hits / count
    middle = p + z * z / (2 * count)
    spread = z * math.sqrt(p * (1 - p) / count + z * z / (4 * count * count))
    return (middle - spread) / (1 + z * z / count), (middle + spread) / (1 + z * z / count)


def summary(walks):
    count = len(walks)
    if count == 0:
        print("no walks yet")
        return
    ends = {}
    for walk in walks:
        ends[ended(walk)] = ends.get(ended(walk), 0) + 1
    hits = ends.get("arrived", 0)
    low, high = interval(hits, count)
    print(f"{count} walks, {hits} arrived ({hits / count:.3f}; 95 %: {low:.2f} to {high:.2f})")
    for end, number in sorted(ends.items(), key=lambda item: -item[1]):
        print(f"  {end}: {number}")
    print(f"wrong places told: {sum(walk['wrong_region_said'] for walk in walks)}, "
          f"{sum(walk['wrong_region_said'] for walk in walks) / count:.3f} a walk")
    there = [walk for walk in walks if ended(walk) == "arrived"]
    if there:
        seconds = [walk["seconds"] for walk in there]
        print(f"of those that arrived: median {statistics.median(seconds):.0f} s, "
              f"{statistics.median(w['seconds'] / max(w['shortest_s'], 1) for w in there):.2f} times the route's, "
              f"{statistics.median(w['metres'] / max(w['shortest_m'], 1) for w in there):.2f} times its metres")
    for walk in walks:
        if ended(walk) != "arrived":
            print(f"  {walk['number']}: {walk['from']} to {walk['to']}, seed {walk['seed']}: {walk['reason']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--cli", help="another farol-cli than the build's")
    parser.add_argument("--map", default="resources/demo/demo.gpkg")
    parser.add_argument("--library", help="trained landmarks (the demo's, made by ./dev run)")
    parser.add_argument("--walks", type=int, default=200)
    parser.add_argument("--seed", type=int, default=4000)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--log", required=True, help="JSON lines; walks that stand in it are not walked again")
    parser.add_argument("--transcripts", help="folder for what was said and where the walker was, a file a walk")
    parser.add_argument("--summary", action="store_true")
    arguments, rest = parser.parse_known_args()
    arguments.rest = [word for word in rest if word != "--"]

    log = Path(arguments.log)
    walked = walks_in(log)
    if arguments.summary:
        summary(walked)
        return 0
    cli = arguments.cli or f"{arguments.build}/bin/farol-cli"
    library = arguments.library or f"{arguments.build}/demo-library.gpkg"
    done = {walk["number"] for walk in walked}
    version = engine(arguments.cli)

    def walk(number, pair):
        command = [cli, "simulate", arguments.map, "--obey", "--library", library, "--fps", FPS, "--json",
                   "--from", pair[0], "--to", pair[1], "--seed", str(pair[2])] + arguments.rest
        # The transcript comes first, the result in the last line.
        lines = asked(command + ["--transcript"]).splitlines()
        if arguments.transcripts:
            Path(arguments.transcripts, f"{number}.txt").write_text("\n".join(lines) + "\n")
        return {"number": number, "engine": version, "from": pair[0], "to": pair[1], "seed": pair[2],
                **json.loads(lines[-1])}

    if arguments.transcripts:
        Path(arguments.transcripts).mkdir(parents=True, exist_ok=True)
    try:
        pairs = list(enumerate(drawn_pairs(cli, arguments)))
    except RuntimeError as failure:
        print(failure, file=sys.stderr)
        return 1
    failed = 0
    with ThreadPoolExecutor(arguments.jobs) as pool, log.open("a") as out:
        waiting = [pool.submit(walk, number, pair) for number, pair in pairs if number not in done]
        try:
            for ready in as_completed(waiting):
                try:
                    result = ready.result()
                except RuntimeError as failure:
                    failed += 1
                    print(failure, file=sys.stderr)
                    continue
                out.write(json.dumps(result) + "\n")
                out.flush()
                walked.append(result)
                print(f"{len(walked)}/{arguments.walks} {result['number']}: {ended(result)}, "
                      f"{result['seconds']:.0f} s", flush=True)
        except KeyboardInterrupt:
            pool.shutdown(cancel_futures=True)
    summary(sorted(walked, key=lambda item: item["number"]))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
