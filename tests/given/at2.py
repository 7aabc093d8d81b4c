"""AT2 files as PEER and others write them."""

HEADERS = (
    "NPTS={npts:6d}, DT={dt} SEC",
    "NPTS= {npts}, DT= {dt} SEC,   0 POLE @    30.00000 HZ,  -5 POLE @      .12000",
    "{npts:7d}    {dt}    NPTS, DT",
    "NPTS, DT = {npts}, {dt}",
    "DT= {dt} SEC, NPTS= {npts}",
    "npts = {npts} dt = {dt}sec",
)
"""Line 4, as it is found in files of different years."""

STYLES = {
    "exponents": lambda value: f"{value:15.7E}",
    "decimals": lambda value: f"{value:10.6f}",
    "no nought": lambda value: f"{value:12.7f}".replace("-0.", " -.").replace(" 0.", "  ."),
    "touching": lambda value: f"{value:.6f}" if value < 0 else f" {value:.7f}",
    "double": lambda value: f"{value:15.7E}".replace("E", "D"),
}
"""How a sample is written."""


def at2(
    samples,
    step="0.02",
    header=HEADERS[0],
    direction="000",
    style="exponents",
    per_line=5,
    npts=None,
    unit="G",
    title="PEER NGA STRONG MOTION DATABASE RECORD",
):
    """The text of a file with these samples."""
    written = [STYLES[style](value) for value in samples]
    rows = ["".join(written[i : i + per_line]) for i in range(0, len(written), per_line)]
    count = len(written) if npts is None else npts
    lines = (
        title,
        f"Somewhere-01, 1/1/2001, A Station, {direction}",
        f"ACCELERATION TIME SERIES IN UNITS OF {unit}",
        header.format(npts=count, dt=step),
    )
    return "\n".join((*lines, *rows, ""))
