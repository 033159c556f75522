# SPDX-License-Identifier: LGPL-2.1-or-later
"""Neighbours along a curve that have something in common."""

import numpy as np


def runs(there):
    """(first, one beyond the last) of each run of true values (n,)."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], there.astype(int), [0]])))
    return zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
