"""Which columns of a table hold the time and the rates, by their titles; and their units."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from rimroll.errors import RimrollError, UnitError
from rimroll.table import Table
from rimroll.titles import Title, columns_given, seconds_of, time_column, titles_of
from rimroll.units import factor_of

_GYRO = re.compile(
    r"gyr|angular (velocity|rate|speed)|angvel|rotation ?rate|drehrate|winkelgeschwindigkeit"
    r"|\bomega|^w ?[xyz]$|ω"
)
_OTHER = re.compile(r"\bacc|magnet|\bmag\b|orient|\bangle|grav|baro|press|temper|\babs|\bnorm")
_ACCELERATION = re.compile(r"\bacc(el|eleration|elerometer)?( ?[xyz])?\b|beschleunigung")
_AXIS_IN_WORD = re.compile(r"(?:gyro?|omega|g|w|rot|rate|angvel|ω)([xyz])|([xyz])(?:gyro?|rate)")

_RATES = {
    **dict.fromkeys(("rad/s", "rad/sec", "rads/s", "rad s^-1", "rad·s⁻¹", "radians/s"), "rad/s"),
    **dict.fromkeys(
        ("deg/s", "°/s", "º/s", "dps", "deg/sec", "degrees/s", "degree/s", "°/sec", "degrees/sec"),
        "deg/s",
    ),
    **dict.fromkeys(("rad_s", "rads_s", "rads", "rad_sec", "radians/sec"), "rad/s"),
    **dict.fromkeys(("deg_s", "degs", "degrees_s", "deg_sec", "degrees per second"), "deg/s"),
    "mdps": "mdeg/s",
}


@dataclass(frozen=True)
class Chosen:
    """Places of the columns, factors to s and rad/s, and how they were understood."""

    t: int
    axes: tuple[int, int, int]
    seconds: float
    is_stated: bool
    """Whether the unit of the times is stated."""
    factor: float
    in_words: str


def chosen_columns(
    table: Table,
    units: str | None,
    columns: Mapping[str, str | int] | None,
    time_unit: str | None,
) -> Chosen:
    """The columns, by what the user named or by their titles; errors as for ``read``."""
    given = columns_given(table, columns, ("t", "x", "y", "z"))
    if not table.titles and len(given) < len("txyz"):
        raise RimrollError(
            f"{table.name}: the first line must name the columns, with units, as in Time (s),"
            " Gyroscope x (rad/s), …; or give columns by their numbers, as in"
            ' columns={"t": 1, "x": 2, "y": 3, "z": 4} (on the command line'
            " --columns t=1,x=2,y=3,z=4)"
        )
    names = titles_of(table)
    missing = [axis for axis in "xyz" if axis not in given]
    found = _axes(table, names, [given[one] for one in given]) if missing else {}
    axes = tuple(given.get(axis, found.get(axis, -1)) for axis in "xyz")
    assert len(axes) == 3
    t = given["t"] if "t" in given else time_column(table, names[axes[0]].name)
    if len({t, *axes}) < len(axes) + 1:
        raise RimrollError(f"{table.name}: two of t, x, y and z are the same column")
    factor, unit = _factor(table, [names[i].unit for i in axes], units)
    seconds, is_stated = seconds_of(table.name, names[t], time_unit)
    written = [table.titles[i] if table.titles else f"column {i + 1}" for i in (t, *axes)]
    in_unit = f" in {time_unit}" if names[t].unit is None and time_unit is not None else ""
    spelled = f"times {written[0]}{in_unit}; rates {', '.join(written[1:])} in {unit}"
    return Chosen(t, axes, seconds, is_stated, factor, spelled)


def _axes(table: Table, titles: list[Title], given: list[int]) -> dict[str, int]:
    """The column of each axis."""
    names = {i: one for i, one in enumerate(titles) if i not in given and not one.is_time}
    rates = [i for i, one in names.items() if _is_rate(one.unit)]
    known = [i for i, one in names.items() if one.unit is None or i in rates]
    gyro = [i for i in known if _GYRO.search(names[i].name)]
    plain = [i for i in rates if not _OTHER.search(names[i].name) and i not in gyro]
    bare = [i for i, one in names.items() if one.name in ("x", "y", "z") and one.unit is None]
    for some in (gyro, plain, bare):
        axes = [(axis, i) for i in some if (axis := _axis(names[i].name)) is not None]
        places = {axis: [i for other, i in axes if other == axis] for axis in "xyz"}
        if all(len(one) == 1 for one in places.values()):
            return {axis: one[0] for axis, one in places.items()}
        if any(len(one) > 1 for one in places.values()):
            raise RimrollError(
                f"{table.name} has the rates of several runs or sensors; it has"
                f" {', '.join(table.titles)}: say which columns,"
                ' as in columns={"x": "…", "y": "…", "z": "…"} (on the command line --columns)'
            )
    if not rates and _holds_accelerations(names.values()):
        raise RimrollError(
            f"{table.name} holds accelerations; the turn needs the gyroscope (in phyphox:"
            " Gyroscope, rotation rate)"
        )
    raise RimrollError(
        f"{table.name} has no columns for the x, y and z of a gyroscope; it has"
        f" {', '.join(table.titles)}: name them,"
        ' as in columns={"x": "…", "y": "…", "z": "…"} (on the command line --columns)'
    )


def _holds_accelerations(titles: Iterable[Title]) -> bool:
    """Whether two or three axes of an accelerometer are among the columns."""
    found = [
        _axis(one.name)
        for one in titles
        if _ACCELERATION.search(one.name) or _is_acceleration(one.unit)
    ]
    return len(set(found) - {None}) >= 2


def _axis(name: str) -> str | None:
    """The axis in the words of a title, alone or in one of them: gyroscope x, gx, axis y."""
    words = name.split()
    found = [word for word in words if word in ("x", "y", "z")]
    if not found:
        parts = [_AXIS_IN_WORD.fullmatch(word) for word in words]
        found = [one[1] or one[2] for one in parts if one]
    return found[0] if len(set(found)) == 1 else None


def _is_rate(unit: str | None) -> bool:
    return unit is not None and unit.lower() in _RATES


def _is_acceleration(unit: str | None) -> bool:
    return unit is not None and unit.lower().replace("²", "2").replace("^", "") in ("m/s2", "g")


def _factor(table: Table, written: list[str | None], units: str | None) -> tuple[float, str]:
    """The factor to rad/s, and the unit."""
    if len({_known(table, unit) if unit else None for unit in written}) > 1:
        several = ", ".join(sorted(map(str, set(written))))
        raise UnitError(f"{table.name}: the rates have different units: {several}")
    unit = written[0]
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
