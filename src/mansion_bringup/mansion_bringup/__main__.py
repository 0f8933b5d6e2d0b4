"""``python -m mansion_bringup``."""

import os
import signal

# Until the command line is there to answer an interrupt, one ends the process at once: there is nothing to save, and an
# exception between two steps of an import may come up where it can only be printed.
signal.signal(signal.SIGINT, lambda number, frame: os._exit(128 + number))

from mansion_bringup.cli import main  # noqa: E402

signal.signal(signal.SIGINT, signal.default_int_handler)
main()
