"""A computed motion: its data, figures, films and views."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rimroll import _core
from rimroll.bodies.body import Body, body_of
from rimroll.errors import RimrollError
from rimroll.files.recorded import expect_dataset
from rimroll.laws import Law, law_of
from rimroll.motion.trajectory import Trajectory
from rimroll.motion.words import motion_in_html
from rimroll.options import Options, flat_in_core, landing_given, options_of
from rimroll.state import State, single, start_of

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

    from rimroll.browser.view import Lab
    from rimroll.figures.animation import Film
    from rimroll.ground.ground import Ground


class Motion(Trajectory):
    """A computed motion.

    Its arrays are at the solver's accepted steps, which are close together where the motion is
    fast. A moment at which the contact changes is there twice, before and after the change. For
    other times, call it: ``motion(t)``.

    Attributes
    ----------
    body, start, law, ground, options
        What it was computed from; :class:`rimroll.Options` are one object.
    duration, gravity, rtol, topple_tilt, max_steps, flat, flat_gap
        The options one by one.
    status
        ``finished``, ``toppled``, ``lifted_off``, ``face_down``, ``at_rest``, ``painleve`` or
        ``failed``.
    """

    def _repr_html_(self) -> str:
        """The view in notebooks: the ending, the first turns in degrees and the losses."""
        return motion_in_html(self)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickling computes the motion again, with the same bits."""
        return (
            follow,
            (
                self.body,
                self.start,
                self.law,
                self.options,
                self._has_jacobian,
                None,
                self.ground,
            ),
        )

    def plot(self) -> Figure:
        """The paper's nine-panel simulation figure of this motion.

        For a motion on a ground: the ground, the tilt with its events, and the footprint's path.
        """
        if self.ground is not None:
            from rimroll.motion.figure import shaken_figure

            return shaken_figure(self)
        from rimroll.motion.figure import nine_panels

        return nine_panels(self)

    def animate(self, path: str | os.PathLike[str], **options: Any) -> Path:
        """Write the motion as a film: GIF, self-contained HTML page or MP4, by the suffix.

        Time slows down while the contact point runs fast round the rim. For ``seconds``,
        ``speed``, ``fps``, ``view`` and the other options see
        :func:`rimroll.figures.animation.animate`.
        """
        from rimroll.figures.animation import animate

        return animate(self, path, **options)

    def film(self, **options: Any) -> Film:
        """The motion as a film that a notebook shows: a GIF in memory.

        The options are those of :meth:`animate`; unless they are given, the film lasts 6 s and has
        15 pictures a second of 400 × 300 pixels.
        """
        from rimroll.figures.animation.film import film

        return film(self, **options)

    def lab(self, **options: Any) -> Lab:
        """The lab with this motion: in the notebook's cell, or in the browser.

        The options ``height`` and ``browser`` are those of :func:`rimroll.lab`, and so are the laws
        and the grounds that the lab has: one pulse, and no records.
        """
        from rimroll.browser.view import lab

        if self.flat_gap:
            raise RimrollError(
                field="flat_gap", value=self.flat_gap, bound="0 in the lab", unit="m"
            )
        return lab(
            self.body,
            self.start,
            self.law,
            duration=self.duration,
            gravity=self.gravity,
            ground=self.ground,
            flat=self.flat,
            **options,
        )

    @classmethod
    def from_xarray(cls, dataset: xr.Dataset, *, jacobian: bool = False) -> Motion:
        """The motion of a dataset from :meth:`to_xarray`, or from a file that holds one.

        It is computed again from the attributes: the same to the last bit, whichever points the
        dataset holds. ``jacobian`` as for :func:`simulate`. Raises ``RimrollError`` for a dataset
        of something else.
        """
        expect_dataset(dataset)
        if "outcome" in dataset:
            raise RimrollError("must be that of a motion, got one of falls", "dataset")
        from rimroll.ground.dataset import ground_of

        return follow(
            body_of(dataset),
            single(start_of(dataset)),
            law_of(dataset),
            options_of(dataset),
            jacobian,
            ground=ground_of(dataset),
        )


def follow(
    body: Body,
    start: State[float],
    law: Law,
    options: Options,
    has_jacobian: bool = False,
    progress: Callable[[float], object] | None = None,
    ground: Ground | None = None,
) -> Motion:
    """What :func:`rimroll.simulate` computes, from arguments that are already checked."""
    flat = landing_given(options.flat, ground is not None)
    options = replace(options, flat=flat)
    core = _core.simulate(
        body,
        start,
        law,
        *options.values,
        progress,
        has_jacobian,
        None if ground is None else ground.core,
        flat_in_core(flat, options.flat_gap),
    )
    return Motion(core, body, start, law, options, has_jacobian, ground)
