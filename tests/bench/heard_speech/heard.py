#!/usr/bin/env python3
"""Is the guidance understood when it is heard? What walks really said, spoken by the voice that users hear through
a sound card, recorded there, and written down by pocketsphinx, which knows the patterns of the guidance but not what
was said.

    tests/bench/heard_speech/heard.py [--build build/release] [--count 100] [--language en_US] [--rate 0] [--keep FOLDER]

Packages: pocketsphinx pocketsphinx-en-us pulseaudio pulseaudio-utils. It prints the word accuracy (1 - word error
rate) and the utterances that were misheard.
"""

import argparse
import collections
import hashlib
import os
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(HERE.parent / "kiosk"))
from desk import SoundCard  # noqa: E402

MODEL = pathlib.Path("/usr/share/pocketsphinx/model/en-us")
# Chosen on the sentences of --tuning. The recording has no noise to be taken out and no pauses to be cut off (both take
# words along). All branches of the grammar are equally likely: at the usual weight (6.5, for a language model) long
# branches are dropped for silence. No lattice, and wide beams: with the usual ones no path survives in long sentences.
SETTINGS = ["-remove_noise", "no", "-remove_silence", "no", "-dither", "yes", "-cmn", "batch", "-lw", "1",
            "-beam", "1e-100", "-wbeam", "1e-80", "-pbeam", "1e-100", "-bestpath", "no"]
BUILDING = ROOT / "resources/demo/demo.gpkg"
# Walks through every storey, by stairs and by the lift. Their words are the material, whether they arrive or not.
WALKS = ["0.03 Library", "Atrium 2.24", "Forecourt 2.43", "2.42 Bar", "1.21 0.28", "0.26 1.44", "Library Kitchen",
         "2.01 2.32", "1.10 Terrace", "Forecourt 1.42", "2.41 0.08", "0.21 2.08", "1.32 2.05", "Bar 1.08"]
# Words of the guidance that the dictionary of pocketsphinx lacks.
PRONOUNCED = {"forecourt": "F AO R K AO R T"}
DIGITS = "zero one two three four five six seven eight nine".split()
TEENS = "ten eleven twelve thirteen fourteen fifteen sixteen seventeen eighteen nineteen".split()
TENS = "- - twenty thirty forty fifty sixty seventy eighty ninety".split()


def number_words(number):
    if number < 10:
        return DIGITS[number]
    if number < 20:
        return TEENS[number - 10]
    if number < 100:
        return TENS[number // 10] + (" " + DIGITS[number % 10] if number % 10 else "")
    rest = number % 100
    return f"{DIGITS[number // 100]} hundred" + (f" and {number_words(rest)}" if rest else "")


def words(text):
    """A sentence as it is spoken: 2.24 is "two point two four"."""
    text = text.lower().replace("’", "'")
    text = re.sub(r"(\d+)\.(\d+)",
                  lambda m: f" {number_words(int(m[1]))} point {' '.join(DIGITS[int(d)] for d in m[2])} ", text)
    text = re.sub(r"\d+", lambda m: f" {number_words(int(m[0]))} ", text)
    return re.sub(r"[^a-z' ]", " ", text).split()


def what_walks_say(cli):
    """Every different sentence of these walks."""
    said = set()
    for seed, pair in enumerate(WALKS, start=1):
        start, goal = pair.split()
        run = subprocess.run([cli, "simulate", BUILDING, "--from", start, "--to", goal, "--obey", "--no-vision",
                              "--transcript", "--seed", str(seed)], capture_output=True, text=True, check=False)
        for text in re.findall(r'^ +[\d.]+ s +"(.+)"$', run.stdout, re.MULTILINE):
            said.add(text)
    return sorted(said)


def sample(utterances, count, tuning):
    """The same ones each time, of all kinds: by a hash of the text. Settings are chosen on other ones."""
    by_hash = sorted(utterances, key=lambda text: hashlib.sha256(text.encode()).hexdigest())
    return sorted(by_hash[count:2 * count] if tuning else by_hash[:count])


def grammar():
    with sqlite3.connect(f"file:{BUILDING}?mode=ro", uri=True) as file:
        places = {" ".join(words(name)) for (name,) in file.execute("select name from regions")}
        levels = {" ".join(words(name)) for (name,) in file.execute("select name from levels")}
    text = (HERE / "guidance_en.jsgf").read_text(encoding="utf-8")
    return text.replace("@PLACES@", "\n | ".join(sorted(places))).replace("@LEVELS@", " | ".join(sorted(levels)))


def closed_grammar(utterances):
    """For comparison: the very sentences, one of which it must have been."""
    sentences = sorted({" ".join(words(text)) for text in utterances})
    return "#JSGF V1.0;\ngrammar said;\npublic <said> = " + "\n | ".join(sentences) + ";\n"


def dictionary(file, vocabulary):
    known = collections.defaultdict(list)
    for line in (MODEL / "cmudict-en-us.dict").read_text(encoding="utf-8").splitlines():
        word, phones = line.split(" ", 1)
        known[word.split("(")[0]].append(phones)
    for word, phones in PRONOUNCED.items():
        known.setdefault(word, []).append(phones)
    missing = sorted(vocabulary - set(known))
    if missing:
        sys.exit(f"heard.py: no pronunciation of {', '.join(missing)}: add it to PRONOUNCED")
    lines = [f"{word}{f'({i + 1})' if i else ''} {phones}" for word in sorted(vocabulary)
             for i, phones in enumerate(known[word])]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


def speak_and_record(say, utterances, language, rate, folder):
    """One WAV for each, from what the sound card was given to play. How many the voice could not say."""
    card = SoundCard()
    failures = 0
    voice = subprocess.Popen([say, language, str(rate)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                             env={**os.environ, **card.environment, "QT_QPA_PLATFORM": "offscreen"})
    try:
        for index, text in enumerate(utterances):
            recorder = card.record(folder / f"{index:04}.wav")
            time.sleep(0.4)
            print(text, file=voice.stdin, flush=True)
            outcome = voice.stdout.readline().strip()
            if outcome != "finished":
                failures += 1
                print(f"heard.py: \"{text}\": {outcome}", file=sys.stderr)
            time.sleep(0.3)
            recorder.terminate()
            recorder.wait()
            if sys.stderr.isatty():
                print(f"\r{index + 1} of {len(utterances)}", end="", file=sys.stderr, flush=True)
        voice.stdin.close()
        voice.wait()
    finally:
        if voice.poll() is None:
            voice.kill()
        card.close()
    return failures


def transcribe(grammar_text, count, folder):
    (folder / "grammar.jsgf").write_text(grammar_text, encoding="utf-8")
    vocabulary = set(re.findall(r"[a-z][a-z']*", re.sub(r"//.*|<[^>]*>|grammar \w+;|public", "", grammar_text).lower()
                                .replace("#jsgf v1.0;", "")))
    dictionary(folder / "words.dict", vocabulary)
    (folder / "recordings").write_text("".join(f"{i:04}\n" for i in range(count)), encoding="utf-8")
    run = subprocess.run(
        ["pocketsphinx_batch", "-hmm", MODEL / "en-us", "-dict", folder / "words.dict", "-jsgf", folder / "grammar.jsgf",
         "-ctl", folder / "recordings", "-cepdir", folder, "-cepext", ".wav", "-adcin", "yes", "-adchdr", "44",
         "-samprate", "16000", *SETTINGS, "-hyp", folder / "heard.txt"],
        capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit("heard.py: pocketsphinx_batch failed:\n" + run.stderr[-2000:])
    heard = [[] for _ in range(count)]
    for line in (folder / "heard.txt").read_text(encoding="utf-8").splitlines():
        found = re.match(r"(.*) \((\d{4}) -?\d+\)$", line)
        if found:
            heard[int(found[2])] = found[1].split()
    return heard


def mistakes(said, heard):
    """Fewest words to change, leave out or put in, and which pairs were changed."""
    table = [[(0, [])] * (len(heard) + 1) for _ in range(len(said) + 1)]
    for i in range(len(said) + 1):
        for j in range(len(heard) + 1):
            if i == 0 and j == 0:
                continue
            ways = []
            if i and j:
                cost, pairs = table[i - 1][j - 1]
                same = said[i - 1] == heard[j - 1]
                ways.append((cost + (not same), pairs if same else pairs + [(said[i - 1], heard[j - 1])]))
            if i:
                cost, pairs = table[i - 1][j]
                ways.append((cost + 1, pairs + [(said[i - 1], "")]))
            if j:
                cost, pairs = table[i][j - 1]
                ways.append((cost + 1, pairs + [("", heard[j - 1])]))
            table[i][j] = min(ways, key=lambda way: way[0])
    return table[-1][-1]


def report(title, utterances, heard, details):
    wrong = total = whole = 0
    confused = collections.Counter()
    for text, transcript in zip(utterances, heard):
        said = words(text)
        cost, pairs = mistakes(said, transcript)
        wrong += cost
        total += len(said)
        whole += cost == 0
        confused.update(pairs)
        if details and cost:
            print(f'  "{text}"\n     heard: {" ".join(transcript) or "(nothing)"}')
    print(f"{title}: word accuracy {100 * (1 - wrong / total):.1f} % ({total} words, {wrong} mistakes), "
          f"{whole} of {len(utterances)} utterances without a mistake")
    if details:
        print("  most often: " + ", ".join(f"{a or '-'} as {b or '-'} {n}" for (a, b), n in confused.most_common(15)))
    return 1 - wrong / total


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--language", default="en", help="en: as users hear it (British); en_US: the American voice")
    parser.add_argument("--rate", type=float, default=0.0)
    parser.add_argument("--keep", type=pathlib.Path, help="keep the recordings there; those that are there are used")
    parser.add_argument("--tuning", action="store_true", help="the next sentences instead, to choose settings on")
    parser.add_argument("--closed", action="store_true", help="also with the very sentences as the grammar")
    parser.add_argument("--details", action="store_true", help="what was misheard")
    arguments = parser.parse_args()

    utterances = sample(what_walks_say(arguments.build / "bin/farol-cli"), arguments.count, arguments.tuning)
    with tempfile.TemporaryDirectory(prefix="farol-heard-") as scratch:
        folder = arguments.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        listed = folder / "utterances.txt"
        if not (listed.exists() and listed.read_text(encoding="utf-8").splitlines() == utterances):
            failures = speak_and_record(arguments.build / "bin/farol-bench-say", utterances, arguments.language, arguments.rate, folder)
            if failures:
                print(f"{failures} of {len(utterances)} utterances were not spoken")
            listed.write_text("\n".join(utterances) + "\n", encoding="utf-8")
        print(f"{len(utterances)} utterances, voice {arguments.language}, rate {arguments.rate:g}")
        accuracy = report("Patterns of the guidance", utterances, transcribe(grammar(), len(utterances), folder),
                          arguments.details)
        if arguments.closed:
            report("The very sentences, for comparison", utterances,
                   transcribe(closed_grammar(utterances), len(utterances), folder), False)
    return 0 if accuracy >= 0.9 else 1


if __name__ == "__main__":
    sys.exit(main())
