"""What a building shows to the street: its roofs, the entrance, its name and the plot around it.

Nothing of it bears on a robot indoors: it is drawn, and never part of maps, physics or the check.
"""

from mansion_export.exterior.chimneys import chimney_parts
from mansion_export.exterior.entrances import entrance_parts
from mansion_export.exterior.features import feature_parts
from mansion_export.exterior.plot import plot_parts
from mansion_export.exterior.roofs import roof_parts
from mansion_export.exterior.signs import sign_parts
from mansion_export.exterior.trims import trim_parts

__all__ = ["chimney_parts", "entrance_parts", "feature_parts", "plot_parts", "roof_parts", "sign_parts", "trim_parts"]
