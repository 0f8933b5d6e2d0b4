"""Buildings in IFC4, for programs of architects and engineers; needs the ``ifc`` extra."""

from mansion_export.ifc.building import building_ifc, ifc_files

__all__ = ["building_ifc", "ifc_files"]
