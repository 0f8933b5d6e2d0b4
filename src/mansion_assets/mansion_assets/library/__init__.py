"""Libraries of users' own assets: files of many kinds made into assets that a catalogue reads."""
