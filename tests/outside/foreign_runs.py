"""Runs a program and says what it used. For foreign_models.py."""
import json
import os
import resource
import subprocess


def run(command, timeout=300):
    """Exit status, output, CPU seconds and peak MiB of a program and its children."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:  # a process of its own for each, whose children's use is this program's alone
        os.close(read)
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=timeout, errors="replace")
            status, text = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired:
            status, text = 124, "more than %d s" % timeout
        except OSError as error:
            status, text = 127, str(error)
        use = resource.getrusage(resource.RUSAGE_CHILDREN)
        answer = json.dumps([status, text, use.ru_utime + use.ru_stime, use.ru_maxrss / 1024])
        with os.fdopen(write, "w") as pipe:
            pipe.write(answer)
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        answer = pipe.read()
    os.waitpid(child, 0)
    return json.loads(answer)


def median(values):
    values = sorted(values)
    return values[len(values) // 2] if values else 0.0
