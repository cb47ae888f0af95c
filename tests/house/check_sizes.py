#!/usr/bin/env python3
"""Fails when a source file is over 600 lines (CONTRIBUTING.md): split it along its responsibilities."""
import sys
from pathlib import Path

LIMIT = 600
root = Path(sys.argv[1])
long = []
for part in ("core", "ui", "app", "tests"):
    for path in (root / part).rglob("*"):
        if path.suffix in {".h", ".cpp", ".py"}:
            lines = len(path.read_text(encoding="utf-8").splitlines())
            if lines > LIMIT:
                long.append(f"{path}: {lines} lines, {LIMIT} are allowed")
print("\n".join(long))
sys.exit(1 if long else 0)
