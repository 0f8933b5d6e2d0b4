"""Words for rooms on plans in German, French, Spanish, Italian and Dutch, in English."""

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

__all__ = ["in_english"]

_WORDS: Final[Mapping[str, str]] = MappingProxyType(
    {
        word: english
        for english, words in {
            "bathroom": "bad badezimmer duschbad salle_de_bain salle_de_bains salle_d_eau bano bagno badkamer",
            "toilet": "toilettes gabinetto",
            "kitchen": "kuche kueche wohnkuche wohnkueche cocina cucina keuken",
            "living room": "wohnen wohnzimmer wohnraum stube sejour sala sala_de_estar soggiorno woonkamer",
            "dining room": "essen esszimmer essplatz salle_a_manger comedor sala_da_pranzo eetkamer",
            "bedroom": "schlafen schlafzimmer schlafraum elternschlafzimmer gaestezimmer chambre dormitorio "
            "camera camera_da_letto slaapkamer",
            "children's room": "kind kinderzimmer chambre_d_enfant",
            "home office": "arbeiten arbeitszimmer",
            "office": "buro buero bureau oficina ufficio kantoor",
            "hallway": "flur diele korridor gang couloir degagement pasillo corridoio overloop",
            "entrance hall": "eingang windfang vorraum entree recibidor ingresso hal",
            "storage": "abstellraum abstellkammer keller kellerraum debarras rangement trastero ripostiglio berging",
            "utility room": "hauswirtschaftsraum hwr buanderie lavadero lavanderia bijkeuken",
            "technical room": "technik technikraum heizung heizraum hausanschlussraum local_technique",
            "pantry": "speisekammer vorrat cellier dispensa",
            "dressing room": "ankleide ankleidezimmer",
            "meeting room": "besprechung besprechungsraum salle_de_reunion sala_riunioni vergaderruimte",
            "terrace": "terrasse terraza terrazza terras",
            "stairs": "treppe treppenhaus treppenraum escalier escalera escaleras scala trappenhuis",
            "elevator": "aufzug fahrstuhl ascenseur ascensor ascensore",
        }.items()
        for word in words.split()
    }
)
"""English by word, without accents, lower case, with underscores."""


def in_english(name: str) -> str:
    """Return the English of the words that a room's name begins with, else of those that it ends with; else empty.

    Examples
    --------
    >>> in_english("schlafzimmer_2"), in_english("salle_de_bain"), in_english("1_og_flur"), in_english("kitchen")
    ('bedroom', 'bathroom', 'hallway', '')
    """
    parts = re.sub(r"^(\d+_)+|(_\d+)+$", "", name).split("_")
    beginnings = (parts[:length] for length in range(len(parts), 0, -1))
    endings = (parts[start:] for start in range(1, len(parts)))
    found = (_WORDS.get("_".join(words), "") for words in (*beginnings, *endings))
    return next(filter(None, found), "")
