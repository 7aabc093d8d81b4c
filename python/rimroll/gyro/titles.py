"""Which columns of a table hold the time and the rates, by their titles; and their units."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from rimroll.errors import RimrollError, UnitError
from rimroll.table import Table
from rimroll.units import factor_of

_UNIT_AT_END = re.compile(r"(.*?)\s*[\[(]\s*([^\[\]()]*?)\s*[\])]")
_RUN = re.compile(r"^.*?:\s*")
"""What Vernier writes before a title: the run or data set."""
_TIME = re.compile(r"t|time|zeit|temps|tiempo|seconds[ _]elapsed|elapsed[ _]time|time[ _]elapsed")
_GYRO = re.compile(
    r"gyro|angular[ _-]*(velocity|rate|speed)|rotation[ _-]*rate|drehrate|winkelgeschwindigkeit"
    r"|omega|^w[ _.-]*[xyz]$|ω"
)
_OTHER = re.compile(r"acc|magnet|mag[ _.-]|orient|angle|grav|baro|press|temper|absol|magnitude")
_ACCELEROMETER = re.compile(r"acc|beschleunigung")
_AXIS = re.compile(r"(?:^|[^a-z])([xyz])(?:$|[^a-z])")
_AXIS_IN_NAME = re.compile(r"^(?:gyro|omega|g|w)([xyz])$")
_PLAIN = re.compile(r"[xyz]")

_RATES = {
    **dict.fromkeys(("rad/s", "rad/sec", "rads/s", "rad s^-1", "rad·s⁻¹", "radians/s"), "rad/s"),
    **dict.fromkeys(
        ("deg/s", "°/s", "º/s", "dps", "deg/sec", "degrees/s", "degree/s", "°/sec", "degrees/sec"),
        "deg/s",
    ),
}


@dataclass(frozen=True)
class Chosen:
    """Places of the columns, factors to s and rad/s, and how they were understood."""

    t: int
    axes: tuple[int, int, int]
    seconds: float
    factor: float
    in_words: str


def chosen_columns(
    table: Table, units: str | None, columns: Mapping[str, str | int] | None
) -> Chosen:
    """The columns, by what the user named or by their titles; errors as for ``read``."""
    given = _given(table, columns)
    t = given.get("t", _time(table) if "t" not in given else 0)
    missing = [axis for axis in "xyz" if axis not in given]
    found = _axes(table, t) if missing else {}
    axes = tuple(given.get(axis, found.get(axis, -1)) for axis in "xyz")
    assert len(axes) == 3
    title = [_split(table, place) for place in (t, *axes)]
    factor, unit = _factor(table, [title[i] for i in (1, 2, 3)], units)
    written = [table.titles[i] if table.titles else f"column {i + 1}" for i in (t, *axes)]
    spelled = f"times {written[0]}; rates {written[1]}, {written[2]}, {written[3]} in {unit}"
    return Chosen(t, axes, _seconds(table, title[0]), factor, spelled)


def _given(table: Table, columns: Mapping[str, str | int] | None) -> dict[str, int]:
    places: dict[str, int] = {}
    for what, title in (columns or {}).items():
        if what not in ("t", "x", "y", "z"):
            raise RimrollError(f'columns must be for "t", "x", "y" and "z", got {what!r}')
        text = str(title).strip()
        named = [i for i, one in enumerate(table.titles) if one.strip().lower() == text.lower()]
        if not named and text.isdigit() and 1 <= int(text) <= table.width:
            named = [int(text) - 1]
        if len(named) != 1:
            have = ", ".join(table.titles) or f"{table.width} columns without titles"
            raise RimrollError(f'{table.name} has no column "{text}"; it has {have}')
        places[what] = named[0]
    if len(set(places.values())) < len(places):
        raise RimrollError(f"columns must be different ones, got {dict(columns or {})}")
    return places


def _split(table: Table, place: int) -> tuple[str, str | None]:
    """The name of a column in small letters, without the run, and its unit."""
    if not table.titles:
        return "", None
    title = _RUN.sub("", table.titles[place].strip())
    parts = _UNIT_AT_END.fullmatch(title)
    return (parts[1].lower(), parts[2] or None) if parts else (title.lower(), None)


def _time(table: Table) -> int:
    if not table.titles:
        raise RimrollError(
            f"{table.name}: the first line must name the columns, with units, as in Time (s),"
            " Gyroscope x (rad/s), …; or give columns by their numbers"
        )
    found = [i for i in range(table.width) if _TIME.fullmatch(_split(table, i)[0])]
    if len(found) != 1:
        several = "several columns" if found else "no column"
        raise RimrollError(
            f"{table.name} has {several} of times; it has {', '.join(table.titles)}: say which,"
            ' as in columns={"t": "…"} (on the command line --columns t=…)'
        )
    return found[0]


def _axes(table: Table, t: int) -> dict[str, int]:
    """The column of each axis."""
    names = {i: _split(table, i) for i in range(table.width) if i != t}
    gyro = [i for i, (name, _) in names.items() if _GYRO.search(name)]
    plain = [
        i
        for i, (name, unit) in names.items()
        if _is_rate(unit) and not _OTHER.search(name) and i not in gyro
    ]
    bare = [i for i, (name, unit) in names.items() if _PLAIN.fullmatch(name) and unit is None]
    for some in (gyro, plain, bare):
        axes = [(axis, i) for i in some if (axis := _axis(names[i][0])) is not None]
        places = {axis: [i for other, i in axes if other == axis] for axis in "xyz"}
        if all(len(one) == 1 for one in places.values()):
            return {axis: one[0] for axis, one in places.items()}
        if any(len(one) > 1 for one in places.values()):
            raise RimrollError(
                f"{table.name} has the rates of several runs or sensors; it has"
                f" {', '.join(table.titles)}: say which columns,"
                ' as in columns={"x": "…", "y": "…", "z": "…"} (on the command line --columns)'
            )
    if any(_ACCELEROMETER.search(name) or _is_acceleration(u) for name, u in names.values()):
        raise RimrollError(
            f"{table.name} holds accelerations; the turn needs the gyroscope (in phyphox:"
            " Gyroscope, rotation rate)"
        )
    raise RimrollError(
        f"{table.name} has no columns for the x, y and z of a gyroscope; it has"
        f" {', '.join(table.titles)}: name them,"
        ' as in columns={"x": "…", "y": "…", "z": "…"} (on the command line --columns)'
    )


def _axis(name: str) -> str | None:
    found = _AXIS_IN_NAME.search(name) or _AXIS.search(name)
    return found[1] if found else None


def _is_rate(unit: str | None) -> bool:
    return unit is not None and unit.lower() in _RATES


def _is_acceleration(unit: str | None) -> bool:
    return unit is not None and unit.lower().replace("²", "2").replace("^", "") in ("m/s2", "g")


def _seconds(table: Table, title: tuple[str, str | None]) -> float:
    unit = title[1]
    if unit is None or unit.lower() in ("sec", "seconds", "secs"):
        return 1.0
    return factor_of(unit, "s", f"{table.name}: the unit of {title[0]}", unit)


def _factor(
    table: Table, titles: list[tuple[str, str | None]], units: str | None
) -> tuple[float, str]:
    """The factor to rad/s, and the unit."""
    written = {unit for _, unit in titles}
    if len({_known(table, unit) if unit else None for unit in written}) > 1:
        several = ", ".join(sorted(map(str, written)))
        raise UnitError(f"{table.name}: the rates have different units: {several}")
    unit = next(iter(written))
    if unit is None and units is None:
        raise UnitError(
            f"{table.name}: the columns of rates name no unit: give it, as in"
            ' units="rad/s" or units="deg/s" (on the command line --units)'
        )
    given = None if units is None else factor_of(_spelled(units), "rad/s", "units", units)
    if unit is None:
        assert units is not None and given is not None
        return given, units
    factor = _known(table, unit)
    if given is not None and given != factor:
        raise UnitError(f'{table.name}: the rates are in {unit}, but units is "{units}"')
    return factor, unit


def _known(table: Table, unit: str) -> float:
    return factor_of(_spelled(unit), "rad/s", f"{table.name}: the unit of the rates", unit)


def _spelled(unit: str) -> str:
    return _RATES.get(unit.strip().lower(), unit)
