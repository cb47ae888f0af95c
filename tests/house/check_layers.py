#!/usr/bin/env python3
"""Fails when a file includes over the arrows of the design (CONTRIBUTING.md, "Layers").

Reads every #include "core/..." and #include "ui/..." line. A folder may include itself and what ALLOWED lists for it;
core may not include Qt; nothing may include app; and only ui and app may include ui.
"""
import re
import sys
import tempfile
from pathlib import Path

CORE = {
    "base": set(),
    "building": {"base"},
    "routing": {"base", "building"},
    "capture": {"base"},
    "recognition": {"base", "capture"},
    "localisation": {"base", "building", "capture", "recognition"},
    "guidance": {"base", "building", "routing", "capture", "recognition", "localisation"},
    "simulation": {"base", "building", "routing", "capture", "recognition", "localisation", "guidance"},
    "session": {"base", "building", "routing", "capture", "recognition", "localisation", "guidance", "simulation"},
}
ALL_CORE = set(CORE)
UI = {
    "convert": {"speech"},  # names of the map in the language that is spoken
    "speech": set(),
    "settings": {"speech"},
    "models": {"convert", "speech"},
    "map": {"convert"},
    "parts": {"convert", "speech", "settings", "models", "map"},
    "live": {"convert", "speech", "settings", "models", "map", "parts"},
    "demo": {"convert", "speech", "settings", "models", "map", "parts", "live"},
    "training": {"convert", "speech", "settings", "models", "map", "parts"},
    "curation": {"convert", "speech", "settings", "models", "map", "parts"},
    "kiosk": {"convert", "speech", "settings", "models", "map", "parts", "live", "demo"},
    "main_window": {"convert", "speech", "settings", "models", "map", "parts", "live", "demo", "training", "curation", "kiosk"},
}
# Words are made from guidance's cues alone: the Phrasebook must not see sessions or pictures.
SPEECH_CORE = {"base", "building", "routing", "localisation", "guidance"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def violations(root: Path):
    for path in sorted(p for part in ("core", "ui") for p in (root / part).rglob("*") if p.suffix in {".h", ".cpp"}):
        parts = path.relative_to(root).parts
        layer, folder = parts[0], parts[1]
        known = CORE if layer == "core" else UI
        if folder not in known:
            yield path, 1, f"folder {layer}/{folder} stands in no layer: add it to the design first"
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            quote, target = match.groups()
            if layer == "core" and quote == "<" and re.match(r"(Q[A-Z]|Qt)", target):
                yield path, number, f"core knows no Qt, but includes <{target}>"
            pieces = target.split("/")
            if quote != '"':
                continue
            if pieces[0] not in {"core", "ui"} or len(pieces) < 3:
                yield path, number, f'"{target}" is not written from the top of the repository'
            elif pieces[0] == "core":
                allowed = CORE[folder] if layer == "core" else (SPEECH_CORE if folder == "speech" else ALL_CORE)
                if pieces[1] not in allowed and not (layer == "core" and pieces[1] == folder):
                    yield path, number, f"{layer}/{folder} may not include core/{pieces[1]}"
            elif layer == "core":
                yield path, number, f"core/{folder} may not include ui"
            elif pieces[1] != folder and pieces[1] not in UI[folder]:
                yield path, number, f"ui/{folder} may not include ui/{pieces[1]}"


def self_test():
    with tempfile.TemporaryDirectory() as name:
        root = Path(name)
        for folder, text, expected in [
            ("core/base", '#include "core/building/building.h"\n', 1),
            ("core/routing", '#include "core/building/building.h"\n#include <vector>\n', 0),
            ("core/guidance", "#include <QString>\n", 1),
            ("core/session", '#include "ui/speech/phrasebook.h"\n', 1),
            ("ui/speech", '#include "core/session/percept.h"\n', 1),
            ("ui/map", '#include "ui/live/live_page.h"\n', 1),
            ("core/other", "\n", 1),
        ]:
            target = root / folder
            target.mkdir(parents=True)
            (target / "probe.cpp").write_text(text, encoding="utf-8")
            found = [v for v in violations(root) if v[0].parent == target]
            assert len(found) == expected, (folder, found)
    print("the layer check finds what it should")


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        self_test()
        sys.exit(0)
    bad = list(violations(Path(sys.argv[1])))
    for path, number, message in bad:
        print(f"{path}:{number}: {message}")
    sys.exit(1 if bad else 0)
