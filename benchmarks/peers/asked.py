# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each peer is asked: every problem cold and from the start that it likes best."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from benchmarks.cases import TABLE_1
from freecad_cable.problem import Scene

YOUNG = 10e6
"""[Pa], of Table 1; its shear modulus is twice that, and so GA = 2 EA"""
PAPER, CANTILEVER = "table 1, 0.73 m", "cantilever"
ALL = (*(case.name for case in TABLE_1), CANTILEVER)
SOLVE_BVP, SEED = "SciPy solve_bvp", "seed paper's formulation"
EXUDYN, OPENSEES, ELASTICA, MUJOCO = "Exudyn", "OpenSeesPy", "PyElastica", "MuJoCo cable"
STATIC, DYNAMIC = (EXUDYN, OPENSEES), (ELASTICA, MUJOCO)

MODULES = {
    SOLVE_BVP: ("solve_bvp", "scipy"),
    SEED: ("seed_paper", "casadi"),
    EXUDYN: ("exudyn_beam", "exudyn"),
    OPENSEES: ("opensees_beam", "openseespy"),
    ELASTICA: ("elastica_dynamics", "pyelastica"),
    MUJOCO: ("mujoco_dynamics", "mujoco"),
}
"""Peer: our module, and the package that it needs; the first two get by with what we need ourselves."""
STRETCHING, SHEARING = (EXUDYN, OPENSEES, ELASTICA), (EXUDYN, ELASTICA)


@dataclass(frozen=True)
class Asked:
    peer: str
    problem: str
    elements: int
    variant: str = ""
    start: str = "cold"
    steps: int = 1
    tolerance: float = 0.0

    @property
    def module(self) -> str:
        return MODULES[self.peer][0]

    @property
    def package(self) -> str:
        return MODULES[self.peer][1]

    def physics(self, scene: Scene) -> Scene:
        """With the stretch and shear that the peer has."""
        area, found = 3.141592653589793 * scene.rod.radius**2, {}
        if self.peer in STRETCHING:
            found["axial_stiffness"] = YOUNG * area
        if self.peer in SHEARING:
            found["shear_stiffness"] = 2 * YOUNG * area
        return replace(scene, rod=replace(scene.rod, **found))


GIVEN, OWN = "derivatives given", "own differences"
BOUNDARY_VALUE = (
    (GIVEN, "cold", 4, 1e-1),
    (GIVEN, "cold", 16, 1e-1),
    (GIVEN, "cold", 16, 1e-3),
    (GIVEN, "cold", 16, 1e-5),
    (OWN, "cold", 4, 1e-1),
    (OWN, "cold", 16, 1e-1),
    (OWN, "cold", 16, 1e-3),
    (GIVEN, "ours", 16, 1e-1),
    (OWN, "ours", 16, 1e-1),
    (GIVEN, "answer", 16, 1e-3),
)
"""Variants, starts, elements (a fourth of those of the start) and tolerances of ``solve_bvp``."""


def asked() -> Iterator[Asked]:
    for problem in ALL:
        for variant, start, elements, tolerance in BOUNDARY_VALUE:
            yield Asked(SOLVE_BVP, problem, elements, variant, start, tolerance=tolerance)
        for elements in (25, 50, 100, 200, 400):
            yield Asked(SEED, problem, elements, "two points")
    for problem in (PAPER, CANTILEVER):
        for elements in (50, 200):
            yield Asked(SEED, problem, elements, "three points")
    for elements in (10, 20, 40, 80):
        yield Asked(EXUDYN, PAPER, elements, "over an arc", steps=6)
        yield Asked(EXUDYN, CANTILEVER, elements, "loaded", steps=2)
        yield Asked(EXUDYN, PAPER, elements, "from the start", start="answer")
        # With longer steps the finer meshes fail.
        steps = 80 if elements < 80 else 320
        yield Asked(OPENSEES, PAPER, elements, "over an arc", steps=steps)
        yield Asked(OPENSEES, CANTILEVER, elements, "loaded", steps=4)
    yield Asked(EXUDYN, PAPER, 20, "from the start")
    yield Asked(EXUDYN, PAPER, 20, "straight", steps=40)
    yield Asked(OPENSEES, PAPER, 20, "straight", steps=80)
    for problem in (PAPER, CANTILEVER):
        for elements in (20, 40, 80):
            yield Asked(ELASTICA, problem, elements, "centred")
        for elements in (10, 20, 40):
            yield Asked(MUJOCO, problem, elements, "centred")
    # As fine as they get: with 320 PyElastica diverges, and MuJoCo does not rest with 34 in 30 s of its own time.
    yield Asked(ELASTICA, PAPER, 160, "centred")
    yield Asked(MUJOCO, PAPER, 28, "centred")
    for peer, elements in ((ELASTICA, 40), (MUJOCO, 20)):
        yield Asked(peer, PAPER, elements, "centred", start="answer")
        yield Asked(peer, PAPER, elements, "as documented")
