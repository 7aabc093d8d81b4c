// Where the picture is taken from: round the body at an azimuth, an elevation and a distance.

import type { PerspectiveCamera } from "three";
import { prefersReducedMotion } from "../reduced_motion";

/** rad; the eye never goes under the table nor quite over the top. */
const [LOWEST, HIGHEST] = [0.06, Math.PI / 2 - 0.001];
/** Nearly from the side, as one sees a can rock. */
const USUAL = { azimuth: -1.36, elevation: 0.5 };
/** s */
const GLIDE = 0.45;

/** Nearer than this, over the distance from which all is seen, the eye is on the contact point. */
const NEAR = 0.5;

/** As far as a body goes without the eye going after it, in radii of the circle of degrees. */
const ROAM = 0.9;

/** From 0 to 1 with neither a start nor an end that jerks. */
const smooth = (part: number) => part * part * (3 - 2 * part);

interface Eye {
  azimuth: number;
  elevation: number;
  /** Distance over that from which all is seen. */
  distance: number;
}

export class View {
  private eye: Eye = { ...USUAL, distance: 1 };
  private way: { from: Eye; to: Eye; begun: number } | undefined;
  /** Height of what is looked at and the radius of what is to be seen round it. */
  private height = 0.3;
  private radius = 1.4;

  /** The spot of the table that is in the middle of the picture. */
  readonly focus = { x: 0, y: 0 };
  /** Where the body touches the table, and where it did when the eye was last turned to it. */
  private contact = { x: 0, y: 0 };
  private aimed = this.contact;

  constructor(private readonly camera: PerspectiveCamera) {}

  get azimuth(): number {
    return this.eye.azimuth;
  }

  get elevation(): number {
    return this.eye.elevation;
  }

  /** Frames a body of a height, in radii of the circle of degrees. */
  frame(height: number): void {
    this.height = 0.29 * height;
    this.radius = Math.max(1.2, 0.62 * height + 0.53);
  }

  /** Goes after what has gone far from the middle, but not for who would rather not see things move. */
  follow(x: number, y: number): void {
    const far = Math.hypot(x, y);
    const part = far > ROAM && !prefersReducedMotion() ? 1 - ROAM / far : 0;
    this.focus.x = part * x;
    this.focus.y = part * y;
  }

  /** Takes note of the spot where the body touches the table: it is what there is to see from near by. */
  aim(x: number, y: number): void {
    this.contact = { x, y };
    if (!prefersReducedMotion()) this.aimed = this.contact;
  }

  turn(azimuth: number, elevation: number): void {
    this.go({
      ...this.eye,
      azimuth: this.eye.azimuth + azimuth,
      elevation: this.eye.elevation + elevation,
    });
  }

  zoom(factor: number): void {
    this.aimed = this.contact;
    this.go({ ...this.eye, distance: this.eye.distance * factor });
  }

  reset(): void {
    this.glide({ ...USUAL, distance: 1 });
  }

  fromAbove(): void {
    this.glide({ azimuth: -Math.PI / 2, elevation: HIGHEST, distance: 1 });
  }

  /** Simulated the camera; whether it is still on its way. */
  update(now: number): boolean {
    if (this.way) {
      const part = Math.min((now - this.way.begun) / 1000 / GLIDE, 1);
      const eased = smooth(part);
      const { from, to } = this.way;
      const between = (key: keyof Eye) => from[key] + eased * (to[key] - from[key]);
      this.eye = {
        azimuth: between("azimuth"),
        elevation: between("elevation"),
        distance: between("distance"),
      };
      if (part === 1) this.way = undefined;
    }
    this.place();
    return this.way !== undefined;
  }

  private place(): void {
    const { camera, eye, height } = this;
    const half = (camera.fov * Math.PI) / 360;
    const narrow = Math.min(half, Math.atan(Math.tan(half) * camera.aspect));
    const distance = (this.radius / Math.sin(narrow)) * eye.distance;
    const flat = distance * Math.cos(eye.elevation);
    // From afar it looks at the middle of the body, from near by at the contact point.
    const part = smooth(Math.min(Math.max((1 - eye.distance) / (1 - NEAR), 0), 1));
    const x = this.focus.x + part * (this.aimed.x - this.focus.x);
    const y = this.focus.y + part * (this.aimed.y - this.focus.y);
    const z = (1 - part) * height * Math.cos(eye.elevation);
    camera.position.set(
      x + flat * Math.cos(eye.azimuth),
      y + flat * Math.sin(eye.azimuth),
      z + distance * Math.sin(eye.elevation),
    );
    camera.lookAt(x, y, z);
  }

  private go(eye: Eye): void {
    this.way = undefined;
    this.eye = {
      azimuth: eye.azimuth,
      elevation: Math.min(Math.max(eye.elevation, LOWEST), HIGHEST),
      distance: Math.min(Math.max(eye.distance, 0.12), 3),
    };
  }

  /** Goes there smoothly, or at once for who would rather not see things move. */
  private glide(to: Eye): void {
    if (prefersReducedMotion()) return this.go(to);
    // The short way round.
    const round = 2 * Math.PI * Math.round((this.eye.azimuth - to.azimuth) / (2 * Math.PI));
    this.way = {
      from: this.eye,
      to: { ...to, azimuth: to.azimuth + round },
      begun: performance.now(),
    };
  }
}
