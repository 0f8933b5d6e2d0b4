"""Gymnasium is optional: without it only what does not need it is tested."""

from importlib.util import find_spec

collect_ignore = [] if find_spec("gymnasium") else ["test_building_env.py"]
