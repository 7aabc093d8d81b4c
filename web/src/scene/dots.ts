// The directions of many flicks as dots on a ring, stacked outward. A filled dot fell to the left of the
// hand, a hollow one to the right; a small dot had another outcome.

import { CircleGeometry, Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial } from "three";
import type { Flick } from "../falls/flicks";
import type { Instant, Layer } from "./instant";
import type { Palette } from "./palette";
import { Ribbon } from "./ribbon";
import { type Limit, limitStrokes } from "./turn";

/** Radius of the ring, radius of a dot and height of the highest stack, in radii of the circle of degrees. */
const [RING, DOT, HIGHEST] = [1.07, 0.02, 0.4];
/** Inner radius of a hollow dot and radius of a small one, in radii of a dot. */
const [HOLLOW, OTHER] = [0.62, 0.6];

export class Dots implements Layer {
  readonly group = new Group();
  private readonly ring = new Ribbon(1.5, 0.5);
  private readonly marks = new Ribbon(2.5);
  /** The dots, and inside each a smaller one of the same colour or of the background. */
  private meshes: InstancedMesh[] = [];
  private palette: Palette | undefined;
  private laid: readonly Flick[] | undefined;

  constructor() {
    this.group.position.z = 0.003;
    this.ring.mesh.renderOrder = this.marks.mesh.renderOrder = -2;
    this.group.add(this.ring.mesh, this.marks.mesh);
  }

  paint(palette: Palette): void {
    this.palette = palette;
    this.laid = undefined;
  }

  update({ lab, setup }: Instant): void {
    const { palette } = this;
    const flicks = lab.flicks.peek();
    if (palette && flicks !== this.laid) {
      this.laid = flicks;
      const theory = lab.theory.peek();
      const limits = theory && [
        { angle: theory.noSlip, color: palette.rolling, name: "" },
        { angle: theory.frictionless, color: palette.sliding, name: "" },
      ];
      this.lay(flicks, (setup.yaw * Math.PI) / 180 + Math.PI, limits ?? [], palette);
    }
    for (const mesh of this.meshes)
      mesh.count = Math.min(lab.flicksShown.peek() ?? 0, mesh.instanceMatrix.count);
  }

  /** Lays out a dot for each flick; `start` is the azimuth (rad) of the first lean. */
  private lay(
    flicks: readonly Flick[],
    start: number,
    limits: readonly Limit[],
    palette: Palette,
  ): void {
    for (const mesh of this.meshes) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
      (mesh.material as MeshBasicMaterial).dispose();
      mesh.dispose();
    }
    this.meshes = [];
    this.group.visible = flicks.length > 0;
    if (flicks.length === 0) return;
    this.group.rotation.z = start;
    this.layRing(limits, palette);
    const outer = disks(DOT, flicks.length, -1);
    const inner = disks(HOLLOW * DOT, flicks.length, 0);
    const [ink, hollow, other] = [palette.ink, palette.raised, palette.muted].map(
      (color) => new Color(color),
    ) as [Color, Color, Color];
    const matrix = new Matrix4();
    const under = stacks(flicks);
    // High stacks are compressed.
    const step = Math.min(2.1 * DOT, HIGHEST / Math.max(...under, 1));
    flicks.forEach(({ direction, outcome }, k) => {
      const far = RING + 1.2 * DOT + step * (under[k] as number);
      const fell = outcome === "toppled" || outcome === "rocked";
      const size = fell ? 1 : OTHER;
      matrix.makeScale(size, size, 1);
      matrix.setPosition(far * Math.cos(direction), far * Math.sin(direction), 0);
      outer.setMatrixAt(k, matrix);
      inner.setMatrixAt(k, matrix);
      outer.setColorAt(k, fell ? ink : other);
      inner.setColorAt(k, fell ? (direction > Math.PI ? ink : hollow) : other);
    });
    this.meshes = [outer, inner];
    this.group.add(outer, inner);
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

function disks(size: number, count: number, order: number): InstancedMesh {
  const material = new MeshBasicMaterial({
    toneMapped: false,
    transparent: true,
    depthWrite: false,
  });
  const mesh = new InstancedMesh(new CircleGeometry(size, 20), material, count);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

/** The number of dots under each dot: dots in the same small sector are stacked. */
function stacks(flicks: readonly Flick[]): number[] {
  const sector = (2.1 * DOT) / RING;
  const piled = new Map<number, number>();
  return flicks.map(({ direction }) => {
    const place = Math.floor(direction / sector);
    const under = piled.get(place) ?? 0;
    piled.set(place, under + 1);
    return under;
  });
}
