// The camera, at an azimuth, an elevation and a distance from the body.

import type { PerspectiveCamera } from "three";
import { prefersReducedMotion } from "../timing";
import type { ViewName } from "../setup/playback";

/** Bound of the elevation above and below the table, rad: not quite vertical. */
const HIGHEST = Math.PI / 2 - 0.001;
/** The camera is never nearer to the plane of the table than this, rad, where nothing on it could be seen. */
const LOWEST = 0.06;
/** The initial view, nearly from the side, rad. */
const USUAL = { azimuth: -1.36, elevation: 0.5 };
/** Duration of a camera movement, s. */
const GLIDE = 0.45;

/** At this distance or nearer, the camera looks at the base. */
const NEAR = 0.5;
/** Nearer than the first, the camera begins to look at the contact point, and does so from the second; 1 is the
 * distance from which the rim fills the picture. From further away the rim is in sight, and the camera stays still, so
 * that one sees the contact point run round. */
const CLOSE = [1.1, 0.6] as const;

/** How far a body moves before the camera follows it, in radii of the circle of degrees. */
const ROAM = 0.9;

/** Smooth step from 0 at the first place to 1 at the second. */
function smooth(from: number, to: number, place: number): number {
  const part = Math.min(Math.max((place - from) / (to - from), 0), 1);
  return part * part * (3 - 2 * part);
}

interface Spot {
  x: number;
  y: number;
}

interface Eye {
  azimuth: number;
  elevation: number;
  /** Distance over the one from which everything is visible. */
  distance: number;
  /** 0 looks at the middle of the body, 1 at the height of the table. */
  low: number;
}

const WHOLE: Readonly<Eye> = { ...USUAL, distance: 1, low: 0 };

export class View {
  private eye: Eye = WHOLE;
  private movement: { from: Eye; to: Eye; started: number } | undefined;
  /** Height of the point at which the camera looks, and radius of the region that must be visible. */
  private height = 0.3;
  private radius = 1.4;
  /** Radius of the rim. */
  private rim = 0.5;
  /** The place that was chosen last. */
  chosen: ViewName = "whole";

  /** The spot of the table in the middle of the picture. */
  readonly focus = { x: 0, y: 0 };
  /** Where a second body stands beside the first, which is in view too. */
  beside = { x: 0, y: 0 };
  /** The contact point and the middle of the base, now and when the camera was aimed last. */
  private body: { contact: Spot; base: Spot } = { contact: { x: 0, y: 0 }, base: { x: 0, y: 0 } };
  private aimed = this.body;

  constructor(private readonly camera: PerspectiveCamera) {}

  get azimuth(): number {
    return this.eye.azimuth;
  }

  get elevation(): number {
    return this.eye.elevation;
  }

  /** Frames a body with a height and a rim, in radii of the circle of degrees. */
  frame(height: number, rim: number): void {
    this.height = 0.29 * height;
    this.radius = Math.max(1.2, 0.62 * height + 0.53);
    this.rim = rim;
    if (this.chosen === "contact" || this.chosen === "below") this.go(this.eyeAt(this.chosen));
  }

  /** Follows a body that has moved far from the middle, unless the visitor prefers reduced motion. */
  follow(x: number, y: number): void {
    const far = Math.hypot(x, y);
    const part = far > ROAM && !prefersReducedMotion() ? 1 - ROAM / far : 0;
    this.focus.x = part * x + this.beside.x / 2;
    this.focus.y = part * y + this.beside.y / 2;
  }

  /** Sets the contact point and the middle of the base, at which the camera looks from nearby. */
  aim(contact: Spot, base: Spot): void {
    this.body = { contact, base };
    if (!prefersReducedMotion()) this.aimed = this.body;
  }

  turn(azimuth: number, elevation: number): void {
    const wanted = this.eye.elevation + elevation;
    // The camera passes through the plane of the table at once.
    const side = Math.abs(wanted) >= LOWEST ? wanted : elevation || this.eye.elevation;
    this.go({
      ...this.eye,
      azimuth: this.eye.azimuth + azimuth,
      elevation: Math.sign(side) * Math.max(Math.abs(wanted), LOWEST),
    });
  }

  zoom(factor: number): void {
    this.aimed = this.body;
    this.go({ ...this.eye, distance: this.eye.distance * factor });
  }

  /** Moves to a place. */
  show(name: ViewName): void {
    this.chosen = name;
    this.aimed = this.body;
    this.glide(this.eyeAt(name));
  }

  /** Is at a place at once. */
  cut(name: ViewName): void {
    this.chosen = name;
    this.aimed = this.body;
    this.go(this.eyeAt(name));
  }

  /** The distance from which the rim fills the picture. */
  private get rimDistance(): number {
    return this.rim / this.radius;
  }

  private eyeAt(name: ViewName): Eye {
    const near = this.rimDistance;
    switch (name) {
      case "whole":
        return WHOLE;
      case "above":
        return { ...WHOLE, azimuth: -Math.PI / 2, elevation: HIGHEST };
      case "contact":
        return { ...USUAL, elevation: 0.32, distance: 1.15 * near, low: 1 };
      case "below":
        return { ...USUAL, elevation: -0.6, distance: 1.7 * near, low: 1 };
    }
  }

  /** Moves the camera; returns whether the movement is still under way. */
  update(now: number): boolean {
    if (this.movement) {
      const part = (now - this.movement.started) / 1000 / GLIDE;
      const eased = smooth(0, 1, part);
      const { from, to } = this.movement;
      const between = (key: keyof Eye) => from[key] + eased * (to[key] - from[key]);
      this.eye = {
        azimuth: between("azimuth"),
        elevation: between("elevation"),
        distance: between("distance"),
        low: between("low"),
      };
      if (part >= 1) this.movement = undefined;
    }
    this.place();
    return this.movement !== undefined;
  }

  private place(): void {
    const { camera, eye, height } = this;
    const half = (camera.fov * Math.PI) / 360;
    const across = Math.atan(Math.tan(half) * camera.aspect);
    // From afar the camera looks at the middle of the body or of both bodies, from nearby at the base of the first, and
    // from very near at the contact point.
    const alone = Math.max(smooth(1, NEAR, eye.distance), eye.low);
    const close = smooth(...CLOSE, eye.distance / this.rimDistance);
    const wide = ((1 - alone) * Math.hypot(this.beside.x, this.beside.y)) / 2;
    const distance =
      Math.max(
        this.radius / Math.sin(Math.min(half, across)),
        (this.radius + wide) / Math.sin(across),
      ) * eye.distance;
    const flat = distance * Math.cos(eye.elevation);
    const middle = {
      x: this.focus.x - (alone * this.beside.x) / 2,
      y: this.focus.y - (alone * this.beside.y) / 2,
    };
    const { contact, base } = this.aimed;
    const between = (from: number, to: number, part: number) => from + part * (to - from);
    const x = between(middle.x, between(base.x, contact.x, close), alone);
    const y = between(middle.y, between(base.y, contact.y, close), alone);
    const z = (1 - alone) * height * Math.cos(eye.elevation);
    camera.position.set(
      x + flat * Math.cos(eye.azimuth),
      y + flat * Math.sin(eye.azimuth),
      z + distance * Math.sin(eye.elevation),
    );
    camera.lookAt(x, y, z);
  }

  private go(eye: Eye): void {
    this.movement = undefined;
    this.eye = {
      ...eye,
      elevation: Math.min(Math.max(eye.elevation, -HIGHEST), HIGHEST),
      distance: Math.min(Math.max(eye.distance, 0.12), 3),
    };
  }

  /** Moves the camera smoothly, or at once if the visitor prefers reduced motion. */
  private glide(to: Eye): void {
    if (prefersReducedMotion()) return this.go(to);
    // Choose the shorter way round.
    const round = 2 * Math.PI * Math.round((this.eye.azimuth - to.azimuth) / (2 * Math.PI));
    this.movement = {
      from: this.eye,
      to: { ...to, azimuth: to.azimuth + round },
      started: performance.now(),
    };
  }
}
