# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Runs a command and measures it alone. A process's peak memory begins with that of the process it
was forked from, so the command is started from this small program, not from the tests' own."""

import json
import os
import resource
import subprocess
import sys
import time


def measured(command, seconds=600):
    """Dict of code, err, wall and cpu (seconds) and peak_bytes of a command run to its end, or to the
    end of its time."""
    timed = ["timeout", "--kill-after=5", str(seconds), *map(str, command)]
    launcher = [sys.executable, "-S", "-E", __file__, *timed]
    done = subprocess.run(launcher, capture_output=True, text=True, check=False)
    return {**json.loads(done.stdout), "err": done.stderr}


def main():
    started = time.monotonic()
    child = subprocess.Popen(sys.argv[1:], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    _, status, _ = os.wait4(child.pid, 0)
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)  # of the command, below `timeout`
    print(json.dumps({
        "code": os.waitstatus_to_exitcode(status),
        "wall": time.monotonic() - started,
        "cpu": usage.ru_utime + usage.ru_stime,
        "peak_bytes": usage.ru_maxrss * 1024,
    }))


if __name__ == "__main__":
    main()
