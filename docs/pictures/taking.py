# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts that take pictures of FreeCAD's window share."""

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
