# SPDX-License-Identifier: LGPL-2.1-or-later
"""One scalar function, evaluated over many elements at once.

CasADi's ``map`` runs through the instructions of a function once per element, and what it spends between two numbers
is more than what the numbers cost. Here each instruction is done once, on a column with one number per element: a loop
that the processor's vector units run. Columns are as long as a power of two, so that meshes share functions.
"""

from functools import lru_cache

import casadi as ca

FEWEST, MOST = 16, 128
"""Lanes. Longer columns leave the nearest cache; shorter ones save nothing."""


def across(function: ca.Function, *arguments: ca.MX) -> list[ca.MX]:
    """Outputs (n, c) of an SX function of dense columns, a row per element, from its arguments (n, c), or (1, c) where
    all elements have the same."""
    count = max(argument.shape[0] for argument in arguments)
    lanes = min(max(FEWEST, 1 << (count - 1).bit_length()), MOST)
    common = tuple(argument.shape[0] < count for argument in arguments)
    columns, parts = _columns(function, lanes, common), []
    for begin in range(0, count, lanes):
        wanted = min(lanes, count - begin)
        # Empty lanes repeat the last element: no numbers that could overflow.
        rows = [*range(begin, begin + wanted), *[begin + wanted - 1] * (lanes - wanted)]
        given = [a if c else a[rows, :] for a, c in zip(arguments, common, strict=True)]
        parts.append([output[:wanted, :] for output in columns.call(given)])
    return [ca.vertcat(*each) for each in zip(*parts, strict=True)]


@lru_cache(maxsize=256)
def _columns(function, lanes, common) -> ca.Function:
    """The instructions of a function on columns (lanes,) in place of numbers."""
    inputs = [
        ca.MX.sym(function.name_in(i), 1 if c else lanes, function.numel_in(i))
        for i, c in enumerate(common)
    ]
    given = [ca.horzsplit(each) for each in inputs]
    outputs = [[None] * function.numel_out(i) for i in range(function.n_out())]
    work = [None] * function.sz_w()
    for k in range(function.n_instructions()):
        operation = function.instruction_id(k)
        sources, targets = function.instruction_input(k), function.instruction_output(k)
        if operation == ca.OP_CONST:
            work[targets[0]] = ca.MX(function.instruction_constant(k))
        elif operation == ca.OP_INPUT:
            work[targets[0]] = given[sources[0]][sources[1]]
        elif operation == ca.OP_OUTPUT:
            value = work[sources[0]]
            if value.shape[0] < lanes:
                value = ca.repmat(value, lanes, 1)
            outputs[targets[0]][targets[1]] = value
        elif len(sources) == 1:
            work[targets[0]] = ca.MX.unary(operation, work[sources[0]])
        else:
            work[targets[0]] = ca.MX.binary(operation, *(work[source] for source in sources))
    return ca.Function(function.name(), inputs, [ca.horzcat(*each) for each in outputs])
