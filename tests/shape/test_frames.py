# SPDX-License-Identifier: LGPL-2.1-or-later
import types
import unittest

import known_curves
import numpy as np
from known_curves import changed, rod, sag

from freecad_cable.errors import DocumentError
from freecad_cable.geometry import rotation
from freecad_cable.shape.frames import frames


class TestFrames(unittest.TestCase):
    def test_derivatives_are_those_of_the_frame(self):
        fine, coarse = sag(400), sag(50)
        (run,) = frames(coarse)
        (reference,) = frames(fine)
        h = reference.parameter[1]
        axes = rotation.matrix(fine.quaternion)
        for k in range(3):
            value, first, second = (x[1:-1] for x in run.axis(k))
            at = slice(8, -8, 8)
            np.testing.assert_allclose(value, axes[at, :, k], atol=1e-9)
            # Central differences over h ≈ 1.8 mm of a frame that turns by up to 0.012/mm: h² 0.012³/6 …
            difference = (axes[9:-7:8, :, k] - axes[7:-9:8, :, k]) / (2 * h)
            np.testing.assert_allclose(first, difference, atol=1e-6)
            # … and ω' is itself a difference over 14.6 mm, of a curvature with κ''' ≈ 6e-3 (2π/730)³.
            difference = (axes[9:-7:8, :, k] - 2 * axes[at, :, k] + axes[7:-9:8, :, k]) / h**2
            np.testing.assert_allclose(second, difference, atol=2e-7)

    def test_parameter_is_the_length_of_a_stretched_rod(self):
        nodes = sag(100)
        for elongation in (1.0, 1.05):
            stretched = changed(nodes, position=nodes.position * elongation)
            (run,) = frames(stretched)
            # Pieces turn by θ < 0.07 rad: the rule is off by θ⁶/100800, and by θ h² δ/120 from the error
            # δ = h² κ'''/6 of κ', with h = 7.3 mm and κ''' = 6 (2π/0.73)³: both are below 10⁻⁸.
            length = nodes.arc_length * 1e3 * elongation
            np.testing.assert_allclose(run.parameter, length, rtol=1e-8)
            _, bend, _ = run.axis(2)
            curvature = np.linalg.norm(nodes.curvature[:, :2], axis=1) / 1e3
            np.testing.assert_allclose(
                np.linalg.norm(bend, axis=1), curvature / elongation, rtol=1e-6
            )

    def test_untwisted_frames_do_not_turn_about_the_tangent(self):
        nodes = sag(200)
        (run,) = frames(nodes)
        untwisted = run.untwisted()
        np.testing.assert_allclose(untwisted.axes[0], run.axes[0], atol=1e-14)
        np.testing.assert_allclose(untwisted.tangent, run.tangent, atol=1e-14)
        identity = np.einsum("nji,njk->nik", untwisted.axes, untwisted.axes)
        np.testing.assert_allclose(identity, np.broadcast_to(np.eye(3), identity.shape), atol=1e-13)
        # Between two nodes the least turn differs from transport along the cable by the area between the
        # tangents on the sphere, about κ² ρ h³/12 with κ = 7/m, ρ = 10/m, h = 3.65 mm; 200 times.
        turn = np.einsum("nji,njk->nik", untwisted.axes[:-1], untwisted.axes[1:])
        swing = np.arctan2(turn[:, 1, 0] - turn[:, 0, 1], turn[:, 0, 0] + turn[:, 1, 1])
        self.assertLess(np.abs(np.sum(swing)), 1e-3)
        self.assertGreater(abs(run.twist[-1]), 0.5)

    def test_curvature_from_the_frames_when_it_is_not_given(self):
        for given, known in ((sag(50), 3e-4), (sag(100), 0.75e-4)):
            (run,) = frames(changed(given, curvature=None))
            (exact,) = frames(given)
            # Of order 2: a quarter with twice the nodes.
            self.assertLess(np.abs(run.spin - exact.spin).max(), known)

    def test_runs_end_where_curvature_jumps(self):
        for name, nodes in known_curves.with_jumps().items():
            with self.subTest(name):
                runs = frames(nodes)
                jumps = nodes.arc_length[list(nodes.support_nodes)] * 1e3
                np.testing.assert_allclose([run.parameter[0] for run in runs[1:]], jumps, rtol=1e-6)
                for run in runs:
                    bend = np.linalg.norm(run.axis(2)[1], axis=1)
                    # Constant in each run, and at the joint that before it in one and that after it in the other.
                    np.testing.assert_allclose(bend, bend.mean(), atol=1e-6)

    def test_smooth_cables_are_one_run(self):
        for name, nodes in known_curves.rod_like().items():
            with self.subTest(name):
                self.assertEqual(len(frames(nodes)), 1)

    def test_a_boundary_layer_is_no_jump(self):
        # Clamped and taut: curvature falls to a half from node to node, and by 0.15 rad at the first.
        layer = (0.4, lambda s: np.array([0.0, 40 * 2 ** (-s / 0.01), 0.0]))
        self.assertEqual(len(frames(rod([layer], 40))), 1)

    def test_nodes_that_coincide_count_once(self):
        nodes = sag()
        twice = np.sort(np.concatenate([np.arange(51), [0, 7, 7, 30, 50]]))
        crowded = known_curves.picked(nodes, twice)
        crowded.arc_length[10] += 1e-12
        (run,) = frames(crowded)
        (plain,) = frames(nodes)
        self.assertEqual(len(run.parameter), 51)
        np.testing.assert_allclose(run.parameter, plain.parameter, rtol=1e-10)

    def test_anything_with_the_fields_of_a_solution(self):
        nodes = sag()
        solution = types.SimpleNamespace(**vars(nodes), force=None, message="")
        np.testing.assert_array_equal(frames(solution)[0].spin, frames(nodes)[0].spin)


class TestWrongNodes(unittest.TestCase):
    def refused(self, sentence, **fields):
        with self.assertRaisesRegex(DocumentError, sentence):
            frames(changed(sag(), **fields))

    def spoiled(self, name, index, value):
        array = getattr(sag(), name).copy()
        array[index] = value
        return {name: array}

    def test_each_is_a_sentence(self):
        nodes = sag()
        self.refused("no solved shape", position=None)
        self.refused("no solved shape", arc_length=None)
        self.refused("1 node.*at least 2", arc_length=np.zeros(1))
        self.refused("positions.*shape .50, 3.*must be .51, 3", position=nodes.position[1:])
        self.refused(
            "quaternions of node 4 are not finite", **self.spoiled("quaternion", 4, np.nan)
        )
        self.refused("curvatures of node 9", **self.spoiled("curvature", (9, 1), np.inf))
        self.refused(
            "quaternion of node 3 has the length 2", **self.spoiled("quaternion", 3, [2, 0, 0, 0])
        )
        self.refused("arc length of node 6 is less", **self.spoiled("arc_length", 6, 0.0))
        self.refused("0 mm long", arc_length=np.zeros(51))
        self.refused("do not belong together", **self.spoiled("position", 20, nodes.position[19]))
        self.refused("do not belong together", position=nodes.position * 1000)

    def test_nodes_too_far_apart(self):
        with self.assertRaisesRegex(DocumentError, "turns by 2.36 rad between its nodes 0 and 1"):
            frames(rod([known_curves.arc(0.05, 3 * np.pi / 4)], 1))
