// The contact point on the table: its path up to the time shown, the point itself, and the velocity with which it slips.

import { CircleGeometry, Color, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";
import type { Moment, Motion } from "../core/motion";
import type { Instant, Layer } from "./instant";
import type { Palette } from "./palette";
import type { Spot } from "./pose";
import { PIXEL, Ribbon } from "./ribbon";

export class PathLayer implements Layer {
  readonly group = new Group();
  private readonly trail = new Trail();
  private readonly contact = new Contact();
  private readonly slip = new Slip();
  private palette: Palette | undefined;
  private followed: Motion | undefined;
  private readonly spot = new Vector3();

  constructor() {
    this.group.add(this.trail.mesh, this.slip.mesh, this.contact.group);
  }

  paint(palette: Palette): void {
    this.palette = palette;
    this.slip.paint(palette);
    this.followed = undefined;
  }

  update(instant: Instant): void {
    const { contact, moment, reach, simulated } = instant;
    if (!this.palette) return;
    if (simulated && simulated.motion !== this.followed) {
      this.followed = simulated.motion;
      const { shift } = instant.footing;
      this.trail.follow(simulated.motion, shift, reach / 2500, 1 / reach, this.palette);
    }
    this.showTrail(instant);
    this.spot.set(contact.x / reach, contact.y / reach, 0);
    // √(gR)
    const { gravity } = simulated?.input.options ?? { gravity: 1 };
    this.slip.show(this.spot, moment, Math.sqrt(gravity * instant.rim.radius));
    this.showContact(instant, this.palette);
  }

  private showTrail({ lab, progress, simulated }: Instant): void {
    this.trail.mesh.visible = simulated !== undefined && progress !== undefined;
    if (!simulated || !progress) return;
    const before = simulated.motion.turns.findLast((turn) => turn.end <= progress.start);
    this.trail.show(lab.clock.time.peek(), progress.start, before?.start ?? 0);
  }

  private showContact(instant: Instant, palette: Palette): void {
    const { camera, contact, moment, pose, rim, simulated } = instant;
    const { position, quaternion } = camera;
    const phases = moment && simulated?.motion.phases;
    const kind = phases?.findLast(({ start }) => start <= (moment?.t ?? 0))?.kind;
    const color = kind === "sliding" || kind === "flying" ? palette[kind] : palette.rolling;
    // The contact point is on the near side if the body leans toward the camera.
    const [ex, ey] = [position.x - this.spot.x, position.y - this.spot.y];
    const flat = Math.hypot(ex, ey);
    const toward = (contact.x - pose.x) * ex + (contact.y - pose.y) * ey;
    const before = toward > -0.3 * rim.radius * flat && position.z < 3 * flat;
    const near = before || position.z < 0 || instant.seeThrough;
    this.contact.group.quaternion.copy(quaternion);
    const isLevel = kind === "standing" || kind === "sliding_flat" || kind === "flying_level";
    this.contact.group.visible = !isLevel;
    this.contact.show(this.spot.x, this.spot.y, color, position.distanceTo(this.spot), near);
  }
}

const at = (array: Float64Array, index: number) => array[index] as number;

class Trail {
  private readonly ribbon = new Ribbon(3.4, 0.95);
  private times = new Float64Array(0);

  get mesh() {
    return this.ribbon.mesh;
  }

  constructor() {
    this.mesh.position.z = 0.0022;
    this.mesh.renderOrder = -2;
  }

  /** Draws the path of a motion; `fine` is the length of the shortest useful segment, m. */
  follow(motion: Motion, shift: Spot, fine: number, scale: number, palette: Palette): void {
    const samples = motion.curve();
    const [t, x, y] = [
      samples.column("t"),
      samples.column("contact_x"),
      samples.column("contact_y"),
    ];
    const paints: Record<string, Color> = {
      rolling: new Color(palette.rolling),
      sliding: new Color(palette.sliding),
      flying: new Color(palette.flying),
    };
    const kept = new Uint32Array(t.length);
    const phase = new Uint16Array(t.length);
    let [count, last, now] = [0, 0, 0];
    for (let k = 0; k < t.length; k++) {
      const before = now;
      while (now + 1 < motion.phases.length && at(t, k) >= (motion.phases[now]?.end ?? Infinity))
        now++;
      const moved = Math.hypot(at(x, k) - at(x, last), at(y, k) - at(y, last));
      if (k > 0 && k < t.length - 1 && moved < fine && now === before) continue;
      phase[count] = now;
      kept[count++] = last = k;
    }
    this.times = Float64Array.from({ length: count }, (_, k) => at(t, kept[k] as number));
    const [px, py] = [new Float64Array(count), new Float64Array(count)];
    for (let k = 0; k < count; k++) {
      px[k] = (at(x, kept[k] as number) + shift.x) * scale;
      py[k] = (at(y, kept[k] as number) + shift.y) * scale;
    }
    const other = paints.rolling as Color;
    this.ribbon.lay(count, px, py, (k) => {
      return paints[motion.phases[phase[k] as number]?.kind ?? ""] ?? other;
    });
  }

  /** Shows the path up to a time; the path before the current turn, and before the previous one, is paler. */
  show(time: number, turnStart: number, before: number): void {
    this.ribbon.show(this.place(time), this.place(turnStart) - 0.5, this.place(before) - 0.5);
  }

  /** The fractional index of a time among the points. */
  private place(time: number): number {
    const { times } = this;
    let [low, high] = [0, times.length - 1];
    if (high < 1 || time <= at(times, 0)) return 0;
    if (time >= at(times, high)) return high;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (at(times, middle) <= time) low = middle;
      else high = middle;
    }
    const width = at(times, high) - at(times, low);
    return low + (width > 0 ? (time - at(times, low)) / width : 0);
  }
}

// The contact point: a bright dot with a constant size on the screen, faintly visible through the body.

class Contact {
  readonly group = new Group();
  private readonly core = new MeshBasicMaterial({ toneMapped: false, transparent: true });
  private readonly halo = new MeshBasicMaterial({
    toneMapped: false,
    transparent: true,
    color: "#ffffff",
  });
  private readonly ghost = new MeshBasicMaterial({
    toneMapped: false,
    transparent: true,
    opacity: 0.5,
    depthTest: false,
    depthWrite: false,
  });

  constructor() {
    const disk = (size: number, material: MeshBasicMaterial, order: number) => {
      const mesh = new Mesh(new CircleGeometry(size, 32), material);
      mesh.renderOrder = order;
      this.group.add(mesh);
    };
    // Radii in pixels.
    disk(7.5, this.halo, 4);
    disk(5.5, this.core, 5);
    disk(4.5, this.ghost, 6);
  }

  /** Shows the dot at a spot of the table, at a distance from the camera; `near` if no body hides it. */
  show(x: number, y: number, color: string, distance: number, near: boolean): void {
    this.core.depthTest = this.halo.depthTest = !near;
    this.group.position.set(x, y, 0.004);
    this.group.scale.setScalar(PIXEL.value * distance);
    this.core.color.set(color);
    this.ghost.color.set(color);
  }
}

// The slip velocity, as an arrow from the contact point.

/** Length of the arrow at a speed of √(gR) and its largest length, in radii of the circle of degrees. */
const [LENGTH, LONGEST] = [0.5, 0.75];
/** Smallest speed with an arrow, over √(gR). */
const SLOWEST = 0.01;

class Slip {
  private readonly ribbon = new Ribbon(3.2);
  private color = "";

  get mesh() {
    return this.ribbon.mesh;
  }

  constructor() {
    this.mesh.position.z = 0.003;
    this.mesh.renderOrder = -1;
  }

  paint({ sliding }: Palette): void {
    this.color = sliding;
  }

  /** Draws the arrow from a spot of the stage; `unit` is √(gR), m/s. */
  show({ x, y }: Spot, moment: Moment | undefined, unit: number): void {
    const [vx, vy] = [moment?.slip_x ?? 0, moment?.slip_y ?? 0];
    const speed = Math.hypot(vx, vy) / unit;
    this.mesh.visible = speed > SLOWEST;
    if (!this.mesh.visible) return;
    const length = Math.min(LENGTH * speed, LONGEST);
    const [ex, ey] = [(vx / unit / speed) * length, (vy / unit / speed) * length];
    const to = [x + ex, y + ey] as const;
    const barb = (side: number) =>
      [to[0] - 0.22 * ex - side * 0.12 * ey, to[1] - 0.22 * ey + side * 0.12 * ex] as const;
    const { color } = this;
    this.ribbon.layStrokes([
      { from: [x, y], to, color },
      { from: to, to: barb(1), color },
      { from: to, to: barb(-1), color },
    ]);
  }
}
