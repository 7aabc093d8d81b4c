// The friction that makes flicks fall where measured falls lie, by the means of both sides. rimroll.fit in Python uses each fall and
// allows for a turned protractor; this is a quick look.

import type { Core } from "../core/core";
import type { Setup } from "../setup/setup";
import { type Flick, flicksOf } from "./flicks";
import { tallyOf } from "./tally";
import { computed, effect, signal, untracked } from "@preact/signals-core";
import { button, element } from "../elements";
import { sliced } from "../timing";
import { formatFixed } from "../format";
import { say, words } from "../words/words";

/** Measured turns to one side, degrees. */
export interface MeasuredSide {
  mean: number;
  deviation: number;
  count: number;
}

export type Measured = Record<"left" | "right", MeasuredSide>;

/** How far the means of flicks are from the measured ones. */
export interface Trial {
  friction: number;
  /** Sum of squared distances in standard errors. */
  misfit: number;
}

export interface Fit {
  friction: number;
  /** Ends of the frictions whose misfit is larger by no more than 1. */
  low: number;
  high: number;
}

const [STEP, STEPS] = [0.02, 20];
/** Flicks for each friction, all with the same scatter. */
const FLICKS = 60;
/** Flicks between two pauses. */
const PAUSE = 10;

/** The misfit of frictions up to 0.4, computed as they are asked for, with pauses between them. */
export function* trials(
  core: Core,
  setup: Readonly<Setup>,
  measured: Measured,
): Generator<Trial | undefined, void> {
  for (let k = 1; k <= STEPS; k++) {
    const friction = k * STEP;
    const flicks: Partial<Setup> = { law: "coulomb", friction, flicks: FLICKS, unsteadiness: 100 };
    const falls: Flick[] = [];
    for (const fall of flicksOf(core, { ...setup, ...flicks }))
      if (falls.push(fall) % PAUSE === 0) yield undefined;
    const tally = tallyOf(falls);
    let misfit = 0;
    for (const side of ["left", "right"] as const) {
      const [seen, made] = [measured[side], tally[side]];
      if (seen.count < 2) continue;
      const error = seen.deviation ** 2 / seen.count + made.deviation ** 2 / made.count;
      misfit += (seen.mean - made.mean) ** 2 / error;
    }
    yield { friction, misfit };
  }
}

/** The best friction of some trials; undefined if no flicks fell to a side that was measured. */
export function fitOf(all: readonly (Trial | undefined)[]): Fit | undefined {
  const known = all
    .filter((trial) => trial !== undefined)
    .filter(({ misfit }) => Number.isFinite(misfit));
  const best = known.reduce<number>(
    (best, { misfit }, k) => (misfit < (known[best]?.misfit ?? Infinity) ? k : best),
    0,
  );
  const lowest = known[best];
  if (!lowest) return undefined;
  const [before, after] = [known[best - 1], known[best + 1]];
  let { friction, misfit } = lowest;
  if (before && after) {
    // The lowest point of a parabola through three points.
    const slope = (after.misfit - before.misfit) / 2;
    const bend = after.misfit - 2 * misfit + before.misfit;
    if (bend > 0) {
      friction -= (STEP * slope) / bend;
      misfit -= slope ** 2 / (2 * bend);
    }
  }
  /** Where the misfit has risen by 1 on one side, between two trials. */
  const end = (way: 1 | -1): number => {
    let [from, low] = [friction, misfit];
    for (let k = best + (way > 0 ? 1 : -1); known[k]; k += way) {
      const { friction: at, misfit: here } = known[k]!;
      if (here > misfit + 1) return from + ((at - from) * (misfit + 1 - low)) / (here - low);
      [from, low] = [at, here];
    }
    return from;
  };
  return { friction, low: end(-1), high: end(1) };
}

// A button that asks which friction fits measured falls, and the answer.

/** `setup` and `measured` read signals; the fit varies the table and takes the rest of the set-up as it is. */
export function fitted(
  core: Core,
  setup: () => Readonly<Setup>,
  measured: () => Measured | undefined,
): HTMLElement {
  const { fit } = words.flicks;
  const asked = signal<string | undefined>(undefined);
  const used = computed(() => JSON.stringify([withoutTable(setup()), measured()]));
  const wanted = computed(() => asked.value === used.value);
  const { results, complete } = sliced(() => {
    const falls = measured();
    return wanted.value && falls
      ? trials(core, untracked(setup), falls)
      : ([] as (Trial | undefined)[]).values();
  });
  const ask = button(fit.ask, () => (asked.value = used.peek()));
  const said = element("p", { class: "fit", role: "status" });
  effect(() => {
    ask.hidden = measured() === undefined;
    const best = wanted.value && complete.value ? fitOf(results.value) : undefined;
    said.textContent = !wanted.value
      ? ""
      : !complete.value
        ? fit.running
        : best
          ? say(fit.answer, {
              friction: formatFixed(best.friction, 2),
              low: formatFixed(best.low, 2),
              high: formatFixed(best.high, 2),
            })
          : fit.none;
  });
  return element("div", { class: "fitted" }, ask, said);
}

/** The set-up without what the fit varies. */
const withoutTable = (setup: Readonly<Setup>): Partial<Setup> => ({
  ...setup,
  law: "coulomb",
  friction: 0,
  flicks: 0,
  unsteadiness: 0,
});
