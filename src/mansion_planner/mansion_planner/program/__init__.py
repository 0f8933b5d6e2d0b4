"""From facts to the building program: storeys, rooms, outlines, cores and areas."""
