"""``mansion check --norms``: the rules of building, measured on the finished geometry."""

from mansion_bringup.check.norms.deviations import check_norms, norms_of_folder
from mansion_bringup.check.norms.premises import Deviation, Premises, premises_of

__all__ = ["Deviation", "Premises", "check_norms", "norms_of_folder", "premises_of"]
