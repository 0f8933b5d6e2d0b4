"""What was done before: undone, done again, put back or repeated elsewhere."""

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.sentence import Sentence
from mansion_editing.instructions.phrases.word_sets import EARLIER_STEPS
from mansion_editing.instructions.statements import History, Place, Statement

__all__ = ["PastSteps"]


class PastSteps(Sentence):
    """Reads ``undo that``, ``put it back`` and ``the same for the bedroom``."""

    def _undo(self, at: int, place: int) -> tuple[list[Statement], int]:
        what = "undo" if self.text(at) in ("undo", "revert", "reverse", "roll", "cancel") else "redo"
        end = place
        times = 1
        while end < len(self.words) and (self.text(end) in EARLIER_STEPS or self.words[end].kind == "number"):
            number = int(self.words[end].value) if self.words[end].kind == "number" else 1
            times = max(times, number, 2 if self.text(end) == "both" else 1)
            end += 1
        return [History(what="undo" if what == "undo" else "redo", times=times, quote=self.quote(at, end))], end

    def _meant(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``I meant the archive``, ``no, the blue one``: the last instruction, there or with that instead."""
        place = at
        while self.text(place) in ("no", "sorry", "oops", "wait", ",", "hm", "hmm"):
            place += 1
        if not (self.text(place) in ("i", "we") and self.text(place + 1) in ("meant", "mean", "mean't")):
            return None
        place += 2
        item = self.item(place)
        if item is not None and item.phrase.noun.kind in ("room", "both"):
            end = item.end + 2 * (self.text(item.end) == "," and self.text(item.end + 1) in ("not", "sorry"))
            rooms = Place(rooms=item.rooms())
            return [History(what="amend", place=rooms, quote=self.quote(at, item.end))], max(end, item.end)
        places, end = self.places(place)
        if places:
            return [History(what="amend", place=joined_places(places)[0], quote=self.quote(at, end))], end
        if item is not None:
            return [History(what="amend", things=item.things(), quote=self.quote(at, item.end))], item.end
        return None

    def _restore(self, at: int, place: int) -> tuple[list[Statement], int]:
        items = self.items(place)
        end = items[-1].end
        return [History(what="restore", things=item.things(), quote=self.quote(at, end)) for item in items], end

    def _repeat(self, at: int, place: int) -> tuple[list[Statement], int]:
        end = place
        while self.text(end) in ("thing", "for", "with", "again", "it", "that"):
            if self.text(end) in ("for", "with"):
                break
            end += 1
        if self.text(end) in ("for", "in", "on", "at", "to", "with"):
            item = self.item(end + 1)
            if item is not None and item.phrase.noun.kind in ("room", "both"):
                return [
                    History(what="repeat", place=Place(rooms=item.rooms()), quote=self.quote(at, item.end))
                ], item.end
            places, stop = self.places(end)
            if places:
                return [History(what="repeat", place=joined_places(places)[0], quote=self.quote(at, stop))], stop
        return [History(what="repeat", quote=self.quote(at, end))], end
