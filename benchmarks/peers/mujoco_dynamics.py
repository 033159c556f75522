# SPDX-License-Identifier: LGPL-2.1-or-later
"""MuJoCo's cable plug-in: dynamics of a chain of rigid bodies on ball joints, without stretch, damped until it rests.

The far clamp can only be a weld to the world, which is as stiff as MuJoCo's constraints are.
"""

import mujoco
import numpy as np

from benchmarks.peers.half_elements import Chain
from benchmarks.peers.task import Found, Task
from freecad_cable.geometry import rotation

BODY_AXES = np.array([0.5, -0.5, -0.5, -0.5])
"""Of a body in the material frame: x is d3, y is d1, z is d2."""
STEP = 2e-4
"""[s]; with 1e-3 the weld was seen to jitter"""
SOFTNESS = 0.02
"""[s] time constant of the weld; from a start whose end is not quite in place, 4e-4 throws the chain about"""
DAMPING = 0.1
"""[s] damping over stiffness of a joint: of what was tried it rests soonest"""
LOOK_EVERY = 0.1
"""[s] of the cable's time"""
AT_REST = 1e-6
"""Movement between two looks, relative to the length, below which it rests: a hundredth of the errors reached"""
LONGEST = 30.0
"""[s] of the cable's time"""

MODEL = """
<mujoco>
  <extension><plugin plugin="mujoco.elasticity.cable"/></extension>
  <option timestep="{step}" integrator="implicitfast" gravity="{gravity}" tolerance="1e-12"/>
  <worldbody>
    <body pos="{start}" quat="{first}">
      <composite type="cable" prefix="" curve="s" count="{nodes} 1 1" size="{span}" initial="none">
        <plugin plugin="mujoco.elasticity.cable">
          <config key="twist" value="{twist}"/>
          <config key="bend" value="{bend}"/>
          <config key="vmax" value="0"/>
        </plugin>
        <joint kind="main" damping="{damping}"/>
        <geom type="capsule" size="{radius}" mass="{mass}" contype="0" conaffinity="0"/>
      </composite>
    </body>
    {target}
  </worldbody>
  {weld}
</mujoco>
"""
TARGET = '<body name="target" pos="{place}" quat="{turn}"/>'
WELD = """
<equality>
  <weld body1="B_last" body2="target" relpose="0 0 0 1 0 0 0" solref="{softness} 1"
        solimp="0.9999 0.9999 0.001"/>
</equality>
"""


def solve(task: Task) -> Found:
    chain = Chain.of(task)
    _, quaternion = task.start_at(chain.centres)
    quaternion[0] = task.start_quaternion
    frames = rotation.multiply(quaternion, BODY_AXES)
    model = mujoco.MjModel.from_xml_string(_model(task, chain, frames))
    data = mujoco.MjData(model)
    turns = rotation.multiply(rotation.conjugate(frames[:-1]), frames[1:])
    data.qpos[:] = turns.ravel()
    mujoco.mj_kinematics(model, data)
    while data.time < LONGEST:
        before = _nodes(model, data)
        mujoco.mj_step(model, data, round(LOOK_EVERY / STEP))
        moved = np.abs(_nodes(model, data) - before).max()
        if not moved < task.length or data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:
            raise ArithmeticError(f"its motion diverged after {data.time:.3g} s of its time")
        if moved < AT_REST * task.length:
            break
    else:
        raise ArithmeticError(f"it does not rest after {LONGEST:g} s of its time")
    inside = chain.inside
    remark = f"{data.time:.1f} s of its time"
    return Found(chain.nodes[inside], _nodes(model, data)[inside], model.nv, remark=remark)


def _nodes(model, data):
    """(elements+1, 3) first ends of all bodies, and the last end of the last."""
    last = model.body("B_last").id
    bodies = slice(model.body("B_first").id, last + 1)
    return np.vstack([data.xpos[bodies], data.site("S_last").xpos])


def _model(task, chain, frames):
    step = chain.nodes[1] - chain.nodes[0]
    fourth = np.pi * task.radius**4
    given = {"target": "", "weld": ""}
    if task.end_position is not None:
        out = (0.5 if task.variant == "centred" else 1.0) * step
        place = task.end_position - out * rotation.tangent(task.end_quaternion)
        turn = rotation.multiply(task.end_quaternion, BODY_AXES)
        given["target"] = TARGET.format(place=_words(place), turn=_words(turn))
        given["weld"] = WELD.format(softness=SOFTNESS)
    return MODEL.format(
        step=STEP,
        gravity=_words(task.gravity),
        start=_words(
            task.start_position + chain.nodes[0] * rotation.tangent(task.start_quaternion)
        ),
        first=_words(frames[0]),
        nodes=len(chain.nodes),
        span=chain.nodes[-1] - chain.nodes[0],
        twist=task.torsion / (fourth / 2),
        bend=task.bending / (fourth / 4),
        damping=DAMPING * task.bending / step,
        radius=task.radius,
        mass=task.mass * step,
        **given,
    )


def _words(numbers):
    return " ".join(map(repr, map(float, numbers)))
