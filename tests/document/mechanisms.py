# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arm that a joint holds on a base: the assemblies of FreeCAD 1.0 and later; before, what their solver does."""

import FreeCAD
from FreeCAD import Placement, Rotation, Vector
from scenes import TOP

VERSION = tuple(int(number) for number in FreeCAD.Version()[:2])
ASSEMBLIES = VERSION >= (1, 0)

TIP = Placement(Vector(0, 0, 10), Rotation())
"""The end of a pin where a cable leaves, in the pin."""


class Mechanism:
    """Base and arm are pins, or links to some; the assembly takes them in. ``place`` says where the arm's tip is to be,
    seen from that of the base; the next recompute, or ``solve``, moves it there."""

    def __init__(self, doc, base, arm, name="Assembly"):
        self.base, self.arm = base, arm
        made = _assembly if ASSEMBLIES else _stand_in
        self.assembly, self.joint = made(doc, base, arm, name)

    def place(self, placement):
        if ASSEMBLIES:
            self.joint.Offset1 = placement
        else:
            self.joint.Target = self.base.Placement * TIP * placement * TIP.inverse()

    def comes_after(self, *objects):
        """An assembly is recomputed after all that it contains; the stand-in needs to be told."""
        if not ASSEMBLIES:
            self.joint.Held = objects

    def solve(self):
        """Move the arm where it belongs without a recompute, as a drag does."""
        if ASSEMBLIES:
            self.assembly.solve()
        else:
            self.joint.Proxy.execute(self.joint)


def new_assembly(doc, name="Assembly"):
    """An assembly without parts, or the container that stands for it."""
    if not ASSEMBLIES:
        return doc.addObject("App::Part", name)
    assembly = doc.addObject("Assembly::AssemblyObject", name)
    # As the command does; later versions ask for it.
    assembly.Type = "Assembly"
    assembly.newObject("Assembly::JointGroup", "Joints")
    return assembly


def add_unit(mechanism, assembly, name):
    """A sub-assembly in ``assembly``: a link to the mechanism, in a document of its own. Returns it and the ways down
    from it to base and arm; an assembly's link has links of its own to the parts."""
    if not ASSEMBLIES:
        unit = assembly.newObject("App::Link", name)
        unit.LinkedObject = mechanism.assembly
        return unit, [f"{part.Name}." for part in (mechanism.base, mechanism.arm)]
    unit = assembly.newObject("Assembly::AssemblyLink", name)
    unit.LinkedObject = mechanism.assembly
    assembly.Document.recompute()
    links = {obj.LinkedObject: obj for obj in unit.Group if obj.TypeId == "App::Link"}
    return unit, [f"{links[part].Name}." for part in (mechanism.base, mechanism.arm)]


def _assembly(doc, base, arm, name):
    import JointObject

    assembly = new_assembly(doc, name)
    (joints,) = (obj for obj in assembly.Group if obj.TypeId == "Assembly::JointGroup")
    assembly.addObjects([base, arm])
    JointObject.GroundedJoint(joints.newObject("App::FeaturePython", "Grounded"), base)
    joint = joints.newObject("App::FeaturePython", "Joint")
    JointObject.Joint(joint, JointObject.JointTypes.index("Fixed"))
    joint.Proxy.setJointConnectors(joint, [_connector(assembly, part) for part in (base, arm)])
    return assembly, joint


def _connector(assembly, part):
    if VERSION >= (1, 1):
        return [part, [TOP, TOP]]
    return [assembly, [f"{part.Name}.{TOP}"] * 2]


def _stand_in(doc, base, arm, name):
    assembly = new_assembly(doc, name)
    assembly.addObjects([base, arm])
    joint = assembly.newObject("App::FeaturePython", "Joint")
    Solver(joint, arm)
    return assembly, joint


class Solver:
    """As an assembly's in its recompute: it places a part and takes the touch back."""

    def __init__(self, obj, part):
        obj.addProperty("App::PropertyLink", "Part")
        obj.addProperty("App::PropertyLinkList", "Held")
        obj.addProperty("App::PropertyPlacement", "Target")
        obj.Part, obj.Target, obj.Proxy = part, part.Placement, self

    def execute(self, obj):
        obj.Part.Placement = obj.Target
        obj.Part.purgeTouched()

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads
