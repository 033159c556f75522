# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where and with what a run was made."""

import os
import platform
import subprocess
from datetime import UTC, datetime
from pathlib import Path

import casadi
import numpy
import scipy

CHECKOUT = Path(__file__).resolve().parents[1]


def facts() -> dict[str, str]:
    """Facts of a run, taken before it."""
    versions = {module.__name__: module.__version__ for module in (numpy, scipy, casadi)}
    return {
        "commit": _commit(),
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "python": platform.python_version(),
        **versions,
        "cpu": f"{_processor()}, {os.cpu_count()} processors",
        "load": f"{os.getloadavg()[0]:.1f}",
    }


def _commit():
    def git(*words):
        return subprocess.run(
            ["git", *words], cwd=CHECKOUT, capture_output=True, text=True, check=True
        ).stdout.strip()

    try:
        # The rows of the last run differ from those committed; that alone is no change of the code.
        changed = git("status", "--porcelain", "--", "freecad_cable", "benchmarks")
        return git("rev-parse", "HEAD") + (", with uncommitted changes" if changed else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _processor():
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(
            line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")
        )
    except (OSError, StopIteration):
        return platform.processor() or "unknown"
