"""A key that prints as stars, and the removal of keys from text of other origin."""

import re

__all__ = ["Secret", "scrub", "shown_url"]

_STARS = "***"
_USER = re.compile(r"(?<=//)[^/@\s]+@")
_QUERY = re.compile(r"(?i)([?&](?:api[-_]?key|key|token|access_token|sig)=)[^&\s\"']+")
_BEARER = re.compile(r"(?i)(bearer\s+)[A-Za-z0-9._~+/=-]{8,}")


class Secret:
    """A key; its value shows in no repr, str, format, pickle or ``dataclasses.asdict``.

    Examples
    --------
    >>> Secret("sk-abc")
    Secret(***)
    >>> f"{Secret('sk-abc')}"
    '***'
    """

    __slots__ = ("_value",)

    def __init__(self, value: str) -> None:
        self._value = value

    def reveal(self) -> str:
        """Return the key, for the request's header alone."""
        return self._value

    def __bool__(self) -> bool:
        return bool(self._value)

    def __repr__(self) -> str:
        return f"Secret({_STARS})"

    def __str__(self) -> str:
        return _STARS

    def __format__(self, spec: str) -> str:
        return _STARS

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Secret) and other._value == self._value

    def __hash__(self) -> int:
        return hash(self._value)

    def __deepcopy__(self, memo: object) -> "Secret":
        return self

    def __reduce__(self) -> tuple[type["Secret"], tuple[str]]:
        raise TypeError("a key cannot be pickled")


def scrub(text: str, *secrets: Secret) -> str:
    """Return `text` without keys, bearer tokens, and user names and keys in addresses.

    Examples
    --------
    >>> scrub("key sk-123456 refused at http://me:pw@host/v1?api_key=xyz", Secret("sk-123456"))
    'key *** refused at http://***@host/v1?api_key=***'
    """
    for secret in secrets:
        if len(secret.reveal()) >= 4:
            text = text.replace(secret.reveal(), _STARS)
    text = _BEARER.sub(rf"\g<1>{_STARS}", text)
    text = _QUERY.sub(rf"\g<1>{_STARS}", text)
    return _USER.sub(f"{_STARS}@", text)


def shown_url(url: str) -> str:
    """Return an address as it may be shown: without user name, password and query."""
    return _USER.sub("", url).partition("?")[0]
