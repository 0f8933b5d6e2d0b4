"""The vocabulary that tasks and the readers of instructions share."""

from mansion_tasks.language.matching import match_score
from mansion_tasks.language.vocabulary import COLOUR_WORDS, COLOURS, OBJECTS, ROOMS


def test_a_word_stands_in_one_group_only() -> None:
    words = [word for group in (*OBJECTS, *ROOMS) for word in group.same + group.goal + group.loose]
    assert sorted(words) == sorted(set(words))


def test_words_that_mean_the_same_match_each_other() -> None:
    for group in (*OBJECTS, *ROOMS):
        name = group.same[0].replace(" ", "_")
        assert [match_score(word, name) for word in group.same] == [3] * len(group.same)
        assert all(match_score(word, name) > 0 for word in group.loose), name


def test_instructions_may_use_every_colour_of_a_material() -> None:
    assert set(COLOURS) < COLOUR_WORDS
    assert len(COLOURS) == len(set(COLOURS))
