import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.glb_meshes import PieceRecord
from mansion_assets.library.convex_decomposition import piece_record
from mansion_assets.library.mass_estimate import guessed_mass
from mansion_assets.library.source_model import Look
from mansion_assets.meshes import collision_pieces

CATALOGUE = load_catalogue([])
PAINTED = Look((120, 30, 30))
CUBE = PieceRecord(center=(0.0, 0.0, 0.0), size=(1.0, 1.0, 1.0))


@pytest.mark.parametrize(
    ("category", "least", "most"),
    [
        ("sofa", 30, 90),
        ("armchair", 15, 45),
        ("dining_chair", 3, 12),
        ("office_chair", 8, 25),
        ("dining_table", 25, 90),
        ("wardrobe", 25, 120),
        ("fridge", 30, 110),
        ("floor_lamp", 1, 8),
        ("bathtub", 30, 130),
        ("mug", 0.1, 0.5),
    ],
)
def test_things_weigh_about_what_such_things_weigh(category: str, least: float, most: float) -> None:
    asset = CATALOGUE.by_category(category)[0]
    pieces = [piece_record("", piece) for piece in collision_pieces(asset)]
    assert least <= guessed_mass(pieces, asset.size, asset, PAINTED, opens=False).mass <= most


def test_the_volume_of_the_pieces_counts_and_not_the_box_around_them() -> None:
    size = (2.0, 2.0, 2.0)
    one = guessed_mass([CUBE], size, None, PAINTED, opens=False)
    two = guessed_mass([CUBE, CUBE], size, None, PAINTED, opens=False)
    assert two.mass == pytest.approx(2 * one.mass)
    assert "1 m3 of pieces" in one.how


def test_doors_make_it_hollow_and_its_look_tells_metal_and_glass() -> None:
    size = (1.0, 1.0, 1.0)
    plain = guessed_mass([CUBE], size, None, PAINTED, opens=False)
    steel = guessed_mass([CUBE], size, None, Look((120, 120, 120), metallic=0.9), opens=False)
    clear = guessed_mass([CUBE], size, None, Look((120, 120, 120), opacity=0.3), opens=False)
    cabinet = guessed_mass([CUBE], size, None, Look((120, 120, 120), metallic=0.9), opens=True)
    assert plain.mass < cabinet.mass * 2 < steel.mass < clear.mass
    assert "metal" in steel.how
    assert "hollow" in cabinet.how
