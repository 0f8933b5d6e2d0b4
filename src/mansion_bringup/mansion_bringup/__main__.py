"""``python -m mansion_bringup``."""

import signal
import sys

# Until the command line is there to answer an interrupt, one ends the process quietly.
signal.signal(signal.SIGINT, lambda number, frame: sys.exit(128 + number))

from mansion_bringup.cli import main  # noqa: E402

signal.signal(signal.SIGINT, signal.default_int_handler)
main()
