#!/usr/bin/env python3
"""Sends SIGINT, SIGTERM or SIGHUP to every command at random times and prints a table: how each ended, what it left,
the longest wait. Exit status 1 if one ended with 0 after the signal, was ended by another signal (a crash), waited
longer than --most seconds, or left a temporary file.

    xvfb-run -a tests/stress/signals.py build/release/bin/boxprobe --count 1000
"""
import argparse
import collections
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def commands(data, out):
    room, building = f"{data}/scenes/room.boxprobe.json", f"{data}/scenes/building.boxprobe.json"
    small = ["--size", "160x90"]
    return {
        "info": ["info", building],
        "info --frame": ["info", building, "--frame"] + small,
        "render": ["render", room, "-o", f"{out}/a.png"] + small,
        "render .exr": ["render", building, "-o", f"{out}/a.exr"] + small,
        "render reference-box": ["render", room, "-o", f"{out}/b.exr", "--technique", "reference-box"] + small,
        "render reference-scene": ["render", room, "-o", f"{out}/c.png", "--technique", "reference-scene"] + small,
        "bake": ["bake", room, "-o", f"{out}/probes"],
        "explain": ["explain", building, "--pixel", "80,45"] + small,
        "bench": ["bench", room, "-o", f"{out}/bench", "--quick"],
        "stress": ["stress", "--count", "20000000", "-o", f"{out}/s.json"],
        "lessons -o": ["lessons", "floor-mirror", "-o", f"{out}/l.png"],
        "lessons --check": ["lessons", "three-distances", "--check"],
        "window": [room],
    }


def leftovers(folder):
    hidden = []
    for path, _, names in os.walk(folder):
        hidden += [os.path.join(path, name) for name in names if name.startswith((".", "boxprobe-"))]
    return hidden


def stand_still(process):
    """Stops the process; False if it has ended instead."""
    process.send_signal(signal.SIGSTOP)
    while process.poll() is None:
        with open(f"/proc/{process.pid}/stat") as stat:
            if stat.read().rsplit(")", 1)[1].split()[0] == "T":
                return True
        time.sleep(0.001)
    return False


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=130)
    parser.add_argument("--most", type=float, default=10.0, help="seconds from the signal to the end")
    parser.add_argument("--longest", type=float, default=6.0, help="seconds from the start to the signal")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    data = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data")
    generator = random.Random(options.seed)
    rows = collections.defaultdict(lambda: {"sent": 0, "statuses": collections.Counter(), "left": 0, "waits": []})
    bad = []
    for i in range(options.count):
        folder = tempfile.mkdtemp(prefix="boxprobe-signals-")
        try:
            table = commands(data, folder)
            name = list(table)[i % len(table)]
            number = generator.choice(SIGNALS)
            environment = dict(os.environ, TMPDIR=folder, GALLIVM_PERF="nopt")
            # A shell that runs this in the background has told it to ignore SIGINT, and a program inherits that.
            heed = lambda: [signal.signal(each, signal.SIG_DFL) for each in SIGNALS]
            process = subprocess.Popen([options.program] + table[name], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, env=environment, preexec_fn=heed)
            time.sleep(generator.uniform(0.0, options.longest) * generator.random())
            row = rows[name]
            if process.poll() is not None:
                process.communicate()
                row["statuses"]["before"] += 1
                continue
            # Standing still it cannot end by itself just before the signal, which would look like one that was lost.
            if not stand_still(process):
                process.communicate()
                row["statuses"]["before"] += 1
                continue
            begun = time.monotonic()
            process.send_signal(number)
            process.send_signal(signal.SIGCONT)
            try:
                errors = process.communicate(timeout=60)[1]
            except subprocess.TimeoutExpired:
                process.kill()
                errors = process.communicate()[1]
            wait = time.monotonic() - begun
            status = process.returncode if process.returncode >= 0 else 128 - process.returncode
            row["sent"] += 1
            row["statuses"][status] += 1
            row["waits"].append(wait)
            left = leftovers(folder)
            row["left"] += len(left)
            if status not in (1, 128 + number) or wait > options.most or left:
                bad.append(f"{name}: signal {number}: status {status}, {wait:.1f} s, left {left}: {errors[-300:]!r}")
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    print("| command | signals | statuses | temporary files left | median wait, s | longest, s |\n|---|---|---|---|---|---|")
    for name, row in rows.items():
        waits = sorted(row["waits"]) or [0.0]
        statuses = ", ".join(f"{key}: {count}" for key, count in sorted(row["statuses"].items(), key=str))
        print(f"| {name} | {row['sent']} | {statuses} | {row['left']} | {waits[len(waits) // 2]:.2f} | {waits[-1]:.2f} |")
    for line in bad:
        print(line, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
