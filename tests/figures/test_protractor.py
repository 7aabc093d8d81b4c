"""The protractor sheet is to scale, shows where a body falls, and fits on its paper."""

import json
import re
import zlib

import matplotlib as mpl
import numpy as np
import pytest
from hypothesis import given
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.patches import Circle, Rectangle, Wedge

import rimroll as rr
from given.strategies import bodies, examples
from rimroll.cli import main
from rimroll.experiment import protractor
from rimroll.figures import style

CAN = rr.bodies.can_2007()
POINTS = 72.0 / 25.4  # in a mm
PRINTABLE = 6.35  # mm that printers leave blank


def drawn(figure, kind, gid=None):
    (ax,) = figure.axes
    return [a for a in ax.get_children() if isinstance(a, kind) and gid in (None, a.get_gid())]


def in_points(figure, xy):
    """The place of an artist on the page, in points from its lower left corner."""
    (ax,) = figure.axes
    return ax.transData.transform(xy) / figure.dpi * 72.0


@pytest.mark.parametrize(("paper", "size"), [("a4", (210.0, 297.0)), ("letter", (215.9, 279.4))])
def test_the_page_is_the_paper_and_the_rim_has_its_true_size(paper, size):
    figure = protractor.sheet(CAN, "can", paper)
    assert figure.get_size_inches() * 25.4 == pytest.approx(size)
    (rim,) = drawn(figure, Circle, "rim")
    x, y = rim.center
    for way in ((51.0, 0.0), (0.0, 51.0)):
        moved = in_points(figure, (x + way[0], y + way[1])) - in_points(figure, (x, y))
        assert np.hypot(*moved) == pytest.approx(51.0 * POINTS, rel=1e-12, abs=0.0)
    assert rim.radius == pytest.approx(51.0)
    (bar,) = drawn(figure, mpl.lines.Line2D, "bar")
    ends = in_points(figure, np.column_stack(bar.get_data()))
    assert ends[1] - ends[0] == pytest.approx([100.0 * POINTS, 0.0])


def test_the_bar_is_100_mm_long_in_the_pdf_itself(tmp_path):
    path = tmp_path / "sheet.pdf"
    assert main(["protractor", "-o", str(path)]) == 0
    content = path.read_bytes()
    box = re.search(rb"/MediaBox \[ ([\d. ]+) \]", content)[1]
    assert [float(n) for n in box.split()] == pytest.approx([0, 0, 210 * POINTS, 297 * POINTS])
    streams = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", content, re.DOTALL)
    page = max((zlib.decompress(stream) for stream in streams if stream[:1] == b"x"), key=len)
    strokes = re.findall(rb"([\d.]+) ([\d.]+) m\n([\d.]+) ([\d.]+) l\s+S", page)
    level = [
        float(x1) - float(x0)
        for x0, y0, x1, y1 in strokes
        if y0 == y1 and float(y0) == pytest.approx(protractor.MARGIN * POINTS, abs=1e-3)
    ]
    assert level == pytest.approx([100.0 * POINTS], abs=1e-3)


def test_directions_count_anticlockwise_from_the_foot_of_the_page():
    figure = protractor.sheet(CAN)
    (ticks,) = drawn(figure, LineCollection, "ticks")
    (ring,) = drawn(figure, Circle, "ring")
    outer = np.array([segment[0] for segment in ticks.get_segments()]) - ring.center
    assert len(outer) == 360
    assert outer[[0, 90, 180, 270]] / ring.radius == pytest.approx(
        np.array([[0, -1], [1, 0], [0, 1], [-1, 0]]), abs=1e-12
    )
    lowest = ring.center[1] - ring.radius
    numbers = {
        text.get_text(): text.get_position()
        for text in figure.axes[0].texts
        if text.get_position()[1] > lowest
    }
    for direction in range(0, 360, 10):
        away = np.subtract(numbers[str(direction)], ring.center)
        assert away / np.hypot(*away) == pytest.approx(outer[direction] / ring.radius, abs=1e-6)


def test_the_shade_lies_between_the_two_limits_on_either_side():
    rolling, sliding = protractor.falls(CAN)
    assert (rolling, sliding) == pytest.approx((202.287, 220.969), abs=1e-3)  # the paper's limits
    spans = [
        ((wedge.theta1 + 90.0) % 360.0, (wedge.theta2 + 90.0) % 360.0)
        for wedge in drawn(protractor.sheet(CAN), Wedge)
    ]
    assert spans[0] == pytest.approx((rolling, sliding))
    assert spans[1] == pytest.approx((360.0 - sliding, 360.0 - rolling))
    texts = [text.get_text() for text in protractor.sheet(CAN).axes[0].texts]
    for text in ("rolling 202.3°", "sliding 221.0°", "rolling 157.7°", "sliding 139.0°"):
        assert text in texts


@pytest.mark.parametrize(("law", "which"), [(rr.NoSlip(), 0), (rr.Frictionless(), 1)])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_flicked_can_falls_where_the_sheet_says(law, which, side):
    start = rr.State(tilt=0.35, tilt_rate=-4.5, yaw_rate=side * 1e-7)
    motion = rr.simulate(CAN, start, law)
    assert motion.status == "toppled"
    # The contact point is at azimuth yaw + pi, at first and when it falls; its top lies beyond.
    fell = np.degrees(motion.yaw[-1] - motion.yaw[0]) % 360.0
    direction = protractor.falls(CAN)[which]
    assert fell == pytest.approx(direction if side > 0.0 else 360.0 - direction, abs=0.01)


def test_a_disk_has_one_line_whatever_the_friction():
    disk = rr.bodies.disk(0.05)
    assert protractor.falls(disk) == pytest.approx([np.degrees(np.pi * np.sqrt(5.0)) - 360.0] * 2)
    texts = [text.get_text() for text in protractor.sheet(disk).axes[0].texts]
    assert "rolling or sliding 42.5°" in texts and "rolling or sliding 317.5°" in texts


def extents(figure):
    """The left, lower, right and upper end of each text, mm."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    for text in figure.axes[0].texts:
        yield text.get_text(), text.get_window_extent(renderer).extents / figure.dpi * 25.4


@pytest.mark.parametrize("paper", protractor.PAPERS)
@pytest.mark.parametrize("name", ["can_2007", "battery", "coin"])
def test_everything_is_on_the_printable_page_and_the_text_keeps_clear_of_the_boxes(paper, name):
    kind = protractor.PAPERS[paper]
    with style.figure_style():
        figure = protractor.sheet(
            rr.bodies.by_name(name), "a name with $ and so long that " * 9, paper
        )
        boxes = [box for box in drawn(figure, Rectangle) if not box.get_fill()]
        assert len(boxes) == 42  # the paper's falls
        left, top = min(b.get_x() for b in boxes), max(b.get_y() + b.get_height() for b in boxes)
        bottom = min(b.get_y() for b in boxes)
        for text, (x0, y0, x1, y1) in extents(figure):
            assert x0 > PRINTABLE and x1 < kind.width - PRINTABLE, text
            assert y0 > PRINTABLE and y1 < kind.height - PRINTABLE, text
            if not text.isdigit():
                assert x1 < left or y0 > top or y1 < bottom, text
    (ring,) = drawn(figure, Circle, "ring")
    assert ring.radius + PRINTABLE < 0.5 * kind.width


@examples(15, derandomize=True)
@given(bodies())
def test_every_body_has_a_sheet_unless_it_is_too_wide_for_the_paper(body):
    limit = protractor.widest(protractor.PAPERS["a4"])
    if body.radius > limit:
        with pytest.raises(rr.RimrollError, match=r"^radius must be at most 82 mm"):
            protractor.sheet(body)
    else:
        assert len(drawn(protractor.sheet(body), Wedge)) == 2


def test_labels_that_would_overlap_move_apart_by_as_little_as_may_be():
    moved = protractor._apart([160.0, 179.0, 181.0, 200.0], 6.0)
    assert moved == pytest.approx([160.0, 177.0, 183.0, 200.0])
    crowded = np.diff(protractor._apart([178.0, 179.0, 181.0, 182.0], 6.0))
    assert np.all(crowded > 5.9)


# the command


@pytest.mark.parametrize("suffix", ["pdf", "svg", "png"])
def test_the_command_writes_a_sheet_and_says_where_it_falls(capsys, tmp_path, suffix):
    path = tmp_path / f"sheet.{suffix}"
    assert main(["protractor", "soda_can", "--paper", "Letter", "-o", str(path)]) == 0
    text = capsys.readouterr().out
    assert "between 190.3 (rolling) and 202.0" in text and f"wrote {path}" in text
    assert path.read_bytes()[:4] in (b"<?xm", b"\x89PNG", b"%PDF")
    assert [file.name for file in path.parent.iterdir()] == [path.name]


def test_the_same_sheet_is_the_same_file(tmp_path):
    for name in ("one.pdf", "two.pdf"):
        assert main(["protractor", "-o", str(tmp_path / name)]) == 0
    assert (tmp_path / "one.pdf").read_bytes() == (tmp_path / "two.pdf").read_bytes()


def test_a_scenario_file_has_a_sheet_under_its_own_name(capsys, tmp_path):
    file = tmp_path / "tin.toml"
    file.write_text('[body]\npreset = "can_2007"\n')
    assert main(["protractor", str(file), "-o", str(tmp_path / "tin.svg"), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["falls"] == dict(
        zip(("no_slip", "frictionless"), protractor.falls(CAN), strict=True)
    )
    assert answer["paper"] == "a4"


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ("--paper a5", "unknown paper 'a5': choose from a4, letter"),
        ("disk --radius 9cm", "radius must be at most 82 mm for the rim to fit on a4 paper"),
        ("-o sheet.doc", "cannot write sheet.doc: its suffix must be one of .png, .svg, .pdf"),
        ("jar", "unknown body 'jar'"),
        ("missing.toml", "there is no such file"),
    ],
)
def test_what_cannot_be_drawn_is_one_clear_line(
    capsys, monkeypatch, tmp_path, arguments, complaint
):
    monkeypatch.chdir(tmp_path)
    assert main(["protractor", *arguments.split()]) == 2
    error = capsys.readouterr().err
    assert complaint in error and error.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_sheet_is_of_a_body():
    with pytest.raises(rr.RimrollError, match=r"^body must be a rimroll.Body"):
        protractor.sheet("can_2007")


def test_help_has_examples(capsys):
    assert main(["protractor", "--help"]) == 0
    assert "$ rimroll protractor soda_can" in capsys.readouterr().out
