"""How round things fall, rock and roll on the rim of their base.

>>> import numpy as np, rimroll as rr
>>> can = rr.bodies.can_2007()
>>> start = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
>>> motion = rr.simulate(can, start, rr.NoSlip(), duration=2.0, gravity=9.8)
>>> round(float(np.degrees(motion.turns[1].angle)), 3)
202.675
>>> round(float(np.degrees(rr.turn_limit(can, rr.NoSlip()))), 3)
202.287

Plain numbers are in SI units and radians throughout; texts such as ``"30 deg"`` and quantities of
pint are converted (see :mod:`rimroll.units`). Source of the mechanics:
M. Srinivasan and A. Ruina, *Rocking and rolling: a can that appears to rock might actually roll*
(2007), called "the paper" below.
"""

import ast
import sys
from importlib import import_module
from pathlib import Path


def _public():
    """The module of each public name, as the stub beside this file has it."""
    lines = ast.parse(Path(__file__).with_name("__init__.pyi").read_text("utf-8")).body
    imports = (line for line in lines if isinstance(line, ast.ImportFrom))
    return {alias.name: line.module for line in imports for alias in line.names}


_HOME = _public()

__all__ = sorted(_HOME)


def __getattr__(name):
    """A public name; its module is loaded when it is first used."""
    if name not in _HOME:
        raise AttributeError(
            f"module {__name__!r} has no attribute {name!r}",
            name=name,
            obj=sys.modules[__name__],
        )
    home = import_module(_HOME[name])
    if home is sys.modules[__name__] or not hasattr(home, name):  # a module of its own
        return import_module(f"{home.__name__}.{name}")
    value = globals()[name] = getattr(home, name)
    return value


def __dir__():
    return __all__
