// The paper in six steps, each with a text and a set-up of the lab.

import type { Playback } from "../setup/playback";
import type { Setup } from "../setup/setup";

export interface Step extends Playback {
  title: string;
  text: string;
  /** MathML, and what its symbols mean. */
  formula?: string;
  symbols?: string;
  /** Fields that differ from the initial set-up. */
  setup: Partial<Setup>;
  /** Whether the step shows one release or many flicks. */
  shows: "release" | "flicks";
}

const FLICK: Partial<Setup> = { tilt_rate: -5, sideways: 0.02, duration: 2 };

/** The limiting turn without slip (Srinivasan & Ruina 2008). */
const LIMIT =
  '<math display="block"><mi>π</mi><msqrt><mfrac>' +
  "<mrow><mi>A</mi><mo>+</mo><mi>m</mi><msup><mi>R</mi><mn>2</mn></msup><mo>+</mo><mi>m</mi><msup><mi>H</mi><mn>2</mn></msup></mrow>" +
  "<mrow><mi>A</mi><mo>+</mo><mi>m</mi><msup><mi>H</mi><mn>2</mn></msup></mrow>" +
  "</mfrac></msqrt></math>";

export const STEPS: readonly Step[] = [
  {
    title: "It looks like rocking",
    text: "Tip a can and let it go. It seems to slap flat on the table and rock up on the other side. The film stops at the top of this rise: the can has not come up opposite, but 22° to the side.",
    setup: {},
    speed: 1,
    stretched: false,
    view: "whole",
    shows: "release",
  },
  {
    title: "Look slower",
    text: "Let it go from a small tilt and watch it fifty times slower. The base never slaps the table. It comes very close to lying flat, but only one point of its rim touches.",
    setup: { tilt: 5, sideways: 0.02 },
    speed: 0.02,
    stretched: false,
    view: "whole",
    shows: "release",
  },
  {
    title: "It is rolling",
    text: "Now from nearby, and time stretches while the contact point races round the rim. The posts show the gap under the rim, drawn a few thousand times higher. The contact point runs more than half way round in less than a ten-thousandth of a second, but the marks on the rim stay where they are: the can itself does not turn. It rolls along its rim.",
    setup: {},
    speed: 1,
    stretched: true,
    view: "contact",
    shows: "release",
  },
  {
    title: "The angle is the same every time",
    text: "Let it go again and again. Chance decides between left and right, but not how far the contact point runs: close to 202° every time, and closer the flatter the can comes down. The limit depends only on the can:",
    formula: LIMIT,
    symbols:
      "m is its mass, R the radius of its base, H the height of its centre of mass, and A its moment of inertia for tipping about that centre.",
    setup: { law: "no_slip", unsteadiness: 10 },
    speed: 1,
    stretched: true,
    view: "whole",
    shows: "flicks",
  },
  {
    title: "Friction",
    text: "On a table without friction the can slides instead of rolling and turns by 221°. A real table is in between. The authors of the paper flicked a can 42 times and measured means of 213° to the left and 218° to the right. Try a friction near 0.1, and change the table to see the two humps move.",
    setup: { ...FLICK, law: "coulomb", friction: 0.12 },
    speed: 1,
    stretched: true,
    view: "whole",
    shows: "flicks",
  },
  {
    title: "Your turn",
    text: "Grab the top of the body and tilt it. Let go, or flick it by letting go while your hand moves. Change the body and the table, fill the bottle, spin a coin. To keep a motion or show it to a friend, use Share, further down.",
    setup: {},
    speed: 1,
    stretched: true,
    view: "whole",
    shows: "release",
  },
];
