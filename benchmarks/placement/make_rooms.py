"""Write the rooms that the placement benchmark uses: twenty kinds, 9 to 102 objects each.

python benchmarks/placement/make_rooms.py benchmarks/placement/rooms.json
"""

import json
import sys
from pathlib import Path

from room_kinds import ROOMS

if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps(ROOMS, indent=1) + "\n", encoding="utf-8")
