"""Units of length and area, as people write them."""

__all__ = ["AREA", "AREA_PATTERN", "LENGTH", "LENGTH_PATTERN", "SQUARE_FOOT"]

FOOT = 0.3048
SQUARE_FOOT = 0.09290304
"""Square metres in a square foot, exactly."""

TSUBO = 400.0 / 121.0
"""Square metres in a tsubo, which is a pyeong and a ping as well."""

AREA = {"m2": 1.0, "ft2": SQUARE_FOOT, "yd2": 9 * SQUARE_FOOT, "tsubo": TSUBO}
"""Square metres in one of each unit."""

LENGTH = {"m": 1.0, "cm": 0.01, "ft": FOOT}
"""Metres in one of each unit."""

_SQUARE = r"(?:square|sq)\b[.]?[ ]?"
AREA_PATTERN = (
    rf"(?P<m2>{_SQUARE}m(?:et(?:er|re)s?|trs?|ts?)?\b|m(?:ts?|trs?)?(?:²|\^?2\b|[ ]2(?=[ .,;:)]|$))"
    r"|m(?:et(?:er|re)s?)?[ ]square[sd]?\b(?![ ]?(?:room|garden|court|table|plan|building|hall))"
    r"|㎡|(?:sqm|qm|kvm|mq)\b|sq[.]m\b|m[.]?sq\b)"
    rf"|(?P<ft2>{_SQUARE}f(?:ee|oo)?t\b|(?:ft|f)(?:²|\^?2\b)|sqft\b|sf\b|sq[.]ft\b)"
    rf"|(?P<yd2>{_SQUARE}y(?:ar)?ds?\b|yd(?:²|\^?2\b))|(?P<tsubo>(?:tsubo|pyeong|pyung)s?\b)"
)
LENGTH_PATTERN = r"(?P<cm>cm\b)|(?P<m>m(?:et(?:er|re)s?|trs?)?\b)|(?P<ft>f(?:ee|oo)?t\b)"
