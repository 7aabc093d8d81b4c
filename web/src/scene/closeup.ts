// The near-collision close up. Marks stay at material points of the rim, posts under them show the gap
// between rim and table, magnified, and strips show the rim and the table unrolled. It is loaded when the
// camera first goes to the contact point or below the table.

import {
  BoxGeometry,
  CircleGeometry,
  Color,
  DoubleSide,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";
import type { Lab, TurnProgress } from "../lab";
import { MARK_COLOUR, MARK_PLACE } from "./bodies/mark";
import { MARKS, fadeOf, gapOf, magnification } from "./gap";
import type { Palette } from "./palette";
import type { Pose } from "./pose";
import { formatSmall } from "./lengths";
import { Unrolled } from "./unrolled";
import { formatNumber } from "../format/numbers";
import { say, words } from "../words/words";

/** Radius of a mark and half the width of a post, in radii of the rim. */
const [MARK, POST] = [0.028, 0.011];
const SPACING = (2 * Math.PI) / MARKS;

/** What the closeup draws, in m and rad. */
export interface Near {
  pose: Pose;
  /** Radius of the rim. */
  radius: number;
  /** Smallest tilt of the turn that is shown; undefined if it has none. */
  minTilt: number | undefined;
  /** The pose as a matrix of the stage, and units of the stage per metre. */
  placed: Matrix4;
  scale: number;
}

/** A label at the highest point of the magnified rim. */
export interface GapLabel {
  text: string;
  spot: Vector3;
}

export class Closeup {
  readonly group = new Group();
  readonly unrolled: Unrolled;
  private readonly marks = new InstancedMesh(
    new SphereGeometry(1, 12, 8),
    new MeshBasicMaterial({ toneMapped: false }),
    MARKS,
  );
  private readonly posts = new InstancedMesh(
    new BoxGeometry(2, 2, 1).translate(0, 0, 0.5),
    flat(1),
    MARKS,
  );
  private readonly rim = new Mesh(new TorusGeometry(1, 0.011, 8, 144), flat(1));
  private readonly base = new Mesh(new CircleGeometry(1, 96), flat(0.16));
  private readonly magnified = new Group();
  private readonly label: GapLabel = { text: "", spot: new Vector3() };
  private readonly matrix = new Matrix4();
  private readonly spot = new Vector3();

  constructor(lab: Lab, stage: HTMLElement) {
    this.unrolled = new Unrolled(lab);
    stage.append(this.unrolled.element);
    for (const mesh of [this.rim, this.base]) mesh.matrixAutoUpdate = false;
    for (const mesh of [this.marks, this.posts, this.rim, this.base]) mesh.frustumCulled = false;
    [this.base.renderOrder, this.posts.renderOrder, this.rim.renderOrder] = [7, 8, 9];
    this.magnified.add(this.base, this.posts, this.rim);
    this.group.add(this.marks, this.magnified);
    this.hide();
  }

  paint({ ink, rolling, raised }: Palette): void {
    const [mark, plain, even] = [MARK_COLOUR, rolling, raised].map((color) => new Color(color));
    for (let k = 0; k < MARKS; k++) {
      const color = k === 0 ? mark! : k % 2 ? plain! : even!;
      this.marks.setColorAt(k, color);
      this.posts.setColorAt(k, k === 0 ? mark! : plain!);
    }
    for (const mesh of [this.marks, this.posts]) mesh.instanceColor!.needsUpdate = true;
    this.rim.material.color.set(ink);
    this.base.material.color.set(rolling);
  }

  hide(): void {
    this.group.visible = this.unrolled.element.hidden = false;
    this.unrolled.element.hidden = true;
  }

  /** Places everything; returns a label, with an empty text where the gap is too wide to be magnified. */
  show(near: Near, progress: TurnProgress | undefined): Readonly<GapLabel> {
    const { pose, radius, placed, scale } = near;
    this.group.visible = true;
    this.unrolled.show(progress, radius);
    const times = magnification(near.minTilt, radius);
    const fade = fadeOf(times * gapOf(pose, radius), radius);
    this.magnified.visible = fade > 0;
    this.rim.material.opacity = this.posts.material.opacity = fade;
    this.base.material.opacity = 0.16 * fade;
    const size = radius * scale;
    for (let k = 0; k < MARKS; k++) {
      const angle = MARK_PLACE + k * SPACING;
      const { x, y, z } = this.spot
        .set(radius * Math.cos(angle), radius * Math.sin(angle), 0)
        .applyMatrix4(placed);
      const large = k === 0 ? 1.5 : 1;
      this.matrix.makeScale(large * MARK * size, large * MARK * size, large * MARK * size);
      this.marks.setMatrixAt(k, this.matrix.setPosition(x, y, z));
      this.matrix.makeScale(large * POST * size, large * POST * size, Math.max(times * z, 1e-4));
      this.posts.setMatrixAt(k, this.matrix.setPosition(x, y, 0));
    }
    this.marks.instanceMatrix.needsUpdate = this.posts.instanceMatrix.needsUpdate = true;
    this.stretch(placed, times, radius);
    const { x, y, z } = this.spot
      .set(Math.cos(pose.yaw), Math.sin(pose.yaw), 0)
      .multiplyScalar(size * Math.cos(pose.tilt));
    this.label.spot.set(
      pose.x * scale + x,
      pose.y * scale + y,
      z + times * gapOf(pose, radius) * scale + 0.14 * size,
    );
    this.label.text = fade > 0.5 ? labelOf(gapOf(pose, radius), times) : "";
    return this.label;
  }

  /** Stretches the heights of the rim and the base over the table. */
  private stretch(placed: Matrix4, times: number, radius: number): void {
    const { matrix } = this.rim;
    matrix.makeScale(1, 1, times).multiply(placed);
    // The rim is not thicker for that.
    const { elements } = matrix;
    const thick = Math.hypot(placed.elements[0]!, placed.elements[1]!, placed.elements[2]!);
    [elements[8], elements[9], elements[10]] = [0, 0, thick];
    matrix.scale(this.spot.setScalar(radius));
    this.base.matrix.copy(matrix);
    this.rim.matrixWorldNeedsUpdate = this.base.matrixWorldNeedsUpdate = true;
  }
}

const labelOf = (gap: number, times: number) =>
  times > 1
    ? say(words.scene.gapDrawn, { gap: formatSmall(gap), times: formatNumber(times) })
    : say(words.scene.gap, { gap: formatSmall(gap) });

const flat = (opacity: number) =>
  new MeshBasicMaterial({
    toneMapped: false,
    transparent: true,
    opacity,
    depthWrite: false,
    side: DoubleSide,
  });
