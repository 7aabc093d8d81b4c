"""``rr.lab`` shows a body, a start and a law in the lab; web/tests has what the page does."""

import html
import re
import sys
import urllib.request
from importlib import resources
from types import SimpleNamespace
from urllib.parse import parse_qs

import numpy as np
import pytest

import rimroll as rr
from rimroll.browser.setup import setup_of

PAGE = resources.files("rimroll") / "page"
built = pytest.mark.skipif(
    not (PAGE / "alone.js").is_file(), reason="the page is not built: make web"
)
CAN = rr.bodies.can_2007()
START = rr.State(tilt="30 deg", tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)


def setup(body=None, start=None, law=None, duration=None, gravity=None, **shaking):
    text = setup_of(body, start, law, duration, gravity, **shaking)
    return {name: value for name, (value,) in parse_qs(text, keep_blank_values=True).items()}


@pytest.mark.parametrize("name", sorted(rr.bodies.PRESETS.keys() - {"ring"}))
def test_a_preset_is_named(name):
    assert setup(rr.bodies.by_name(name)) == {"body": name}


def test_the_page_s_ring_is_named_and_another_is_described():
    assert setup(rr.bodies.ring("5 cm")) == {"body": "ring"}
    assert setup(rr.bodies.ring("6 cm"))["body"] == "inertia"


@pytest.mark.parametrize("fill", [0.25, 1 / 3, 1.0])
@pytest.mark.parametrize("name", ["soda_can", "beer_bottle"])
def test_a_drink_is_as_full_as_it_is(name, fill):
    given = setup(getattr(rr.bodies, name)(fill))
    assert given["body"] == name
    assert float(given["fill"]) == pytest.approx(100 * fill, rel=1e-12)


def test_any_other_body_is_described_by_its_five_numbers_in_few_digits():
    assert setup(rr.Body(0.15, 0.03, 0.045, 3e-4, 1.5e-4)) == {
        "body": "inertia",
        "mass": "150",
        "radius": "3",
        "height": "4.5",
        "transverse": "20",
        "axial": "10",
    }


def test_a_start_is_described_as_a_hand_makes_it():
    given = {name: float(value) for name, value in setup(start=START).items()}
    sin, cos = np.sin(START.tilt), np.cos(START.tilt)
    assert (given["tilt"], given["tilt_rate"], given["yaw"]) == (30.0, -0.5, 0.0)
    # As startOf of web/src/setup/simulation_input.ts reads it.
    assert -given["sideways"] / sin == START.spin_rate
    assert given["twist"] + given["sideways"] * cos / sin == START.yaw_rate


def test_a_yaw_of_more_than_a_turn_is_the_same_direction():
    assert setup(start=rr.State(tilt=0.3, yaw="730 deg"))["yaw"] == "10"


def test_laws_with_their_numbers():
    assert setup(law=rr.NoSlip()) == {"law": "no_slip"}
    law = rr.Coulomb(0.2, restitution=0.5) + rr.RollingResistance(dry=1e-3)
    assert setup(law=law) == {
        "law": "coulomb",
        "friction": "0.2",
        "restitution": "0.5",
        "rolling": "0.001",
    }


@pytest.mark.parametrize(
    ("law", "reason"),
    [
        (rr.Viscous(0.1), "which has NoSlip, Frictionless and Coulomb, got Viscous"),
        (rr.Coulomb(0.2, static=0.3), "which has one coefficient for sticking and sliding"),
        (rr.NoSlip() + rr.AirDrag(1e-9), "which has dry rolling resistance alone"),
        (rr.NoSlip() + rr.RollingResistance(viscous=1e-3), "dry rolling resistance alone"),
    ],
)
def test_a_law_that_the_lab_does_not_have_is_refused(law, reason):
    with pytest.raises(rr.RimrollError, match=f"law cannot be shown in the lab, .*{reason}"):
        setup(law=law)


def read_as_the_page(given):
    """The ground of a set-up, as web/src/floor/ground.ts reads it."""
    number = {name: float(given[name]) for name in ("shake", "direction", "vertical", "period")}
    angle = np.radians(number["direction"])
    x, y = number["shake"] * np.cos(angle), number["shake"] * np.sin(angle)
    amplitude, period = (x, y, number["vertical"]), number["period"]
    if given["pulse"] in ("sine", "cosine"):
        return getattr(rr.ground, given["pulse"])(amplitude, period, float(given["cycles"]))
    return getattr(rr.ground, given["pulse"])(amplitude, period)


@pytest.mark.parametrize(
    "ground",
    [
        rr.ground.sine((3.0, -1.5, 2.0), 1.2, 2.5),
        rr.ground.cosine(3.0, 0.7, 3),
        rr.ground.half_sine((0.0, 3.0, 0.0), 0.3),
        rr.ground.rectangular(-3.67875, 0.58).rotated(0.4),
        rr.ground.ricker((1.0, 2.0, 0.0), 0.9).scaled(1.3),
    ],
)
def test_a_pulse_is_the_lab_s_floor(ground):
    given = setup(start=rr.State.standing(yaw=0.5), ground=ground, flat="housner")
    assert given["floor"] == "pulse" and given["flat"] == "housner"
    assert given["start"] == "standing" and "tilt" not in given
    read = read_as_the_page(given)
    times = np.linspace(0.0, 1.1 * ground.duration, 200)
    assert read.duration == ground.duration
    np.testing.assert_allclose(read(times), ground(times), atol=1e-12)


def test_a_lean_on_a_floor_that_moves_is_kept():
    given = setup(start=START, ground=rr.ground.sine(3.0, 1.0))
    assert given["tilt"] == "30" and "start" not in given and given["flat"] == "housner"


@pytest.mark.parametrize(
    ("ground", "flat", "message"),
    [
        (rr.ground.sampled(0.1, [0.0, 1.0, 0.0]), "stop", "one pulse .* and no records, got <Gro"),
        (rr.ground.sine(3.0, (1.0, 2.0, 1.0)) + rr.ground.sine(1.0, 2.0), "stop", "one pulse"),
        (rr.ground.ricker(3.0, 1.0, center=1.0), "stop", "one pulse"),
        (
            rr.ground.sine(3.0, 1.0),
            0.5,
            "flat cannot be shown in the lab, which has stop, smooth_l",
        ),
        (None, "stop", "start stands flat, which the lab shows on a ground that moves only"),
        ("quake.at2", "stop", "ground must be a rimroll.Ground"),
    ],
)
def test_a_ground_that_the_lab_does_not_have_is_refused(ground, flat, message):
    with pytest.raises(rr.RimrollError, match=message):
        setup(start=rr.State.standing(), ground=ground, flat=flat)


@built
def test_a_shaken_motion_keeps_its_ground_in_the_lab():
    pulse = rr.ground.sine("0.9 g", 0.3)
    shaken = rr.simulate(
        CAN, rr.State.standing(), rr.NoSlip(), 2.0, ground=pulse, flat="smooth_left"
    )
    assert "floor=pulse" in shaken.lab(browser=False).setup
    record = rr.ground.synthetic(1, 2.0)
    with pytest.raises(rr.RimrollError, match="and no records"):
        rr.simulate(CAN, rr.State.standing(), rr.NoSlip(), 2.0, ground=record).lab(browser=False)


def test_what_is_not_one_motion_is_refused():
    with pytest.raises(rr.RimrollError, match="body must be a single body"):
        rr.lab(rr.Body.stack([CAN, CAN]), browser=False)
    with pytest.raises(rr.RimrollError, match="a motion has one start"):
        rr.lab(CAN, rr.State(tilt=[0.1, 0.2]), browser=False)
    with pytest.raises(rr.RimrollError, match="height must be"):
        rr.lab(CAN, height=0.5, browser=False)


@built
def test_a_number_outside_the_lab_s_bounds_is_refused():
    with pytest.raises(rr.RimrollError, match="tilt must be between"):
        rr.lab(CAN, rr.State(tilt="95 deg"), browser=False)
    with pytest.raises(rr.RimrollError, match=r"duration must be from 0\.001 to 120"):
        rr.lab(duration=200.0, browser=False)


@built
def test_the_page_is_one_text_that_loads_nothing(tmp_path):
    lab = rr.lab(CAN, START, rr.NoSlip(), browser=False)
    page = lab.save(tmp_path / "can.html").read_text("utf-8")
    assert not re.search(r'(src|href)="(?!data:|#|https://doi\.org|licences\.txt)', page)
    (given,) = re.findall(r'<html data-setup="([^"]+)"', page)
    assert html.unescape(given) == lab.setup
    assert len(page) < 820_000  # six languages
    (frame,) = re.findall(r'<iframe srcdoc="([^"]+)"', lab._repr_html_())
    assert html.unescape(frame) == page


@built
def test_a_motion_shows_itself_in_the_lab():
    motion = rr.simulate(CAN, START, rr.Coulomb(0.2), duration=1.5, gravity=1.62)
    shown = motion.lab(browser=False)
    assert shown.setup == setup_of(CAN, START, rr.Coulomb(0.2), 1.5, 1.62)
    assert repr(shown) == f"<Lab {shown.setup}>"


def test_without_the_built_page_it_says_how_to_build_it(tmp_path, monkeypatch):
    monkeypatch.setattr("rimroll.browser.page.resources.files", lambda _name: tmp_path)
    with pytest.raises(rr.RimrollError, match=r"the page is not built yet.*make web"):
        rr.lab(CAN, browser=False)
    (tmp_path / "page").mkdir()
    (tmp_path / "page/index.html").write_text("<html><body></body></html>")
    (tmp_path / "page/setup.json").write_text('{"body": {"choices": ["can_2007"]}}')
    with pytest.raises(rr.RimrollError, match=r"the page is older than this rimroll.*make web"):
        rr.lab(CAN, browser=False)


@pytest.fixture
def fetched(monkeypatch):
    """The pages that the browser fetched."""
    pages = {}

    def browse(address):
        with urllib.request.urlopen(address, timeout=10) as response:
            pages[address] = response.read().decode()
        return True

    monkeypatch.setattr("rimroll.browser.view.webbrowser.open", browse)
    return pages


@built
def test_outside_a_notebook_the_browser_opens_it(fetched):
    lab = rr.lab(CAN, START)
    ((address, page),) = fetched.items()
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/", address)
    assert html.escape(page) in lab._repr_html_()
    assert lab.open() == address
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(address + "secret.txt", timeout=10)
    refused.value.close()


@built
def test_in_a_notebook_the_browser_does_not_open(fetched, monkeypatch):
    kernel = SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: kernel))
    rr.lab(CAN)
    assert fetched == {}
    terminal = SimpleNamespace(get_ipython=lambda: SimpleNamespace())
    monkeypatch.setitem(sys.modules, "IPython", terminal)
    rr.lab(CAN)
    assert len(fetched) == 1


@built
def test_without_a_browser_it_says_what_to_do(monkeypatch):
    monkeypatch.setattr("rimroll.browser.view.webbrowser.open", lambda _address: False)
    with pytest.raises(rr.RimrollError, match=r"no browser has opened .* its method save"):
        rr.lab(CAN)
