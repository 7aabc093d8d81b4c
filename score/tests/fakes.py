"""Engines that go wrong, and one that is right: the can held still in the air."""

import os
import time

import numpy as np

from rimroll_score.protocol import State, Unsupported


class Still:
    """A body that stays where it was put."""

    settings = {"defaults": "nothing to set"}  # noqa: RUF012
    known_versions = ""

    def version(self):
        return "1.0"

    def make(self, scene, dt, setting):
        self.scene, self.dt, self.steps = scene, dt, 0
        return ["it never moves"]

    def set_state(self, state):
        self.held = state

    def step(self):
        self.steps += 1

    def time(self):
        return self.steps * self.dt

    def state(self):
        return self.held


class Raises(Still):
    def step(self):
        raise RuntimeError("the solver diverged")


class Hangs(Still):
    def step(self):
        time.sleep(60.0)


class HangsAtFirst(Still):
    def version(self):
        time.sleep(60.0)


class Dies(Still):
    def step(self):
        print("terminate called", flush=True)
        os._exit(7)


class ReturnsNaN(Still):
    def state(self):
        if self.steps < 3:
            return self.held
        return State(self.held.position * np.nan, *list(vars(self.held).values())[1:])


class WrongShape(Still):
    def state(self):
        return State(np.zeros(4), *list(vars(self.held).values())[1:])


class NoRotation(Still):
    def state(self):
        return State(self.held.position, 2.0 * np.eye(3), np.zeros(3), np.zeros(3))


class NoState(Still):
    def state(self):
        return np.zeros(13)


class TellsNoDepartures(Still):
    def make(self, scene, dt, setting):
        super().make(scene, dt, setting)


class TellsNumbers(Still):
    def make(self, scene, dt, setting):
        return [np.zeros(3), *super().make(scene, dt, setting)]


class Incomplete:
    settings = {"defaults": "it cannot step"}  # noqa: RUF012
    known_versions = ""

    def version(self):
        return "1.0"


class SlowClock(Still):
    def time(self):
        return 0.5 * self.steps * self.dt


class NoTable(Still):
    def make(self, scene, dt, setting):
        raise Unsupported("it has no table")


class OfTomorrow(Still):
    known_versions = ("0.", "0b")


class OpensWindow(Still):
    def version(self):
        import tkinter

        tkinter.Tk()


class Loud(Still):
    def step(self):
        print("a greeting on stdout")
        super().step()


class OnTheGround(Still):
    why_table_rests = "its ground is at rest"


class Random(Still):
    def state(self):
        place = self.held.position + np.random.default_rng().normal(0.0, 1e-6, 3)
        return State(place, *list(vars(self.held).values())[1:])
