# SPDX-License-Identifier: LGPL-2.1-or-later
"""OK and Cancel of FreeCAD's task panel. Apart from ``window``, for the guide's steps are also taken without one."""

import FreeCADGui
from PySide import QtGui


def buttons():
    """The box of OK and Cancel, in a list; FreeCAD 1.1 shows it a while after it has opened the panel."""
    boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    return [each for each in boxes if each.isVisible()]


def press(button=QtGui.QDialogButtonBox.Ok):
    (box,) = buttons()
    box.button(button).click()
