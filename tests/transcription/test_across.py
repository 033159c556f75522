# SPDX-License-Identifier: LGPL-2.1-or-later
"""A function across columns against the same function called element by element."""

import casadi as ca
import numpy as np
import pytest

from freecad_cable.transcription.across import across
from freecad_cable.transcription.element_functions import element


def values(function, arguments):
    """Outputs (n, c) from arguments (n, c) or (1, c), by ``across``."""
    symbols = [ca.MX.sym("a", *argument.shape) for argument in arguments]
    evaluate = ca.Function("evaluate", symbols, across(function, *symbols))
    return [output.full() for output in evaluate.call(arguments)]


# One element, fewer than the shortest column, one column, its end, more than the longest column.
@pytest.mark.parametrize("count", [1, 12, 16, 50, 128, 129, 300])
def test_elements(count):
    block = element("magnus", (0, 1, 2, 5), True).block
    random = np.random.default_rng(count)
    shapes = [(count, block.numel_in(i)) for i in range(block.n_in())]
    shapes[2] = (1, block.numel_in(2))
    arguments = [random.normal(size=shape) / 3 for shape in shapes]
    (found,) = values(block, arguments)
    for k in range(count):
        one = block(*(argument[min(k, len(argument) - 1)] for argument in arguments))
        # The same operations; the processor may fuse a product and a sum in one of the two.
        np.testing.assert_allclose(found[k], one.full().ravel(), rtol=1e-12, atol=1e-13)


def test_outputs_that_are_constant_or_common():
    a, b = ca.SX.sym("a", 2), ca.SX.sym("b")
    function = ca.Function("function", [a, b], [ca.vertcat(3, b), ca.vertcat(a[1], 0)])
    given = np.arange(40.0).reshape(20, 2)
    constant, own = values(function, [given, np.array([[7.0]])])
    assert (constant == [3, 7]).all()
    assert (own[:, 0] == given[:, 1]).all()
    assert (own[:, 1] == 0).all()
