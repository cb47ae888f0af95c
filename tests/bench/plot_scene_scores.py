#!/usr/bin/env python3
"""Draws the correlations of `farol-cli evaluate scenes --json` (on standard input) as an SVG (on standard output)."""
import json
import sys

WIDTH, HEIGHT, MARGIN = 760, 320, 56
SERIES = [("one scene", "#1b6ca8"), ("two scenes", "#c8553d")]


def panel(rows, what, threshold, top):
    peak = max(max(row[f"{name}, {what}"] for name, _ in SERIES) for row in rows)
    left, right, bottom = MARGIN, WIDTH - 20, top + HEIGHT - MARGIN
    width = rows[1]["from"] - rows[0]["from"]
    step = (right - left) / len(rows)
    scale = (HEIGHT - 2 * MARGIN - 16) / peak
    out = [f'<text x="{left}" y="{top + 24}" font-weight="bold">Correlation to the {what} frame</text>']
    spacing = 0.05 if peak > 0.12 else 0.02
    for tick in range(1, int(peak / spacing) + 1):
        y = bottom - tick * spacing * scale
        out.append(f'<line x1="{left}" y1="{y:.1f}" x2="{right}" y2="{y:.1f}" stroke="#ddd"/>')
        out.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{tick * spacing:.0%}</text>')
    for i, row in enumerate(rows):
        for k, (name, colour) in enumerate(SERIES):
            height = row[f"{name}, {what}"] * scale
            out.append(f'<rect x="{left + (i + 0.04 + k * 0.46) * step:.1f}" y="{bottom - height:.1f}" '
                       f'width="{step * 0.46:.1f}" height="{height:.1f}" fill="{colour}"/>')
    for i in range(0, len(rows) + 1, 4):
        label = round(rows[0]["from"] + i * width, 1) + 0.0  # no minus before zero
        out.append(f'<text x="{left + i * step:.1f}" y="{bottom + 16}" text-anchor="middle">{label:.1f}</text>')
    out.append(f'<line x1="{left}" y1="{bottom}" x2="{right}" y2="{bottom}" stroke="#444"/>')
    out.append(f'<text x="{right}" y="{bottom + 34}" text-anchor="end">'
               f'correlation, in steps of {width:.2f}; height: share of the pairs of that colour</text>')
    at = left + (threshold - rows[0]["from"]) / width * step
    out.append(f'<line x1="{at:.1f}" y1="{top + 36}" x2="{at:.1f}" y2="{bottom}" stroke="#222" stroke-dasharray="5 4"/>')
    out.append(f'<text x="{at - 6:.1f}" y="{top + 46}" text-anchor="end">a new scene begins below {threshold:.2f}</text>')
    return out


def main():
    tables = json.load(sys.stdin)["tables"]
    least = {row["against"]: row["least correlation"] for row in tables[0]["rows"]}
    rows = tables[1]["rows"]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{2 * HEIGHT + 20}" '
           'font-family="sans-serif" font-size="12">', '<rect width="100%" height="100%" fill="white"/>']
    out += panel(rows, "previous", least["previous frame"], 0)
    out += panel(rows, "first", least["first frame"], HEIGHT)
    for k, (name, colour) in enumerate(SERIES):
        x = WIDTH - 330 + 160 * k
        out.append(f'<rect x="{x}" y="12" width="12" height="12" fill="{colour}"/><text x="{x + 18}" y="23">pairs of {name}</text>')
    out.append("</svg>")
    print("\n".join(out))


main()
