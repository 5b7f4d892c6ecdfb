#!/usr/bin/env python3
"""Sends SIGINT, SIGTERM or SIGHUP to every command at random times and prints a table: how each ended, what it left, how
long that took.

    xvfb-run -a tests/stress/signals.py build/release/bin/boxprobe --count 1000

Each command runs once undisturbed first: the signals are spread over the time that it takes, of which --longest seconds at most.
Three times are measured from the signal to the end: by the clock; without the longest time that one of its threads was ready to run and
had to wait for a processor (other programs have it then); and the processor time of all threads. Exit status 1 if a command ended with another status
than 1 or 128 + the signal's number, which a crash and a signal that was lost have, if it left a temporary file or a file that is cut, or
if the second of the times is longer than --most.
"""
import argparse
import collections
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from signal_commands import commands, prepare

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
TICKS = os.sysconf("SC_CLK_TCK")


def start(program, arguments, folder):
    environment = dict(os.environ, TMPDIR=folder, XDG_CONFIG_HOME=folder + "/config", XDG_DATA_HOME=folder + "/share",
                       GALLIVM_PERF="nopt")

    def heed():
        # A shell that runs this in the background has told it to ignore SIGINT, and a program inherits that.
        for each in SIGNALS:
            signal.signal(each, signal.SIG_DFL)

    with open(folder + "/said", "wb") as said:
        return subprocess.Popen([program] + arguments, stdout=subprocess.DEVNULL, stderr=said, env=environment, preexec_fn=heed)


def wait_for_end(process, seconds, looking=lambda: None):
    """Until it has ended, killed after so long; it stays to be asked about. `looking` is called meanwhile. False: it was killed."""
    until = time.monotonic() + seconds
    while not ended(process):
        if time.monotonic() > until:
            os.kill(process.pid, signal.SIGKILL)
            os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
            return False
        looking()
        time.sleep(0.005)
    return True


def ended(process):
    return os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is not None


def state_and_cpu(process):
    with open(f"/proc/{process.pid}/stat") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return fields[0], (int(fields[11]) + int(fields[12])) / TICKS


def queues(process):
    """By thread: seconds that it has been ready to run and had to wait for a processor."""
    waited = {}
    for thread in os.listdir(f"/proc/{process.pid}/task"):
        try:
            with open(f"/proc/{process.pid}/task/{thread}/schedstat") as stat:
                waited[thread] = 1e-9 * int(stat.read().split()[1])
        except (OSError, IndexError):
            pass  # it is gone
    return waited


def stand_still(process):
    """Stops the process; False if it has ended instead. Standing still it cannot end by itself just before the signal, which would look
    like one that was lost."""
    os.kill(process.pid, signal.SIGSTOP)
    while not ended(process):
        if state_and_cpu(process)[0] == "T":
            return True
        time.sleep(0.001)
    return False


def reap(process):
    """Exit status, as a shell has it, and seconds of processor time."""
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode if process.returncode >= 0 else 128 - process.returncode, used.ru_utime + used.ru_stime


def files_below(folder):
    return [os.path.join(path, name) for path, _, names in os.walk(folder) for name in names]


def temporary(path):
    return os.path.basename(path).startswith((".", "boxprobe-"))


def cut(path):
    """Is it a file of a kind that tells its end, and has none?"""
    with open(path, "rb") as file:
        data = file.read()
    if path.endswith(".png"):
        return data[-8:-4] != b"IEND"
    if path.endswith(".html"):
        return not data.rstrip().endswith(b"</html>")
    if path.endswith((".json", ".json.partial")):
        try:
            json.loads(data)
        except ValueError:
            return True
    return not data


class Row:
    def __init__(self, seconds):
        self.seconds, self.sent, self.left, self.statuses = seconds, 0, 0, collections.Counter()
        self.waits, self.unhindered, self.cpu = [], [], []

    def text(self, name):
        def middle_and_most(values):
            values = sorted(values) or [0.0]
            return f"{values[len(values) // 2]:.2f}, {values[-1]:.2f}"

        statuses = ", ".join(f"{key}: {count}" for key, count in sorted(self.statuses.items(), key=str))
        return (f"| {name} | {self.seconds:.1f} | {self.sent} | {statuses} | {self.left} | {middle_and_most(self.waits)} | "
                f"{middle_and_most(self.unhindered)} | {middle_and_most(self.cpu)} |")


def interrupt(process, number, row, options):
    """Sends the signal and notes what follows. Says what is wrong with that, if anything; None: it had ended before."""
    # Signalled while it stands still, which it is told to end only then.
    if not stand_still(process):
        reap(process)
        row.statuses["before"] += 1
        return None
    cpu, before = state_and_cpu(process)[1], queues(process)
    hindered = 0.0

    def look():
        nonlocal hindered
        now = queues(process)
        hindered = max([hindered] + [now[thread] - before.get(thread, 0.0) for thread in now])

    begun = time.monotonic()
    os.kill(process.pid, number)
    os.kill(process.pid, signal.SIGCONT)
    in_time = wait_for_end(process, 60, look)
    wait = time.monotonic() - begun
    look()
    unhindered = max(wait - hindered, 0.0)
    status, used = reap(process)
    row.sent += 1
    row.statuses[status] += 1
    row.waits.append(wait)
    row.unhindered.append(unhindered)
    row.cpu.append(max(used - cpu, 0.0))
    good = in_time and status in (1, 128 + number) and unhindered <= options.most
    return [] if good else [f"status {status}, {wait:.1f} s, {unhindered:.1f} s without waiting for a processor"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=144, help="signals to be sent")
    parser.add_argument("--most", type=float, default=2.0, help="seconds from the signal to the end")
    parser.add_argument("--longest", type=float, default=10.0, help="seconds from the start to the signal")
    parser.add_argument("--only", default="", help="commands whose names have this")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    data = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data")
    generator = random.Random(options.seed)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    given = tempfile.mkdtemp(prefix="signals-given-")
    rows, bad, sent = {}, [], 0
    try:
        prepare(options.program, data, given)
        names = [name for name in commands(data, given, given) if options.only in name]
        turn = 0
        while sent < options.count and turn < 4 * options.count + len(names):
            name = names[turn % len(names)]
            folder = tempfile.mkdtemp(prefix="signals-")
            try:
                process = start(options.program, commands(data, given, folder)[name], folder)
                begun = time.monotonic()
                if turn < len(names):  # undisturbed
                    wait_for_end(process, options.longest)
                    reap(process)
                    rows[name] = Row(time.monotonic() - begun)
                    continue
                row = rows[name]
                time.sleep(generator.uniform(0.0, row.seconds))
                number = generator.choice(SIGNALS)
                before = row.sent
                faults = interrupt(process, number, row, options)
                sent += row.sent - before
                left = [path for path in files_below(folder) if temporary(path)]
                broken = [path for path in files_below(folder) if path != folder + "/said" and cut(path)]
                row.left += len(left)
                faults = (faults or []) + [f"left {path}" for path in left] + [f"cut: {path}" for path in broken]
                if faults:
                    with open(folder + "/said", errors="replace") as said:
                        bad.append(f"{name}: signal {number}: {'; '.join(faults)}: {said.read()[-300:]!r}")
            finally:
                turn += 1
                shutil.rmtree(folder, ignore_errors=True)
    finally:
        shutil.rmtree(given, ignore_errors=True)
    print("Times are the median and the longest, in seconds.\n")
    print("| command | runs for, s | signals | statuses | temporary files left | wait | without waiting for a processor | processor time |")
    print("|---|---|---|---|---|---|---|---|")
    for name, row in rows.items():
        print(row.text(name))
    print(f"\n{sent} signals, longest {max((max(row.waits, default=0.0) for row in rows.values()), default=0.0):.2f} s")
    for line in bad:
        print(line, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
