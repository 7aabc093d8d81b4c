// The path of the contact point on the table up to the time shown, coloured by phase.

import { Color } from "three";
import type { Motion } from "../core/motion";
import type { Palette } from "./palette";
import type { Spot } from "./pose";
import { Ribbon } from "./ribbon";

const at = (array: Float64Array, index: number) => array[index] as number;

export class Trail {
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
