"""Trains the sign network: python3 train.py DATA OUT.onnx [--steps N] [--development]

With --development a part of the training third and of the rooms is held out and asked during training, to choose by;
without it everything of the training third is learnt from. The other two thirds of exit_signs_campus_tw and the rooms
kept for asking are opened by `farol-cli evaluate signs` alone."""

import argparse
import copy
import math
import time
from pathlib import Path

import cv2
import numpy as np
import torch

import finder
import pictograms
import scenes
from network import SignNetwork, export, loss

KINDS = len(pictograms.NAMES)


def lit(picture, rng):
    """In other light."""
    levels = np.arange(256, dtype=np.float32)[None, :, None] / 255
    gains = rng.uniform(0.75, 1.25) * (1 + rng.normal(0, 0.06, 3))
    table = np.clip(levels ** np.exp(rng.normal(0, 0.25)) * gains * 255, 0, 255).astype(np.uint8)
    return cv2.LUT(picture, table)


class Stream(torch.utils.data.IterableDataset):
    """Batches without end; every picture comes three times: as it is, mirrored, and mirrored in other light."""

    def __init__(self, exits, rooms, seed):
        self.exits, self.rooms, self.seed = exits, rooms, seed

    def __iter__(self):
        cv2.setNumThreads(1)
        info = torch.utils.data.get_worker_info()
        number = info.id if info else 0
        made = scenes.Scenes(self.exits, self.rooms, self.seed + number)
        rng = np.random.default_rng(self.seed + 100 + number)
        past = {256: [], 384: []}
        while True:
            size, many = (384, 8) if rng.random() < 0.4 else (256, 16)
            batch = []
            for i in range(many):
                if i % 3 and len(past[size]) > 60:
                    picture, signs = past[size].pop(int(rng.integers(len(past[size]))))
                else:
                    picture, signs = made.scene(size)
                    mirrored = signs.copy()
                    mirrored[:, [1, 3]] = size - signs[:, [3, 1]]
                    flipped = np.ascontiguousarray(picture[:, ::-1])
                    past[size].append((flipped, mirrored))
                    past[size].append((lit(flipped, rng), mirrored))
                batch.append((picture.transpose(2, 0, 1), *scenes.targets(signs, size, KINDS)))
            yield tuple(torch.from_numpy(np.stack(part)) for part in zip(*batch))


def held_out(exits, rooms):
    signs = []
    for path in exits:
        picture = cv2.imread(str(path))
        signs.append((picture, scenes.boxes_of(path, picture.shape[1], picture.shape[0])))
    return signs, [(scenes.shrunk(cv2.imread(str(path)), 800), []) for path in rooms]


def ask(network, signs, rooms, work):
    export(copy.deepcopy(network), work)
    asked = finder.Finder(work)
    for level, count, found, wrong in finder.table(asked, signs):
        print(f"    level {level:.2f}: {found} of {count} signs, {wrong} wrong", flush=True)
    for kind, name in enumerate(pictograms.NAMES):
        print(f"    {name} in {len(rooms)} rooms:", [(level, wrong) for level, _, _, wrong in finder.table(asked, rooms, kind)], flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("data", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--steps", type=int, default=4000)
    parser.add_argument("--seed", type=int, default=5)
    parser.add_argument("--development", action="store_true")
    parser.add_argument("--start", type=Path, help="weights (.pt) to go on from")
    parser.add_argument("--rate", type=float, default=3e-3)
    options = parser.parse_args()
    torch.manual_seed(options.seed)
    torch.set_num_threads(1)
    third = scenes.exit_pictures(options.data)[0::3]
    rooms = scenes.room_files(options.data)
    learnt = rooms["tower"] + rooms["walk"] + rooms["stairs"] + 2 * rooms["doors"]
    asked, asked_rooms = [], []
    if options.development:
        asked, third = third[2::3], [p for i, p in enumerate(third) if i % 3 != 2]
        asked_rooms = rooms["tower4"][::2] + rooms["doors_dev"]
    else:
        learnt += rooms["tower4"][::2] + 2 * rooms["doors_dev"]
    signs, empty = held_out(asked, asked_rooms)
    loader = torch.utils.data.DataLoader(Stream(third, learnt, options.seed), batch_size=None, num_workers=1, prefetch_factor=8)
    network = SignNetwork(KINDS)
    if options.start:
        network.load_state_dict(torch.load(options.start))
    mean = copy.deepcopy(network)
    optimiser = torch.optim.AdamW(network.parameters(), lr=options.rate, weight_decay=1e-3)
    began, shown = time.time(), np.zeros(2)
    for step, batch in zip(range(options.steps), loader):
        share = step / options.steps
        rate = options.rate * min(1.0, (step + 1) / 100) * max(0.01, 0.5 * (1 + math.cos(math.pi * share)))
        for group in optimiser.param_groups:
            group["lr"] = rate
        picture, heat, sides, inside, ignore = batch
        network.train()
        out = network(picture.float() / 255.0)
        heat_loss, box_loss = loss(out, heat, sides, inside, ignore, KINDS)
        optimiser.zero_grad()
        (heat_loss + box_loss).backward()
        torch.nn.utils.clip_grad_norm_(network.parameters(), 5.0)
        optimiser.step()
        keep = min(0.998, (step + 1) / (step + 10))
        with torch.no_grad():
            for a, b in zip(mean.state_dict().values(), network.state_dict().values()):
                a.mul_(keep).add_(b, alpha=1 - keep) if a.is_floating_point() else a.copy_(b)
        shown = 0.98 * shown + 0.02 * np.array([heat_loss.item(), box_loss.item()])
        if (step + 1) % 100 == 0:
            print(f"{step + 1}: heat {shown[0]:.3f} box {shown[1]:.3f}, {(step + 1) / (time.time() - began):.2f} steps/s", flush=True)
        if (step + 1) % 500 == 0 or step + 1 == options.steps:
            torch.save(mean.state_dict(), options.out.with_suffix(".pt"))
            if signs:
                ask(mean, signs, empty, options.out.with_suffix(".asked.onnx"))
    export(mean, options.out)


if __name__ == "__main__":
    main()
