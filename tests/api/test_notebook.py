"""What notebooks show of rimroll's objects."""

import base64
import io
import re
from html.parser import HTMLParser

import numpy as np
import pytest
from PIL import Image

import rimroll as rr

CAN = rr.bodies.can_2007()
START = rr.State(tilt="30 deg", tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)


@pytest.fixture(scope="module")
def motion():
    return rr.simulate(CAN, START, rr.NoSlip(), 0.6)


class Cells(HTMLParser):
    """The texts of the cells of a table, row by row; complains about tags that are not closed."""

    def __init__(self, text):
        super().__init__()
        self.rows, self.open = [], []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        if tag != "img":
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1] in ("td", "th"):
            self.rows[-1][-1] += data


def shown(thing):
    """The rows of the table that a notebook shows, by their first cell."""
    return {first: rest for first, *rest in Cells(thing._repr_html_()).rows}


def test_a_body_shows_its_numbers_and_what_follows_from_them():
    rows = shown(CAN)
    assert rows["mass"] == ["70 g"]
    assert rows["radius of the rim"] == ["5.1 cm"]
    assert rows["height of the centre of mass"] == ["6.9 cm"]
    assert rows["transverse inertia A"] == ["0.0003591 kg m²"]
    assert rows["turns without slip"] == ["202.29°"]  # the paper's
    assert rows["turns without friction"] == ["220.97°"]  # the paper's
    assert rows["friction needed to roll"] == ["0.356"]


def test_a_disk_shows_that_it_balances_on_its_edge():
    assert shown(rr.bodies.disk(0.1))["balances at"] == ["90.00°"]


def test_a_start_shows_degrees_and_rates():
    rows = shown(START)
    assert rows["tilt"] == ["30°"]
    assert rows["tilt_rate"] == ["-0.5 rad/s"]
    assert list(rows) == ["tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate"]


def test_arrays_have_no_view_of_their_own():
    assert rr.Body.stack([CAN, CAN])._repr_html_() is None
    assert rr.State(tilt=[0.1, 0.2])._repr_html_() is None


def test_a_turn_shows_its_angle(motion):
    (turn,) = motion.turns
    rows = Cells(turn._repr_html_()).rows
    assert rows[0] == ["angle", "smallest tilt", "at t"]
    assert rows[1][0] == f"{np.degrees(turn.angle):.4f}°"


def test_a_measurement_shows_its_uncertainties():
    rows = shown(
        rr.measure(
            mass="70 g", diameter="10.2 cm", balance_point="6.9 cm", swings=50, swings_time="38.3 s"
        )
    )
    assert rows["mass"] == ["70.0 ± 0.5 g"]
    assert rows["axial inertia C (estimated)"]


@pytest.mark.slow
def test_a_fit_shows_the_friction_and_the_verdicts():
    left, right = (np.radians(150.0), 0.05, 6), (np.radians(153.0), 0.05, 6)
    fit = rr.fit(CAN, rr.directions_from_summary(left=left, right=right), release="paper")
    rows = shown(fit)
    assert rows["friction"] == [str(fit.friction)]
    assert rows["from falls to the left"] == [str(fit.left)]
    assert f"{np.degrees(fit.bias):.1f}° (" in rows["bias"][0]
    for verdict in fit.verdicts:
        assert verdict.sentence.replace("<", "&lt;").replace(">", "&gt;") in fit._repr_html_()


def test_a_motion_shows_its_film(motion, tmp_path):
    film = motion.film(seconds=1, size=(80, 60), fps=5)
    (data,) = re.findall(r'src="data:image/gif;base64,([^"]+)"', film._repr_html_())
    assert base64.b64decode(data) == film.data
    with Image.open(io.BytesIO(film.data)) as picture:
        assert (picture.size, picture.n_frames) == ((80, 60), 6)
    assert film.save(tmp_path / "film.gif").read_bytes() == film.data
    with pytest.raises(rr.RimrollError, match=r"a film in memory is a \.gif"):
        film.save(tmp_path / "film.mp4")


def test_a_film_is_that_of_animate(motion, tmp_path):
    options = {"seconds": 1, "size": (80, 60), "fps": 5}
    written = motion.animate(tmp_path / "film.gif", **options)
    assert motion.film(**options).data == written.read_bytes()
    with pytest.raises(rr.RimrollError, match="view is"):
        motion.film(view="below")


@pytest.mark.slow
def test_a_film_lasts_six_seconds_or_as_its_speed_demands(motion):
    def seconds(**options):
        with Image.open(io.BytesIO(motion.film(size=(80, 60), **options).data)) as picture:
            return (picture.n_frames - 1) / 15.0

    assert seconds() == 6.0
    assert seconds(speed=1.0, slow_collision=False) == pytest.approx(0.6)


def test_a_figure_is_a_picture_without_pyplot(motion):
    with Image.open(io.BytesIO(motion.plot()._repr_png_())) as picture:
        assert (picture.format, picture.width > 700) == ("PNG", True)
