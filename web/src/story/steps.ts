// The paper in six steps: what is said, and how the lab is set up for it.

import type { Setup } from "../setup/setup";

export interface Step {
  title: string;
  text: string;
  /** What differs from the initial set-up. */
  setup: Partial<Setup>;
  /** How time is shown: its speed, and whether it stretches by itself in the collision. */
  speed: number;
  stretched: boolean;
  /** What happens: one release, or many flicks. */
  shows: "release" | "flicks";
}

const FLICK: Partial<Setup> = { tilt_rate: -5, sideways: 0.02, duration: 2 };

export const STEPS: readonly Step[] = [
  {
    title: "It looks like rocking",
    text: "Tip a can and let it go. It seems to slap down flat on the table and rock up on the other side. It stops where it has come up: not opposite, but 22° to the side.",
    setup: {},
    speed: 1,
    stretched: false,
    shows: "release",
  },
  {
    title: "Look slower",
    text: "Let it go from a small tilt, and watch it fifty times slower. The base never slaps. It comes within a hair of lying flat, and one point of its rim keeps touching.",
    setup: { tilt: 5, sideways: 0.02 },
    speed: 0.02,
    stretched: false,
    shows: "release",
  },
  {
    title: "It is rolling",
    text: "Now time stretches by itself while the contact point races round the rim. The can rolls along its rim: the contact point runs more than half way round in less than a ten-thousandth of a second, and the can itself does not turn. Watch its red mark.",
    setup: {},
    speed: 1,
    stretched: true,
    shows: "release",
  },
  {
    title: "The angle is the same every time",
    text: "Let it go again and again. To the left or to the right is chance, but how far round is not: close to 202° every time, and the flatter it comes down, the closer. Only the shape of the can decides, by π\u00a0√((A\u00a0+\u00a0mR²\u00a0+\u00a0mH²)/(A\u00a0+\u00a0mH²)): m is its mass, R the radius of its base, H the height of its centre of mass, and A how hard it is to tip about that centre.",
    setup: { law: "no_slip", unsteady: 10 },
    speed: 1,
    stretched: true,
    shows: "flicks",
  },
  {
    title: "Friction",
    text: "On a table without friction the can slides instead of rolling, and turns by 221°. A real table lies between. The paper flicked a can 42 times and measured 213° and 218°: try a friction near 0.1, and switch the table to see the two humps move.",
    setup: { ...FLICK, law: "coulomb", friction: 0.12 },
    speed: 1,
    stretched: true,
    shows: "flicks",
  },
  {
    title: "Your turn",
    text: "Grab the top of the body and tilt it. Let go, or flick it by letting go in motion. Change the body and the table, fill the bottle, spin a coin. Share, further down, is for what you want to keep or show to a friend.",
    setup: {},
    speed: 1,
    stretched: true,
    shows: "release",
  },
];
