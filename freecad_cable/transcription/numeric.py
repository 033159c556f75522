# SPDX-License-Identifier: LGPL-2.1-or-later
"""CasADi's functions on NumPy's arrays, without the conversion that CasADi does on a call.

Of a function whose values take microseconds, that takes most of a millisecond for some thousand numbers.
"""

import casadi as ca
import numpy as np


class Numeric:
    """A function: arrays in, list of arrays out; of matrices (r, c), of columns (r,), of sparse ones the nonzeros. What
    is not given has CasADi's default. Not for two threads at once."""

    def __init__(self, function: ca.Function):
        self._buffer, self._evaluate = function.buffer()
        self._names = function.name_in()
        self._inputs, self._outputs = [], []
        for i in range(function.n_in()):
            flat = np.full(function.nnz_in(i), function.default_in(i))
            self._buffer.set_arg(i, memoryview(flat))
            self._inputs.append(_shaped(flat, function.sparsity_in(i)))
        for i in range(function.n_out()):
            flat = np.zeros(function.nnz_out(i))
            self._buffer.set_res(i, memoryview(flat))
            self._outputs.append(_shaped(flat, function.sparsity_out(i)))

    def __call__(self, *arguments, **named) -> list[np.ndarray]:
        for own, given in zip(self._inputs, arguments, strict=False):
            own[...] = given
        for name, given in named.items():
            self._inputs[self._names.index(name)][...] = given
        self._evaluate()
        return [output.copy() for output in self._outputs]

    def stats(self) -> dict:
        """Of the last evaluation, if the function is a solver."""
        return self._buffer.stats()


def _shaped(flat, sparsity):
    """The same numbers as an array of the shape that they have."""
    if sparsity.is_dense() and sparsity.size2() != 1:
        return flat.reshape(sparsity.shape, order="F")
    return flat
