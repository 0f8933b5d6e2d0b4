"""What a building is clad with: by its type, then by its seed."""

from mansion_geometry.randomness import item_generator
from mansion_msgs_py.scene import FloorScene

__all__ = ["DEFAULT_FACADE", "facade_material", "facade_of"]

DEFAULT_FACADE = "facade_render"

_DWELLING = ("red_brick", "white_render", "sand_render", "timber_cladding", "facade_render")
_CIVIC = ("sandstone", "red_brick", "stone_cladding", "white_render")
_HEALTH = ("white_render", "facade_render", "concrete_panels")
_WORK = ("concrete_panels", "facade_render", "white_render", "dark_brick")
_INDUSTRY = ("metal_panels", "concrete_panels", "dark_brick")
_HOSPITALITY = ("sand_render", "facade_render", "dark_brick", "white_render")

_BY_WORD: tuple[tuple[tuple[str, ...], tuple[str, ...]], ...] = (
    (("warehouse", "factory", "workshop", "fire", "logistics", "data", "garage"), _INDUSTRY),
    (("hospital", "clinic", "care", "medical", "laboratory", "nursing"), _HEALTH),
    (("house", "villa", "flat", "apartment", "townhouse", "cottage", "home"), _DWELLING),
    (("school", "kindergarten", "university", "library", "museum", "court"), _CIVIC),
    (("hotel", "dormitory", "restaurant", "cafe", "hostel", "cinema"), _HOSPITALITY),
)


def facade_material(building_type: str, seed: int) -> str:
    """Return the material of a building's outer walls, the same for all its floors."""
    words = building_type.lower().replace("-", "_").split("_")
    choice = next((materials for names, materials in _BY_WORD if any(word in names for word in words)), _WORK)
    if not building_type:
        return DEFAULT_FACADE
    return choice[int(item_generator(seed, "facade").integers(len(choice)))]


def facade_of(scene: FloorScene) -> str:
    """Return the material of a finished floor's outer walls."""
    faces = (wall.right_material for wall in scene.walls if wall.exterior and wall.right_material)
    return next(faces, DEFAULT_FACADE)
