#!/usr/bin/env python3
"""Draws the correlations of `farol-cli evaluate scenes --json` (on standard input) as an SVG (on standard output)."""
import json
import sys

WIDTH, HEIGHT, MARGIN = 760, 300, 46
SERIES = [("one scene", "#1b6ca8"), ("two scenes", "#c8553d")]


def panel(rows, what, threshold, top):
    peak = max(max(row[f"{name}, {what}"] for name, _ in SERIES) for row in rows)
    left, bottom = MARGIN, top + HEIGHT - MARGIN
    step = (WIDTH - 2 * MARGIN) / len(rows)
    scale = (HEIGHT - 2 * MARGIN) / peak
    out = [f'<text x="{left}" y="{top + 24}" font-weight="bold">Correlation to the {what} frame</text>']
    for i, row in enumerate(rows):
        for k, (name, colour) in enumerate(SERIES):
            height = row[f"{name}, {what}"] * scale
            out.append(f'<rect x="{left + i * step + k * step * 0.46:.1f}" y="{bottom - height:.1f}" '
                       f'width="{step * 0.44:.1f}" height="{height:.1f}" fill="{colour}"/>')
        if i % 4 == 0:
            out.append(f'<text x="{left + i * step:.1f}" y="{bottom + 16}" text-anchor="middle">{row["from"]:.1f}</text>')
    out.append(f'<line x1="{left}" y1="{bottom}" x2="{WIDTH - MARGIN}" y2="{bottom}" stroke="#444"/>')
    at = left + (threshold - rows[0]["from"]) / 1.2 * (WIDTH - 2 * MARGIN)
    out.append(f'<line x1="{at:.1f}" y1="{top + 34}" x2="{at:.1f}" y2="{bottom}" stroke="#222" stroke-dasharray="5 4"/>')
    out.append(f'<text x="{at + 5:.1f}" y="{top + 44}">a new scene begins below {threshold:.2f}</text>')
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
