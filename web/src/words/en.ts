// English, whose table is the type of all others. The prose of the essay and the names of the sections are in
// index.html, so that they are there before any script. A table imports types only: see words.ts.

import type { Numbers } from "../compare/numbers";
import type { PresetName } from "../compare/presets";
import type { BodyName } from "../setup/fields";

const plural = new Intl.PluralRules("en");

/** Nouns for the bodies in a sentence. */
const NOUNS: Record<BodyName, string> = {
  can_2007: "can",
  soda_can: "can",
  beer_bottle: "bottle",
  coin: "coin",
  ring: "ring",
  battery: "battery",
  euler_disk: "disk",
  own: "body",
  inertia: "body",
};

/** Where the angle of a turn begins and ends, and what turned. Numbers are texts with their units. */
export interface Turned {
  /** Time of the tilt maximum at which it begins; undefined at the release. */
  start: string | undefined;
  end: string;
  endsWith: "maximum" | "fall" | "end";
  angle: string;
  /** Time for most of the angle. */
  time: string;
  body: BodyName;
  /** Rotation of the body itself. */
  itself: string;
  /** Direction of that rotation, compared with the contact point's. */
  way: "none" | "same" | "other";
}

/** The flicks that fell, or rocked up, to one side. */
export interface SideCount {
  side: "left" | "right";
  count: number;
  /** The mean and its deviation, as a text. */
  angle: string;
}

export const en = {
  /** What separates two sentences. */
  between: " ",

  loading: "Loading…",
  letGo: "Let go",
  flickTimes: (count: number) =>
    count === 1
      ? "Flick it once"
      : `Flick it ${count} ${plural.select(count) === "one" ? "time" : "times"}`,
  flickAgain: (count: number) => `Flick it ${count} times again`,
  openLab: "Open the lab",
  notStarted: (why: string) => `This page could not start: ${why}. Reloading it may help.`,

  fields: {
    body: {
      label: "Body",
      help: "The body that stands on the table.",
      choices: {
        can_2007: "The paper's can",
        soda_can: "Soda can",
        beer_bottle: "Beer bottle",
        coin: "Coin (1 euro)",
        ring: "Ring",
        battery: "Battery (AA)",
        euler_disk: "Euler's disk",
        own: "Your own",
        inertia: "By its inertia",
      } satisfies Record<BodyName, string>,
    },
    fill: {
      label: "Filled",
      help: "How full the can or bottle is. The drink moves with it like a solid.",
    },
    radius: { label: "Radius", help: "Radius of the rim." },
    length: { label: "Height", help: "From base to top. 0 is a flat disk." },
    mass: { label: "Mass", help: "Total mass. No angle of turn depends on it." },
    wall: {
      label: "Mass in the wall",
      help: "Share of the mass above the base plate: 0 is a solid cylinder, 100 a thin tube.",
    },
    base: {
      label: "Mass in the base",
      help: "Share of the total mass, in a thin plate at the bottom.",
    },
    height: {
      label: "Centre of mass",
      help: "Height of the centre of mass above the base. 0 is a flat disk.",
    },
    transverse: {
      label: "A/m",
      help: "Moment of inertia about a line through the centre of mass across the body, over the mass.",
    },
    axial: {
      label: "C/m",
      help: "Moment of inertia about the body's axis, over the mass. No rigid body has more than 2 A/m.",
    },
    tilt: { label: "Tilt", help: "How far the body leans when it is released." },
    tilt_rate: {
      label: "Tilt rate",
      help: "0 releases the body at rest. A negative rate flicks it toward upright.",
    },
    sideways: {
      label: "Sideways error",
      help: "How fast the body also turns about the line along which it leans. No hand avoids this error.",
    },
    twist: { label: "Twist", help: "How fast the body also turns about the vertical." },
    yaw: {
      label: "Leans toward",
      help: "The direction of the lean on the table. The whole motion turns with it.",
    },
    law: {
      label: "Table",
      help: "No friction and no slip are the paper's two ideal laws.",
      choices: { frictionless: "No friction", coulomb: "Dry friction", no_slip: "No slip" },
    },
    friction: {
      label: "Friction",
      help: "Coefficient of friction μ: largest friction force over normal force.",
    },
    rolling: {
      label: "Rolling resistance",
      help: "Resistance force over normal force: about 0.0001 for a hard rim on a hard table. It slows the motion down.",
    },
    restitution: {
      label: "Bounce",
      help: "Coefficient of restitution when the rim lands after a flight.",
    },
    gravity: { label: "Gravity", help: "9.81 on Earth, 1.62 on the Moon." },
    duration: { label: "Duration", help: "The time for which the motion is computed." },
    floor: {
      label: "Floor",
      help: "Whether the floor moves. The table moves with it, and does not turn.",
      choices: { rest: "At rest", pulse: "A pulse", hand: "By hand" },
    },
    start: {
      label: "Start",
      help: "Whether the body leans at first or stands flat on its base.",
      choices: { tilted: "Leaning", standing: "Standing flat" },
    },
    pulse: {
      label: "Shape",
      help: "The floor's acceleration over time.",
      choices: {
        sine: "Sine",
        cosine: "Cosine",
        half_sine: "Half sine",
        ricker: "Ricker wavelet",
        rectangular: "Rectangle",
      },
    },
    shake: {
      label: "Amplitude",
      help: "Largest horizontal acceleration. 9.81 is the gravity on Earth, 1 g.",
    },
    vertical: {
      label: "Vertical",
      help: "Largest vertical acceleration; positive is upward at first.",
    },
    period: {
      label: "Period",
      help: "Time of one oscillation; for a half sine and a rectangle, the time until it ends.",
    },
    cycles: { label: "Cycles", help: "Number of oscillations of a sine or a cosine." },
    direction: {
      label: "Direction",
      help: "The direction of the horizontal acceleration, as in “Leans toward”.",
    },
    flat: {
      label: "Flat landing",
      help: "What happens after the whole base lands at once. Rigid-body mechanics does not determine it.",
      choices: {
        stop: "The motion ends",
        smooth_left: "Runs round to the left",
        smooth_right: "Runs round to the right",
        housner: "Housner’s impact",
      },
    },
    record: { label: "Record" },
    falls: { label: "Falls" },
    flicks: { label: "Flicks", help: "How many times the release is repeated. The paper: 42." },
    unsteadiness: {
      label: "Unsteadiness of the hand",
      help: "At 100, a flick misses the middle by about 3°.",
    },
    seed: {
      label: "Seed",
      help: "Seed of the random numbers. The same seed gives the same scatter.",
    },
  },

  /** Refusals of values; `text` is what the visitor wrote. */
  refusals: {
    noSuchChoice: (label: string, names: readonly string[], text: string) =>
      `${label}: there is no “${text}”; choose ${[names.slice(0, -1).join(", "), ...names.slice(-1)].join(" or ")}.`,
    noRecord: (label: string) => `${label}: this is not a record of the page.`,
    twoReadings: (label: string, text: string, sign: "." | ",") =>
      `${label}: “${text}” can be read in two ways; write a ${sign === "." ? "point" : "comma"} before decimals and nothing between thousands.`,
    empty: (label: string) => `${label} needs a number.`,
    noNumber: (label: string, text: string) => `${label} must be a number, not “${text}”.`,
    notWhole: (label: string, text: string) => `${label} must be a whole number, not ${text}.`,
    between: (label: string, low: string, high: string, text: string) =>
      `${label} must be more than ${low} and less than ${high}; ${text} is outside.`,
    fromTo: (label: string, low: string, high: string, text: string) =>
      `${label} must be from ${low} to ${high}; ${text} is outside.`,
  },

  playback: {
    speed: "Speed",
    realTime: "real time",
    slow: "Slow at the collision",
    on: "on",
    off: "off",
    view: "View",
    step: "Step",
  },

  controls: {
    title: "Set-up",
    standsFlat: "The body stands flat, at rest.",
    undo: "Undo",
    reset: "Reset",
    more: "More",
    hint: "Point at a setting to see what it means.",
    dryOnly: "Applies to dry friction only.",
    tables: { ice: "ice", wood: "wood", rubber: "rubber" },
    losses: { none: "none", hard: "hard table", soft: "soft table" },
    lossesOf: (table: string, resistance: string) => `Rolling resistance: ${table}, ${resistance}`,
    frictionOf: (table: string, friction: string) => `Friction of ${table}, ${friction}`,
    neededLabel: (friction: string) =>
      `${friction}, the friction that this body needs to roll through its near-collision`,
    neededHelp: (friction: string) =>
      `With ${friction} or more this body rolls through its near-collision. With less it slips.`,
    floor: (state: string) => `The floor: ${state.toLowerCase()}`,
    notLoaded: "These controls could not be loaded. Reload the page.",
  },

  floor: {
    isLoading: "the part of this page that shakes the floor is being loaded",
    isMissing: "the part of this page that shakes the floor could not be loaded; reload the page",
    push: "Push",
    pushHelp: "Pushes the floor away from you for a fifth of a second and starts the motion.",
    shake: "Shake",
    shakeHelp: "Starts the motion of the floor and of the body.",
    note: "The flicks and the theory are those of a floor at rest. Positions in the plots are relative to the table.",
    onceOnly: "Applies to a sine and a cosine only.",
    pad: "Move the table",
    padHelp:
      "Drag here to move the table, one millimetre per pixel. When you let go, the body is shaken by the same motion. The arrow keys move the table, too.",
    balanceTilt: "Balance tilt",
    beyondBalance: "beyond it a body at rest falls over",
    largestTilt: "Largest tilt",
    ofBalance: (ratio: string) => `${ratio} of the balance tilt`,
    uplift: "Uplift",
    neverRocks: "it never begins to rock",
    whenRocks: "when it begins to rock",
    leansAtStart: "the body leans at the start",
    itsLargestTilt: (tilt: string) => `Its largest tilt is ${tilt}.`,
    overturns: (body: BodyName, after: string) => `The ${NOUNS[body]} overturns at ${after}.`,
    overturnsInAir: (body: BodyName, after: string) =>
      `The ${NOUNS[body]} overturns: its rim leaves the floor at ${after}.`,
    undecided: (after: string) =>
      `It is beyond its balance tilt after ${after}, when the computation ends: whether it overturns is undecided.`,
    survives: (state: "standing" | "sliding_flat" | "flying_level" | "moving", after: string) =>
      `It does not overturn. ${
        {
          standing: "It stands flat",
          sliding_flat: "It still slides on its base",
          flying_level: "It is in the air",
          moving: "It still moves",
        }[state]
      } after ${after}, when the computation ends.`,
    stops: (after: string) =>
      `The base comes down flat after ${after}, and the motion ends, as “Flat landing” is set. Rigid-body mechanics does not determine what follows.`,
    isStill: "The floor does not move.",
    moves: (far: string, strong: string) =>
      `The floor moves by up to ${far} and accelerates at up to ${strong}.`,
    beginsToRock: (body: BodyName, at: string) =>
      `The ${NOUNS[body]} begins to rock at ${at} (uplift).`,
    rocksAgain: (body: BodyName, at: string) =>
      `The ${NOUNS[body]} leans at first; it stands flat for a while and begins to rock again at ${at}.`,
    leans: (body: BodyName) => `The ${NOUNS[body]} leans at first.`,
    slides: (body: BodyName) => `The ${NOUNS[body]} slides on its base and never begins to rock.`,
    stands: (body: BodyName) =>
      `The ${NOUNS[body]} stands still on the floor and never begins to rock.`,
  },

  verdict: {
    turned: "Contact ran round",
    angleOfTurn: "Angle of turn",
    itself: (body: BodyName) => `The ${NOUNS[body]} itself`,
    meanwhile: "turned meanwhile",
    whenLetGo: "seen when you let go",
    ifLetGo: "if you let go now",
    theory: "In theory",
    smallestTilt: "Smallest tilt",
    gap: (gap: string) => `a gap of ${gap}`,
    contactThen: "Contact point then",
    perSecond: "times round per second",
    perSecondAt: (speed: string) => `times round per second, at ${speed}`,
    inHand: "In your hand",
    leansToward: (way: string) => `leans toward ${way}`,
    leansInHand: (tilt: string, way: string) => `In your hand it leans by ${tilt} toward ${way}.`,
    toFlick: "To flick it, let go while your hand moves.",
    /** What would follow if the hand let go now. */
    wouldBe: {
      floorMoves: "If you let go at rest now, the floor will begin to move.",
      nothing: "If you let go at rest now, there would be no motion.",
      rocked: (angle: string, after: string) =>
        `If you let go at rest now, its contact point would run round by ${angle} on its way down and up to the next tilt maximum, after ${after}.`,
      hovered: (after: string) =>
        `If you let go at rest now, it would not have come down and up again after ${after}, when the computation ends.`,
      toppled: (angle: string, after: string) =>
        `If you let go at rest now, its contact point would run round by ${angle}, and it would fall over after ${after}.`,
      fell_back: (after: string) =>
        `If you let go at rest now, it would fall over toward the side it leans to, after ${after}.`,
      face_down: (after: string) =>
        `If you let go at rest now, it would come down flat, after ${after}.`,
      at_rest: (after: string) =>
        `If you let go at rest now, it would come to rest on its base after ${after}.`,
      lifted_off: (after: string) =>
        `If you let go at rest now, its rim would leave the table after ${after}, where the ideal laws end.`,
      painleve: (after: string) =>
        `If you let go at rest now, it would meet Painlevé’s paradox after ${after}, where rigid-body mechanics has no unique answer.`,
      failed: "If you let go at rest now, the computation would fail.",
    },
    story: ({ start, end, endsWith, angle, time, body, itself, way }: Turned) => {
      const from = start === undefined ? "the release" : `the tilt maximum at ${start}`;
      const to = { maximum: "the next tilt maximum", fall: "its fall", end: "the end" }[endsWith];
      const turn = {
        none: itself,
        same: `${itself} the same way`,
        other: `${itself} the other way`,
      };
      return `From ${from}, down and up to ${to} at ${end}, the contact point runs round by ${angle}, most of it in ${time}; the ${NOUNS[body]} itself turns ${turn[way]}.`;
    },
    rim: {
      rolled: "Friction suffices: it rolls all the way.",
      slipped: "The rim slips on the way.",
      jumped: "The rim jumps off the table on the way.",
    },
    fullTurn: (rest: string) => `That is one full turn and ${rest}.`,
    veers: (angle: string, side: "left" | "right") =>
      `That is ${angle} to the ${side} of straight across.`,
    ofAngle: (angle: string, until: "turn" | "fall" | "end") =>
      `of ${angle} ${{ turn: "in this turn", fall: "when it falls", end: "at the end" }[until]}`,
    comesDownFlat: "it comes down flat",
    incomplete: "the next turn is not complete",
    staysUp: "it does not come down",
    limitHere: "the limit on this table",
    asComputed: "as computed here",
    below: (angle: string) => `${angle} below the computed turn`,
    above: (angle: string) => `${angle} above the computed turn`,
    /** For which bodies a limit holds. */
    holds: (text: string, flat: boolean, untwisted: boolean) =>
      `${text}; it holds for a body that ${[...(flat ? ["comes down flat"] : []), ...(untwisted ? ["is not twisted"] : [])].join(" and ")}`,
    noMotion: (why: string) => `There is no motion to show: ${why}.`,
    stillComputing: (after: string) => `The motion after ${after} is still being computed.`,
    stillMoves: (after: string) => `It still moves after ${after}, when the computation ends.`,
    fallsOver: (after: string) => `It falls over after ${after}.`,
    fallsBack: (after: string) =>
      `It falls over after ${after}, toward the side it leans to at first.`,
    /** `after` is undefined at the start. */
    liftsOff: (after: string | undefined) =>
      `${after === undefined ? "At once" : `After ${after}`} the rim would leave the table. The ideal laws do not cover flight, so the motion ends here. Choose dry friction to follow it.`,
    comesToRest: (after: string) =>
      `It comes to rest after ${after}: its base lies flat and its energy is spent.`,
    painleve: (after: string, friction: string) =>
      `Painlevé’s paradox after ${after}: with so much friction, rigid-body mechanics has no unique answer for the sliding rim. For this body, when it is nearly flat, the paradox begins at a friction of ${friction}. Set less friction to follow the motion.`,
    tooManySteps: (after: string) =>
      `The computation stops after ${after}, because it needs too many steps. Set a shorter duration.`,
    cannotContinue: (after: string, why: string) =>
      `The computation cannot continue after ${after}: ${why}.`,
    faceDownStraight: (after: string, least: string) =>
      `Face down after ${after}: without any sideways motion the whole rim meets the table at once. Rigid-body mechanics does not determine what follows. With any sideways error, however small, the contact point runs round instead; an error of ${least} or more can be computed.`,
    faceDownResisted: (after: string) =>
      `Face down after ${after}: rolling resistance stops the contact point, and the base slaps the table flat. Rigid-body mechanics does not determine what follows when every point of the rim collides at once. With less resistance or a larger sideways error the contact point runs round.`,
    faceDownShort: (after: string) =>
      `Face down after ${after}: it comes down so flat that the run of the contact point round the rim is too short to be computed. Set a larger sideways error.`,
    computationFailed: (why: string) =>
      `the computation failed (${why}); change the set-up or reload the page`,
  },

  essay: {
    guess: "Your guess",
    time: "Time",
    closer: "How can that be? Look closer",
    inLab: "Open this in the lab",
    grasp: "Grab the top of the can, tip it and let go. With a finger, first hold it for a moment.",
    askTelephone: "Use the tilt of this phone",
    holdTelephone: "Hold this, tip the phone, let go",
    theCan: "The can, which you can tip",
    theBody: "The body on the table",
    noPicture:
      "This browser cannot show the picture, because WebGL is off or missing. The words, numbers and curves work without it.",
    atSmallest: "at the smallest tilt",
    fromSmallest: (time: string, when: "before" | "after") => `${time} ${when} the smallest tilt`,
    range: (label: string, from: string, to: string) => `${label} from ${from} to ${to}`,
    guessedWell: "Well guessed!",
    guessedOff: (angle: string, further: boolean) =>
      `That is ${angle} ${further ? "beyond" : "short of"} your guess.`,
    cameUp: (said: string, straight: boolean, turned: string) =>
      `You said ${said}${straight ? ", straight across" : ""}. It came up at ${turned}.`,
    ranRound: (angle: string, time: string, body: BodyName, itself: string, gap: string) =>
      `The contact point ran round ${angle}, most of it in ${time}. The ${NOUNS[body]} itself turned ${itself}. The gap under its rim fell to ${gap}, but some point of the rim always touched.`,
    straight: (angle: string) => `${angle}, straight across`,
    notStraight: (angle: string, aside: string, beyond: boolean) =>
      `${angle}, ${aside} ${beyond ? "beyond" : "short of"} straight across`,
    sideways: "Sideways error of the hand",
    friction: "Friction of the table",
    height: "Height of the cylinder",
    body: "Body",
    bodies: { coin: "Coin", ring: "Ring", battery: "Battery", bottle: "Bottle" },
    lines: {
      turn: "angle of turn",
      limit: "limit",
      here: "limit on this table",
      noSlip: "no slip",
      frictionless: "no friction",
      noSlipLimit: "limit without slip",
    },
    hand: (angle: string, gap: string, time: string) =>
      `The contact point ran round ${angle}. The gap under the rim fell to ${gap}, and most of the angle took ${time}.`,
    table: (angle: string, rolled: boolean, limit: string) =>
      `The contact point ran round ${angle}, and the rim ${rolled ? "rolled all the way" : "slipped on the way"}. The flatter a can comes down, the closer its angle is to ${limit} on this table.`,
    cylinder: (angle: string, limit: string) =>
      `The contact point ran round ${angle}. The limit for this cylinder is ${limit}.`,
    limits: (angle: string, noSlip: string, frictionless: string) =>
      `The contact point ran round ${angle}. The limits are ${noSlip} without slip and ${frictionless} without friction.`,
  },

  story: {
    where: (step: number, of: number) => `The story, step ${step} of ${of}`,
    back: "‹ Back",
    backLabel: "Back to the previous step",
    show: "Show me",
    next: "Next ›",
    nextLabel: "Next step",
    steps: {
      looks: {
        title: "It looks like rocking",
        text: "Tip a can and let it go. It seems to slap flat on the table and rock up on the other side. The film stops at the top of this rise: the can has not come up opposite, but 23° to the side.",
      },
      slower: {
        title: "Look slower",
        text: "Let it go from a small tilt and watch it fifty times slower. The base never slaps the table. It comes very close to lying flat, but only one point of its rim touches.",
      },
      rolls: {
        title: "It is rolling",
        text: "Now from nearby: time stretches while the contact point races round the rim. The posts show the gap under the rim, drawn a few thousand times higher. The contact point runs more than half way round in less than a ten-thousandth of a second, but the marks on the rim stay where they are: the can itself does not turn. It rolls along its rim.",
      },
      same: {
        title: "The angle is the same every time",
        text: "Let it go again and again. Chance decides between left and right, but not how far the contact point runs. It is close to 202° every time, and the flatter the can comes down, the closer. The limit depends only on the can:",
        symbols:
          "m is its mass, R the radius of its base, H the height of its centre of mass, and A its moment of inertia for tipping about that centre.",
      },
      friction: {
        title: "Friction",
        text: "On a table without friction the can slides instead of rolling and turns by 221°. A real table is in between. The authors of the paper flicked a can 42 times and measured means of 213° to the left and 218° to the right. Try a friction near 0.1, and change the table to see the two humps move.",
      },
      yourTurn: {
        title: "Your turn",
        text: "Grab the top of the body and tilt it. Let go, or flick it by letting go while your hand moves. Change the body and the table, fill the bottle, spin a coin. To keep a motion or show it to a friend, use Share, further down.",
      },
    },
    histogram: (from: string, to: string, width: string) =>
      `Angles of turn of the falls, from ${from} to ${to} in bars of ${width}.`,
    caption: (width: string) =>
      `Angles of turn of the falls: left above, right below, ${width} per bar.`,
    measured: "Lines with a dot: mean and spread of the paper’s falls.",
    left: (count: number) => `left: ${count}`,
    right: (count: number) => `right: ${count}`,
  },

  flicks: {
    title: "Forty-two flicks",
    hint: "No hand repeats a motion exactly. Repeat this release with some scatter and see where the body falls.",
    clear: "Clear",
    hand: "The hand",
    picture: "Directions in which the body fell, seen from above",
    left: "to the left of the hand",
    right: "to the right",
    noSlip: "limit without slip",
    frictionless: "limit without friction",
    here: "limit on this table",
    measured: (left: string, right: string) => `the paper: ${left} and ${right}`,
    twisted: "The limits hold for a body that is not twisted.",
    initialLean: "initial lean",
    own: {
      title: "Your own falls",
      help: "Where did your can fall? Type the directions in degrees, anticlockwise from the initial lean; falls on your left are above 180. To pool several groups, paste their links.",
      add: "Add",
      clear: "Remove all",
      refused: "Type numbers from 0 to 360 with spaces between them, or paste links with falls.",
    },
    fit: {
      ask: "Which friction fits?",
      running: "Trying frictions …",
      answer: (friction: string, low: string, high: string) =>
        `A friction of ${friction} fits best; ${low} to ${high} fit nearly as well, if the hand is as set here.`,
      none: "None of the frictions makes the body fall to these sides.",
    },
    running: "Flicking it …",
    none: "This set-up cannot be flicked.",
    /** Each side of the falls, and how many flicks did something else. */
    summary: (made: number, sides: readonly SideCount[], fell: boolean, others: number) => {
      const did = fell ? "fell" : "came up";
      const each = sides.map(({ side, count, angle }) =>
        count === 0
          ? `none ${did} to the ${side}`
          : `${count} ${did} to the ${side} after ${angle}`,
      );
      const flicks = plural.select(made) === "one" ? "flick" : "flicks";
      const rest = others > 0 ? `; ${others} did something else` : "";
      return `Of ${made} ${flicks}, ${each.join(", ")}${rest}.`;
    },
  },

  limits: {
    title: "What this model leaves out",
    unevenness: "Unevenness of rim and table",
    unevennesses: {
      ground: "0.02 mm, ground",
      fine: "0.1 mm, fine",
      medium: "0.2 mm, medium",
      coarse: "0.4 mm, coarse",
      dented: "1 mm, dented",
    },
    touches: (time: string, angle: string, whole: string) =>
      `With this unevenness they touch at several points for ${time}. Meanwhile the contact point runs round ${angle} of the ${whole}; this part depends on the shape of both.`,
    touchesOnce:
      "The gap stays wider than this unevenness, so rim and table touch at one point all the time.",
    intro:
      "Body and table are perfectly rigid and smooth here, the rim is a perfect circle, and there is no air. In the turn that is shown:",
    none: "This body does not come down, so there is nothing to compare.",
    trust:
      "Where a number is beyond a real body, do not trust the gap or the speed. Trust the angle, which hardly depends on how small the gap gets. A hand makes a sideways error of about 0.02 rad/s.",
    gap: "Smallest gap under the rim",
    gapTiny:
      "Smaller than the unevenness of any rim and table, 0.1 to 0.4 mm: they touch at several points.",
    gapSmall:
      "No larger than the unevenness of rim and table, 0.1 to 0.4 mm: they may touch at several points.",
    gapWide: "Larger than the unevenness of rim and table, 0.1 to 0.4 mm.",
    speed: "Contact point along the rim",
    speedBeyond:
      "Faster than sound in steel, aluminium or glass, 5 to 6 km/s: rim and table cannot make way for it in time.",
    speedNear: "Not much slower than sound in steel, aluminium or glass, 5 to 6 km/s.",
    speedBelow: "Slower than sound in steel, aluminium or glass, 5 to 6 km/s.",
    time: "Time for most of the angle",
    bends: (sound: string) =>
      `Sound needs ${sound} to cross the base: the body bends and rings instead of moving as one piece.`,
    isRigid: (sound: string) =>
      `Sound needs ${sound} to cross the base: the body moves as one piece.`,
    force: "Largest force on the table",
    timesWeight: (ratio: string) => `${ratio} × the weight`,
    atOnePoint:
      "At one point of the rim. Whether it dents depends on the weight, the material and the edge.",
    losses: "Energy lost in this turn",
    lossless:
      "A real can loses energy to sound, air and bending in every turn, and soon stands still. “Rolling resistance” is one such loss.",
    loses: "Sound, air and bending, which are left out, take more.",
  },

  gyro: {
    title: "A phone in the body",
    intro:
      "A gyroscope that turns with the body does not see the contact point race round. Across the axis it sees rays: the body falls along one and rises along the next. Each near-collision turns the ray by the angle of turn minus 180°.",
    save: "Save as phyphox CSV",
    saved: (name: string, command: string) => `${name} saved. Read it with: ${command}`,
    veers: (angles: string) => `The first turns of the ray: ${angles}.`,
    noTurn: "There is no complete turn, so no ray turns.",
    picture: (largest: string) =>
      `Angular velocity across the axis, in the frame of the body, up to ${largest}.`,
  },

  share: {
    title: "Share",
    link: {
      help: "The link holds the whole set-up. No server sees it.",
      label: "Link to this set-up",
      copy: "Copy link",
      copied: "Link copied.",
    },
    command: {
      help: "The address of this page works only on your own machine. This command opens the same set-up wherever rimroll is installed.",
      label: "Command that opens this set-up",
      copy: "Copy command",
      copied: "Command copied.",
    },
    labTitle: "A can on a table",
    frame: "Put this on a page or a slide",
    frameHelp: (isLocal: boolean) =>
      `Paste this code into the HTML of the page or the slide.${isLocal ? " Copy the folder of this page beside it, under the name lab." : ""}`,
    copyFrame: "Copy code",
    copiedFrame: "Code copied.",
    python: "Python code",
    copyPython: "Copy as Python",
    copiedPython: "Python code copied.",
    csv: "Download CSV",
    saved: (name: string) => `${name} downloaded, in SI units and radians.`,
    select: "Selected: copy it with Ctrl+C or ⌘C.",
    samePython: "The same motion in Python",
  },

  transport: {
    group: "Playback",
    shown: "Time shown",
    play: "Play",
    pause: "Pause",
    rewind: "Back to the release",
    before: "To the previous collision",
    after: "To the next collision",
    back: "Previous frame",
    on: "Next frame",
    space: "Space",
    stretching: "Slows time down automatically while the contact point races round the rim",
    of: (time: string, end: string) => `${time} of ${end}`,
    atCollision: "at the collision",
    fromCollision: (time: string, when: "before" | "after") => `${time} ${when} the collision`,
    inRealTime: "in real time",
    slower: (times: string) => `${times} times slower than real time`,
    keys: "Keys",
    keyPlay: "play, pause",
    keyBack: "previous frame",
    keyOn: "next frame",
    keyHome: "back to the release",
    keysOn: "These keys work anywhere on the page",
  },

  sound: {
    name: "Sound",
    turnOn: "Turn on the sound of the rim, slowed down like the film",
    turnOff: "Turn off the sound",
    missing: "This browser cannot play sound",
  },

  plots: {
    absent: "There is no motion to plot.",
    hint: "Drag across a plot to zoom, click to go to a time, double-click to show the whole motion. The mouse wheel also zooms, after a click or with Ctrl. On a touch screen one finger goes to a time and two fingers zoom.",
    nothing: "nothing to show",
    range: (low: string, high: string) => `between ${low} and ${high}`,
    summary: (title: string, stretch: string, range: string) =>
      `${title} over time ${stretch}: ${range}`,
    timeLabel: (unit: string) => `time, ${unit}`,
    since: (unit: string, origin: string) => `${unit} from ${origin}`,
    collisionAt: (time: string) => `the collision at ${time}`,
    stretch: (from: string, to: string) => `from ${from} to ${to}`,
    about: (stretch: string, origin: string) => `${stretch} about ${origin}`,
    whole: "Whole motion",
    close: "This collision",
    closeHelp: "Shows the collision nearest to the time shown",
    zoom: "Zoom",
    zoomIn: "Zoom in",
    zoomOut: "Zoom out",
    shown: (stretch: string) => `Shown: ${stretch}`,
    shaded: "Shaded: ",
    now: (phase: string) => `At the time shown it is ${phase}.`,
    plot: "Plot",
    phases: {
      standing: "standing",
      rolling: "rolling",
      sliding: "sliding",
      sliding_flat: "sliding flat",
      flying: "flying",
      flying_level: "flying level",
      lying: "lying",
    },
    /** `short` is the name where there is little room. */
    figures: {
      floor: {
        title: "Floor, acceleration",
        short: "Floor",
        x: "along x",
        y: "along y",
        z: "upward",
      },
      tilt: { title: "Tilt", short: "Tilt", tilt: "tilt" },
      yaw: {
        title: "Yaw",
        short: "Yaw",
        yaw: "direction of the lean",
        theory: "theory, first turn",
      },
      rates: { title: "Rates", short: "Rates", tilt: "tilt", yaw: "yaw", spin: "spin" },
      gyroscope: {
        title: "Gyroscope in the body",
        short: "Gyroscope",
        x: "x",
        y: "y",
        z: "z, the axis",
      },
      friction: {
        title: "Friction ratio",
        short: "Friction",
        available: "available μ",
        used: "used |T|/N",
        needed: "needed to roll μ*",
      },
      energy: {
        title: "Energy",
        short: "Energy",
        potential: "potential",
        kinetic: "kinetic",
        sliding: "lost in sliding",
        rolling: "lost in rolling",
        impacts: "lost in impacts",
      },
    },
  },

  compare: {
    title: "Compare with…",
    help: "Shows a second motion beside the first, at the same time.",
    presets: {
      ice: "Ice and rubber",
      coin: "Can and coin",
      mirror: "This start and its mirror",
      keep: "Keep this motion and change the set-up",
    } satisfies Record<PresetName, string> as Record<PresetName, string>,
    keyA: "A, solid lines: the set-up above",
    keyB: "B, dashed lines: the other one",
    setup: "Set-up",
    turn: "First turn",
    difference: "B against A",
    rows: {
      turn: "Contact ran round",
      itself: "Body itself turned",
      limit: "Limit in theory",
      tilt: "Smallest tilt",
      gap: "Gap under the rim then",
      time: "Time until then",
      passage: "Time for most of the angle",
      force: "Largest force, in weights",
      energy: "Energy kept",
      end: "End of the whole motion",
    } satisfies Record<keyof Numbers, string> as Record<keyof Numbers, string>,
    ending: "How it ends",
    endings: {
      finished: "still moves",
      toppled: "falls over",
      lifted_off: "lifts off",
      face_down: "face down",
      at_rest: "at rest",
      painleve: "no answer",
      failed: "stops",
    } as Record<string, string>,
    same: "Both set-ups are the same so far. Change the set-up above: B stays as it is.",
    refused: (which: "A" | "B", why: string) => `${which} has no motion: ${why}.`,
    none: "One of the bodies does not come down, so there is no turn to compare.",
    equal: (angle: string) => `The contact point ran round ${angle} in both, to one decimal.`,
    turns: (a: string, b: string, apart: string, further: boolean) =>
      `The contact point ran round ${a} in A and ${b} in B: ${apart} ${further ? "more" : "less"} in B.`,
    swap: "Swap A and B",
    stop: "Stop comparing",
    times: (ratio: string) => `× ${ratio}`,
    label: (which: "A" | "B", text: string) => `${which}: ${text}`,
    drawn: (body: BodyName, times: string) => `${NOUNS[body]}, drawn ${times} × as large as A`,
    plot: (label: string) => `${label}, B`,
    total: "kinetic and potential, B",
    inLink: (message: string) => `Compared with: ${message}`,
  },
  scene: {
    picture: "The body on the table",
    tip: "Hold the body for a moment, then tip it.",
    reset: "Reset view",
    places: { above: "From above", contact: "Contact", below: "From below" },
    help: "How to use this picture",
    gestures:
      "Drag the body to tip it; with a finger, first hold it for a moment. Let go to release it, or let go while moving to flick it. Drag the table to look from another side. To zoom, pinch, or turn the mouse wheel after a click on the picture or with Ctrl.",
    keysTitle: "Keys while the picture has the focus:",
    /** Names of keys and what they do. */
    keys: [
      ["← → ↑ ↓", "look from another side, also from below"],
      ["Page Up, Page Down", "zoom in, zoom out"],
      ["Home", "reset the view"],
      ["+ and −", "take the body and tip it by 1°"],
      ["Shift + ← →", "swing its lean round by 5° while you hold it"],
      ["Enter", "let it go at rest"],
      ["Shift + Enter", "flick it with the rates that are set"],
      ["Escape", "put it back"],
    ] as readonly (readonly [key: string, does: string])[],
    rolls: "rolls",
    slips: "slips",
    flies: "in the air",
    square: (length: string) => `1 square = ${length}`,
    notLoaded: "The picture could not be loaded. Reload the page to see it.",
    noWebGL: "This browser cannot show the picture, because WebGL is off or missing.",
    rest: "The rest of this page works: the motion, the angles and the plots.",
    stopped: "The graphics of this browser have stopped. The picture returns when they restart.",
    ranRound: (angle: string) => `contact ran round ${angle}`,
    itself: (body: BodyName, angle: string) => `the ${NOUNS[body]} itself turned ${angle}`,
    guess: (angle: string) => `your guess ${angle}`,
    noSlip: "no slip",
    frictionless: "no friction",
    theory: "theory",
    gap: (gap: string) => `gap ${gap}`,
    gapDrawn: (gap: string, times: string) => `gap ${gap}, drawn ${times} × as high`,
    unrolled: "Path of the contact, unrolled: ",
    table: "table",
    rim: "rim",
    noSlipYet: "it rolls without slip",
    slipped: (length: string) => `its rim has slipped ${length}`,
    runs: (rim: string, table: string, slip: string) =>
      `In this turn the contact point has run ${rim} along the rim and ${table} along the table: ${slip}.`,
  },
};
