// What the picture shows at one instant, and the layers that draw it. The unit of length of the stage, in which layers
// draw, is the radius of the circle of degrees (`reach`); all other lengths are in m.

import { Group, Matrix4, type Object3D, type PerspectiveCamera } from "three";
import type { Moment, Motion } from "../core/motion";
import type { Lab, Simulated, TurnProgress } from "../lab";
import { BODY_FIELDS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import { reachOf, type Size, sizeOf } from "./bodies/shapes";
import type { Palette } from "./palette";
import {
  type Footing,
  footingOf,
  heldContact,
  heldPose,
  type Pose,
  poseOf,
  type Rim,
  setPose,
  type Spot,
} from "./pose";

export interface Instant {
  lab: Lab;
  camera: PerspectiveCamera;
  setup: Readonly<Setup>;
  /** Undefined if there is no motion. */
  simulated: Simulated | undefined;
  /** The moment of the motion; undefined while the body is held. */
  moment: Moment | undefined;
  /** The turn at the time shown; undefined while the body is held. */
  progress: TurnProgress | undefined;
  /** Whether the body is transparent, so that its base and its rim are visible. */
  seeThrough: boolean;
  /** Names the body and how it looks. */
  look: string;
  size: Size;
  reach: number;
  rim: Rim;
  footing: Footing;
  pose: Pose;
  contact: Spot;
  /** The pose as a matrix of the stage. */
  placed: Matrix4;
}

/** A part of the picture. */
export interface Layer {
  readonly group: Object3D;
  /** Takes the colours; what has been drawn is drawn again. */
  paint(palette: Palette): void;
  update(instant: Instant): void;
}

const UPRIGHT: Footing = { shift: { x: 0, y: 0 }, slide: 0 };

/** Places the body, in the hand or in its motion. */
export class Instants {
  private followed: { motion: Motion; footing: Footing } | undefined;
  private readonly placed = new Matrix4();
  private readonly scale = new Matrix4();

  constructor(
    private readonly lab: Lab,
    private readonly camera: PerspectiveCamera,
  ) {}

  now(): Instant {
    const { lab, camera, placed, scale } = this;
    const setup = lab.setup.peek();
    const outcome = lab.outcome.peek();
    const simulated = "motion" in outcome ? outcome : undefined;
    const held = lab.held.peek();
    const view = lab.view.peek();
    const seeThrough = view === "contact" || view === "below";
    const numbers = (BODY_FIELDS[setup.body] ?? []).map((name) => setup[name]);
    const size = sizeOf(setup);
    const reach = reachOf(size);
    // Without a motion the body is drawn tipped about its rim, for which its height does not matter.
    const rim = simulated?.input.body ?? { radius: size.rim, height: 0 };
    const footing = this.footingOf(simulated);
    const moment = held ? undefined : lab.moment.peek();
    const start = { tilt: (setup.tilt * Math.PI) / 180, yaw: (setup.yaw * Math.PI) / 180 };
    const { pose, contact } = moment
      ? placedAt(moment, rim, footing)
      : placedInHand(held ?? start, rim, footing);
    setPose(placed, pose).premultiply(scale.makeScale(1 / reach, 1 / reach, 1 / reach));
    return {
      lab,
      camera,
      setup,
      simulated,
      moment,
      progress: held ? undefined : lab.turnProgress.peek(),
      seeThrough,
      look: [seeThrough, setup.body, ...numbers].join(" "),
      size,
      reach,
      rim,
      footing,
      pose,
      contact,
      placed,
    };
  }

  private footingOf(simulated: Simulated | undefined): Footing {
    if (!simulated) return UPRIGHT;
    const { motion, input } = simulated;
    if (this.followed?.motion !== motion)
      this.followed = { motion, footing: footingOf(motion, input.body) };
    return this.followed.footing;
  }
}

function placedAt(moment: Moment, rim: Rim, { shift }: Footing): { pose: Pose; contact: Spot } {
  return {
    pose: poseOf(moment, rim.height, shift),
    contact: { x: moment.contact_x + shift.x, y: moment.contact_y + shift.y },
  };
}

const placedInHand = (
  { tilt, yaw }: { tilt: number; yaw: number },
  rim: Rim,
  { slide }: Footing,
): { pose: Pose; contact: Spot } => ({
  pose: heldPose(rim, tilt, yaw, slide),
  contact: heldContact(rim, tilt, yaw, slide),
});

/** A layer that is loaded when it is first needed. */
export class LoadedLayer<Kind extends Layer> implements Layer {
  readonly group = new Group();
  layer: Kind | undefined;
  private palette: Palette | undefined;
  private wanted = false;

  /** `loaded` is called when the layer is there. */
  constructor(
    private readonly isNeeded: (instant: Instant) => boolean,
    private readonly load: () => Promise<Kind>,
    private readonly loaded: () => void,
  ) {}

  paint(palette: Palette): void {
    this.palette = palette;
    this.layer?.paint(palette);
  }

  update(instant: Instant): void {
    if (this.layer) return this.layer.update(instant);
    if (this.wanted || !this.isNeeded(instant)) return;
    this.wanted = true;
    this.load().then(
      (layer) => {
        if (this.palette) layer.paint(this.palette);
        this.group.add(layer.group);
        this.layer = layer;
        this.loaded();
      },
      (error: unknown) => {
        this.wanted = false;
        console.error(error);
      },
    );
  }
}
