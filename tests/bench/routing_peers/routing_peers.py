#!/usr/bin/env python3
"""Routes over the same doors with NetworkX and pgRouting, beside what farol-bench-routing found.

Usage: routing_peers.py FOLDER SIZE... : FOLDER holds campus-SIZE.{nodes,edges,pairs,boost}.csv. pgRouting is asked
through psql (PGHOST and PGUSER as for every libpq program). Prints a Markdown table; ends with 1 when a peer's least
time differs from Farol's by more than 1 mm of walking.
"""
import math
import statistics
import subprocess
import sys
import time
from pathlib import Path

import networkx

SPEED = 0.8  # metres a second, as in RouteOptions
TIGHT = 0.999999  # of the lower bounds: the rounding of edges must not break them
# Pairs asked at each size: a peer that takes seconds for one is asked fewer.
PAIRS = {"networkx": {100: 300, 1000: 100, 10000: 20, 100000: 3},
         "pgrouting": {100: 100, 1000: 40, 10000: 10, 100000: 2}}


def rows(path):
    with open(path, encoding="ascii") as file:
        return [line.rstrip("\n").split(",") for line in file]


def asked(peer, size, pairs):
    """Spread over all pairs, so that near and far ones are among them."""
    count = min(PAIRS[peer].get(size, 10), len(pairs))
    return pairs[::max(1, len(pairs) // count)][:count]


def with_networkx(folder, size, pairs):
    graph = networkx.DiGraph()
    places = {int(node): (float(x), float(y)) for node, x, y in rows(folder / f"campus-{size}.nodes.csv")}
    for _, start, end, seconds in rows(folder / f"campus-{size}.edges.csv"):
        start, end, seconds = int(start), int(end), float(seconds)
        known = graph.get_edge_data(start, end)
        if known is None or seconds < known["seconds"]:
            graph.add_edge(start, end, seconds=seconds)

    def bound(a, b):
        (ax, ay), (bx, by) = places[a], places[b]
        return math.hypot(ax - bx, ay - by) * TIGHT / SPEED

    answers = {"NetworkX dijkstra_path": [], "NetworkX astar_path": []}
    for _, start, goal, least, _ in asked("networkx", size, pairs):
        start, goal = int(start), int(goal)
        for name, plan in (("NetworkX dijkstra_path", lambda: networkx.dijkstra_path(graph, start, goal, "seconds")),
                           ("NetworkX astar_path", lambda: networkx.astar_path(graph, start, goal, bound, "seconds"))):
            begin = time.thread_time()
            path = plan()
            took = 1000 * (time.thread_time() - begin)
            answers[name].append((took, networkx.path_weight(graph, path, "seconds"), float(least)))
    return answers


def psql(database, sql):
    done = subprocess.run(["psql", "-qAt", "-v", "ON_ERROR_STOP=1", "-d", database], input=sql, capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"psql: {done.stderr}")
    return done.stdout


def with_pgrouting(folder, size, pairs):
    database = f"campus_{size}"
    psql("postgres", f"CREATE DATABASE {database}")
    setup = (Path(__file__).parent / "pgrouting.sql").read_text(encoding="ascii")
    columns = {"nodes": "id, x, y", "edges": "id, source, target, cost"}
    copies = [f"\\copy {table} ({names}) FROM '{folder}/campus-{size}.{table}.csv' (FORMAT csv)\n"
              for table, names in columns.items()]
    psql(database, setup + "".join(copies) + "CALL make_ready();\nVACUUM FULL ANALYZE edges;\n")
    answers = {}
    for name, plan in (("pgRouting pgr_dijkstra", "dijkstra"), ("pgRouting pgr_aStar", "astar")):
        wanted = asked("pgrouting", size, pairs)
        values = ",".join(f"({number},{start},{goal})" for number, start, goal, _, _ in wanted)
        said = psql(database, f"SELECT number, ms, seconds FROM (VALUES {values}) AS p (number, start, goal), "
                              f"LATERAL ask_{plan}(start, goal, {5 if size <= 1000 else 1}) ORDER BY number;\n")
        least = {number: float(seconds) for number, _, _, seconds, _ in wanted}
        answers[name] = [(float(ms), float(seconds), least[number])
                         for number, ms, seconds in (line.split("|") for line in said.splitlines())]
    psql("postgres", f"DROP DATABASE {database}")
    return answers


def main():
    folder = Path(sys.argv[1]).resolve()
    wrong = False
    print("| regions | planner | pairs | median ms | of Farol's on these pairs | largest difference mm |")
    print("|---:|---|---:|---:|---:|---:|")
    for size in map(int, sys.argv[2:]):
        pairs = rows(folder / f"campus-{size}.pairs.csv")
        own = {float(least): float(ms) for _, _, _, least, ms in pairs}
        print(f"| {size} | Farol | {len(pairs)} | {statistics.median(own.values()):.4f} | 1 | |")
        boost = [(float(ms), float(seconds), float(pair[3]))
                 for pair, (_, seconds, ms) in zip(pairs, rows(folder / f"campus-{size}.boost.csv"))]
        answers = {"Boost.Graph astar_search": boost}
        answers.update(with_networkx(folder, size, pairs))
        answers.update(with_pgrouting(folder, size, pairs))
        for name, found in answers.items():
            apart = 1000 * SPEED * max(abs(seconds - least) for _, seconds, least in found)
            wrong = wrong or not apart <= 1.0
            took = statistics.median(ms for ms, _, _ in found)
            ours = statistics.median(own[least] for _, _, least in found)
            print(f"| {size} | {name} | {len(found)} | {took:.4g} | {took / ours:.4g} | {apart:.3f} |", flush=True)
    if wrong:
        sys.exit("a planner's least time differs by more than 1 mm")


main()
