"""``python -m mansion_bringup``."""

from mansion_bringup.cli import main

main()
