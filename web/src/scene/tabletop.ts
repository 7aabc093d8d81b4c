// The table and the ruler on it. A table that is shaken is loaded when the floor first moves.

import { Group, type Scene } from "three";
import type { InPicture } from "../floor/shaking";
import { prefersReducedMotion } from "../timing";
import type { Motion } from "../core/motion";
import type { Instant, Layer } from "./instant";
import { powerOfTen, Ruler } from "./measures";
import type { Palette } from "./palette";
import type { ShakenTable } from "./shaken";
import { Table } from "./table";
import type { View } from "./view";

/** How far a shaken table may be from the middle of the picture, in radii of the circle of degrees. */
const LEASH = 0.6;

/** Side of a square of the grid on the table, m. */
export const cellOf = (reach: number): number => powerOfTen(reach / 2.5);

export class Tabletop implements Layer {
  readonly group = new Group();
  private readonly table = new Table();
  private readonly ruler = new Ruler();
  private shaken: ShakenTable | undefined;
  private followed: Motion | undefined;

  /** `loaded` is called when a table that is shaken is there. */
  constructor(
    private readonly scene: Scene,
    private readonly view: View,
    private readonly loaded: () => void,
  ) {
    this.group.add(this.table.mesh, this.ruler.group);
  }

  paint(palette: Palette): void {
    for (const one of [this.table, this.shaken]) {
      one?.setEnvironment(this.scene.environment);
      one?.paint(palette);
    }
    this.ruler.paint(palette);
    this.followed = undefined;
  }

  update(instant: Instant): void {
    const { camera, reach } = instant;
    const { focus } = this.view;
    for (const one of [this.table, this.shaken]) one?.setCell(cellOf(reach) / reach);
    this.ruler.measure(reach);
    this.hold(instant);
    this.table.follow(focus.x, focus.y);
    this.shaken?.place(placeOf(instant), focus, camera, 1 / reach);
    const below = camera.position.z < 0;
    this.table.setGlass(below);
    this.ruler.group.visible = !below && !instant.seeThrough;
  }

  /** Shows the edges of a table that is shaken. */
  private hold({ simulated, reach }: Instant): void {
    if (simulated && simulated.motion === this.followed) return;
    this.followed = simulated?.motion;
    if (!simulated?.input.shaking) return this.shaken?.hide();
    if (this.shaken) return this.shaken.hold(simulated.motion, 1 / reach);
    import("./shaken").then(({ ShakenTable }) => {
      this.shaken ??= new ShakenTable(this.table, this.group);
      this.loaded();
    }, console.error);
  }
}

function placeOf({ lab, reach }: Instant): InPicture {
  const still = { x: 0, y: 0, z: 0 };
  const held = lab.tableHeld.peek();
  if (held) return { table: held, camera: still };
  const shaking = lab.held.peek() ? undefined : lab.shaking.peek();
  if (!shaking || prefersReducedMotion()) return { table: still, camera: still };
  return shaking.inPicture(lab.clock.time.peek(), LEASH * reach);
}
