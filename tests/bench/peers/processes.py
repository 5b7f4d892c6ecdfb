"""Programs under a display of their own, with the CPU time of all their threads and processes."""
import os
import shutil
import signal
import subprocess
import time

TICK = os.sysconf("SC_CLK_TCK")


def tree(root):
    """Process ids of `root` and all that came from it."""
    parents = {}
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                with open("/proc/%s/stat" % entry) as file:
                    parents[int(entry)] = int(file.read().rsplit(")", 1)[1].split()[1])
            except OSError:
                pass  # it has ended meanwhile
    found = {root}
    while True:
        more = {pid for pid, parent in parents.items() if parent in found} - found
        if not more:
            return found
        found |= more


def cpu_seconds(root):
    """User and system time of the tree, of children that have ended too."""
    total = 0
    for pid in tree(root):
        try:
            with open("/proc/%d/stat" % pid) as file:
                total += sum(map(int, file.read().rsplit(")", 1)[1].split()[11:15]))
        except OSError:
            pass
    return total / TICK


def resident_mib(root):
    """Memory of the tree; pages that its processes share count once, as shares."""
    total = 0
    for pid in tree(root):
        try:
            with open("/proc/%d/smaps_rollup" % pid) as file:
                total += sum(int(line.split()[1]) for line in file if line.startswith("Pss:"))
        except OSError:
            pass
    return total / 1024


def run(command, folder=None, timeout=600, environment=None):
    """Output, CPU seconds and largest resident MiB of a program that ends by itself."""
    log = os.path.join(folder or ".", "log.txt")
    with open(log, "w") as output:
        child = subprocess.Popen([str(word) for word in command], stdout=output, stderr=subprocess.STDOUT, cwd=folder, start_new_session=True,
                                 env=dict(os.environ, **(environment or {})))
        until = time.monotonic() + timeout
        pid = 0
        try:
            while not pid:
                pid, status, used = os.wait4(child.pid, os.WNOHANG)
                if time.monotonic() > until and not pid:
                    os.killpg(child.pid, signal.SIGKILL)
                time.sleep(0.02)
        finally:
            if not pid:
                os.killpg(child.pid, signal.SIGKILL)
    child.returncode = os.waitstatus_to_exitcode(status)
    with open(log, errors="replace") as file:
        text = file.read()
    if child.returncode != 0:
        raise RuntimeError("%s ended with %d: %s" % (command[0], child.returncode, text.strip()[-600:]))
    return text, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


class Display:
    """An X server for all runs, outside of what is measured; every peer draws in a process of its own (llvmpipe)."""

    def __enter__(self):
        if shutil.which("Xvfb") is None:
            raise SystemExit("peers: Xvfb is missing; apt-get install xvfb")
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1600x1000x24", "-nolisten", "tcp", "-noreset"],
                                       pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            os.environ["DISPLAY"] = ":" + pipe.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()
