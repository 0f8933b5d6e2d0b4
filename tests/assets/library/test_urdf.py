"""What of a URDF is taken, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from mansion_assets.library.urdf import read_urdf
from mansion_msgs_py.errors import MansionError
from sample_models import CABINET


def written(folder: Path, text: str) -> Path:
    path = folder / "model.urdf"
    path.write_text(text)
    return path


def test_a_drawer_that_is_open_at_zero_is_closed(tmp_path: Path) -> None:
    pulled = CABINET.replace('lower="0" upper="0.35"', 'lower="-0.35" upper="-0.05"')
    model = read_urdf(written(tmp_path, pulled))
    drawer = model.parts[1]
    assert drawer.joint is not None
    assert drawer.joint.travel == pytest.approx(0.3)


def test_a_hinge_becomes_a_door_in_degrees(tmp_path: Path) -> None:
    door = """<robot name="locker"><link name="b"><visual><geometry><box size="0.4 0.4 1.0"/></geometry></visual></link>
    <link name="d"><visual><origin xyz="0 0.2 0"/><geometry><box size="0.02 0.4 1.0"/></geometry></visual></link>
    <joint name="j" type="revolute"><parent link="b"/><child link="d"/><origin xyz="0.21 -0.2 0"/><axis xyz="0 0 1"/>
    <limit lower="-1.5707963" upper="0"/></joint></robot>"""
    part = read_urdf(written(tmp_path, door)).parts[1]
    assert part.name == "door_1"
    assert part.joint is not None
    assert part.joint.kind == "hinge"
    assert part.joint.travel == pytest.approx(90.0)
    np.testing.assert_allclose(part.joint.axis, (0, 0, -1), atol=1e-6)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("<robot", "is not XML"),
        ("<sdf/>", "is not a URDF"),
        ("<robot><link name='a'/></robot>", "is empty"),
        (CABINET.replace("prismatic", "screw"), "of type 'screw'"),
        (CABINET.replace('child link="tray"', 'child link="lid"'), "that does not exist"),
        (CABINET.replace('xyz="1 0 0"', 'xyz="0 0 0"'), "no direction"),
        (CABINET.replace("0.34 0.44 0.3", "0.34 inf 0.3"), "finite numbers"),
        (CABINET.replace('<box size="0.34 0.44 0.3"/>', '<mesh filename="../x.obj"/>'), "outside"),
    ],
)
def test_what_is_no_sound_urdf_is_refused_with_the_reason(tmp_path: Path, text: str, reason: str) -> None:
    with pytest.raises(MansionError, match=reason):
        read_urdf(written(tmp_path, text))
