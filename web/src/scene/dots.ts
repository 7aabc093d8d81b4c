// Where each of many flicks fell: dots on a ring, stacked outward where they are many.

import { CircleGeometry, Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial } from "three";
import type { Flicked } from "../falls/flicked";
import type { Palette } from "./palette";
import { Ribbon } from "./ribbon";
import { type Limit, limitStrokes } from "./wedge";

/** In radii of the circle of degrees. */
const [RING, DOT, HIGHEST] = [1.07, 0.02, 0.4];

export class Dots {
  readonly group = new Group();
  private readonly ring = new Ribbon(1.5, 0.5);
  private readonly marks = new Ribbon(2.5);
  private mesh: InstancedMesh | undefined;

  constructor() {
    this.group.position.z = 0.003;
    this.ring.mesh.renderOrder = this.marks.mesh.renderOrder = -2;
    this.group.add(this.ring.mesh, this.marks.mesh);
  }

  /** Lays out a dot for each flick; `start` is the azimuth (rad) of the first lean. */
  lay(flicks: readonly Flicked[], start: number, limits: readonly Limit[], palette: Palette): void {
    if (this.mesh) {
      this.group.remove(this.mesh);
      this.mesh.geometry.dispose();
      (this.mesh.material as MeshBasicMaterial).dispose();
      this.mesh.dispose();
      this.mesh = undefined;
    }
    this.group.visible = flicks.length > 0;
    if (flicks.length === 0) return;
    this.group.rotation.z = start;
    this.layRing(limits, palette);
    const mesh = new InstancedMesh(
      new CircleGeometry(DOT, 20),
      new MeshBasicMaterial({ toneMapped: false, transparent: true, depthWrite: false }),
      flicks.length,
    );
    mesh.frustumCulled = false;
    mesh.renderOrder = -1;
    const [left, right, other] = [palette.left, palette.right, palette.muted].map(
      (color) => new Color(color),
    ) as [Color, Color, Color];
    const matrix = new Matrix4();
    const under = piles(flicks);
    // High piles are pressed together.
    const step = Math.min(2.1 * DOT, HIGHEST / Math.max(...under, 1));
    flicks.forEach(({ direction, outcome }, k) => {
      const far = RING + 1.2 * DOT + step * (under[k] as number);
      const fell = outcome === "toppled" || outcome === "rocked";
      mesh.setColorAt(k, fell ? (direction > Math.PI ? left : right) : other);
      mesh.setMatrixAt(
        k,
        matrix.makeTranslation(far * Math.cos(direction), far * Math.sin(direction), 0),
      );
    });
    this.mesh = mesh;
    this.group.add(mesh);
  }

  /** Shows those that have been made. */
  show(made: number): void {
    if (this.mesh) this.mesh.count = Math.min(made, this.mesh.instanceMatrix.count);
  }

  private layRing(limits: readonly Limit[], { muted }: Palette): void {
    const count = 181;
    const angle = (k: number) => (2 * Math.PI * k) / (count - 1);
    const around = (of: (a: number) => number) =>
      Float64Array.from({ length: count }, (_, k) => RING * of(angle(k)));
    const grey = new Color(muted);
    this.ring.lay(count, around(Math.cos), around(Math.sin), () => grey);
    this.marks.layStrokes(limitStrokes(limits, 0.985 * RING, 1.1 * RING));
  }
}

/** How many dots lie under each: in each small sector the next lies on those before. */
function piles(flicks: readonly Flicked[]): number[] {
  const sector = (2.1 * DOT) / RING;
  const piled = new Map<number, number>();
  return flicks.map(({ direction }) => {
    const place = Math.floor(direction / sector);
    const under = piled.get(place) ?? 0;
    piled.set(place, under + 1);
    return under;
  });
}
