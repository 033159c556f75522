# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets the tests of this room find their scenes."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
