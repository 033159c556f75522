# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts that take pictures of FreeCAD's window share, and that which measures it."""

import os
import sys
import time
import traceback

import FreeCADGui
from PySide import QtCore


def wait(seconds=2):
    """Let the window draw itself."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        FreeCADGui.updateGui()


def rest():
    """Until nothing moves and nothing is solved, and the window has drawn it."""
    from freecad_cable.gui.live import live
    from freecad_cable.gui.worker import worker

    wait(0.5)
    while live.is_moving() or worker.jobs():
        FreeCADGui.updateGui()
    wait()


def take(picture):
    """Call ``picture`` when the window is up, and end the program."""

    def run():
        status = 0
        try:
            picture()
        except Exception:  # noqa: BLE001 - becomes the exit code
            traceback.print_exc(file=sys.__stdout__)
            status = 1
        sys.__stdout__.flush()
        os._exit(status)

    QtCore.QTimer.singleShot(2000, run)
