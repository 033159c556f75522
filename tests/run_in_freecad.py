# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the tests of one room inside FreeCAD; ``./run test`` names the room in CABLE_TEST_ROOM.

FreeCAD has no pytest, returns 0 after an uncaught exception, and with a window sends what is
printed to its report view. So: unittest, an exit by hand, and the stream that Python started with.
"""

import os
import sys
import traceback
import unittest
import warnings


class Result(unittest.TextTestResult):
    """Counts what passed: a test with failed parts counts as one that ran, but did not pass."""

    passed = 0

    def addSuccess(self, test):
        super().addSuccess(test)
        self.passed += 1


def run(room: str) -> bool:
    """Whether every test in tests/``room`` passed; no test at all is a failure."""
    folder = os.path.join(os.getcwd(), "tests", room)
    suite = unittest.defaultTestLoader.discover(folder, top_level_dir=folder)
    runner = unittest.TextTestRunner(sys.__stdout__, resultclass=Result)
    # FreeCAD's own modules warn; only our own warnings are errors.
    runner.warnings = None
    warnings.filterwarnings("error", module="freecad_cable")
    outcome = runner.run(suite)
    failed = len(outcome.failures) + len(outcome.errors) + len(outcome.unexpectedSuccesses)
    skipped = len(outcome.skipped) + len(outcome.expectedFailures)
    print(f"{outcome.passed} passed, {failed} failed, {skipped} skipped", file=sys.__stdout__)
    return failed == 0 and outcome.passed > 0


success = False
try:
    success = run(os.environ["CABLE_TEST_ROOM"])
except Exception:  # noqa: BLE001 - becomes the exit code
    traceback.print_exc(file=sys.__stdout__)
finally:
    sys.__stdout__.flush()
    # Past FreeCAD: with a window, versions 1.x return 1 for every sys.exit.
    os._exit(0 if success else 1)
