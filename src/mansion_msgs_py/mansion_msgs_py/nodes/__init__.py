"""The one thin shell around JSON payloads that all nodes use: decode, call, encode."""
