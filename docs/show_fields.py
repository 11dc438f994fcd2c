"""Shows the fields of a foot in ParaView: the foot cut open, its displacements enlarged, coloured by von Mises stress.

    pvpython docs/show_fields.py results/default/fields/contact.vtu foot.png     # a picture
    paraview --script=docs/show_fields.py                                        # in ParaView, of the file below
"""

import sys

from paraview.simple import (Clip, ColorBy, GetActiveViewOrCreate, GetColorTransferFunction, Render, ResetCamera,
                             SaveScreenshot, Show, WarpByVector, XMLUnstructuredGridReader)

fields = sys.argv[1] if len(sys.argv) > 1 else "results/default/fields/contact.vtu"
foot = XMLUnstructuredGridReader(FileName=[fields])

half = Clip(Input=foot)
half.ClipType = "Plane"
half.ClipType.Origin = [0, 0, 0]
half.ClipType.Normal = [1, 0, 0]  # x is the direction of travel, y points to the orbit's centre

bent = WarpByVector(Input=half)
bent.Vectors = ["POINTS", "displacement"]
bent.ScaleFactor = 1000  # micrometres on a foot of centimetres

view = GetActiveViewOrCreate("RenderView")
shown = Show(bent, view)
ColorBy(shown, ("POINTS", "von_mises_stress"))  # Pa
shown.RescaleTransferFunctionToDataRange(True)
shown.SetScalarBarVisibility(view, True)
colours = GetColorTransferFunction("von_mises_stress")
colours.ApplyPreset("Cividis", True)
colours.MapControlPointsToLogSpace()  # the stress near the contact is orders of magnitude larger than in the foot
colours.UseLogScale = 1
view.CameraPosition = [0.12, 0, 0.05]
view.CameraFocalPoint = [0, 0, 0.008]
view.CameraViewUp = [0, 0, 1]
ResetCamera()
Render()
if len(sys.argv) > 2:
    SaveScreenshot(sys.argv[2], view)
