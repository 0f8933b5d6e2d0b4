"""Change what stands in a building with one instruction, and write the changed files anew.

.venv/bin/python examples/edit.py --output out/examples    # after examples/build.py
"""

import argparse
import shutil
from pathlib import Path

from mansion_bringup.editor import open_editor, write_derived
from mansion_editing.instructions.instruct import instruct

INSTRUCTION = "put a red mug on the reception desk"


def main() -> None:
    """Edit a copy of the clinic, DIR/edited."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    output = parser.parse_args().output

    edited = output / "edited"
    shutil.rmtree(edited, ignore_errors=True)
    shutil.copytree(output / "clinic", edited, ignore=shutil.ignore_patterns("state"))

    # "mujoco", the default, lets things settle by physics and needs the extra `sim`.
    editor = open_editor(edited, physics="static", who="example")
    report = instruct(editor, INSTRUCTION)
    for step in report.steps:
        print(f"{step.tool}: {step.thought}" if step.tool else step.thought)
    print(f"{report.message} {', '.join(report.object_ids)}")
    write_derived(editor)  # what the folder has of plans, maps and models, of the floors that changed


if __name__ == "__main__":
    main()
