// The body in the picture, the space that it takes, and the ambient shadow close under it.

import {
  type Camera,
  CanvasTexture,
  CylinderGeometry,
  Group,
  type Intersection,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Raycaster,
  type Vector2,
} from "three";
import { dispose, pictureOf, setSeeThrough } from "./bodies/bodies";
import type { Instant, Layer } from "./instant";
import { Outline } from "./labels";
import type { Palette } from "./palette";

export class BodyLayer implements Layer {
  readonly group = new Group();
  private readonly shade = new Shade();
  private body = new Group();
  private look = "";
  /** A cylinder round the body, for hits of the pointer. */
  private readonly hull = new Mesh(new CylinderGeometry(1, 1, 1, 24).rotateX(Math.PI / 2));
  private readonly outline = new Outline();
  private readonly caster = new Raycaster();
  private readonly matrix = new Matrix4();

  constructor() {
    this.hull.matrixAutoUpdate = false;
    this.group.add(this.shade.mesh);
  }

  paint(palette: Palette): void {
    this.shade.paint(palette);
  }

  update(instant: Instant): void {
    if (instant.look !== this.look) this.build(instant);
    const { pose, placed, reach, rim, size } = instant;
    this.body.matrix.copy(placed);
    this.body.matrixWorldNeedsUpdate = true;
    this.shade.mesh.visible = !instant.seeThrough;
    this.shade.show(pose.x / reach, pose.y / reach, rim.radius / reach, pose.tilt);
    const high = Math.max(size.length, 0.2 * size.widest);
    this.hull.matrixWorld
      .copy(placed)
      .multiply(this.matrix.makeTranslation(0, 0, high / 2))
      .multiply(this.matrix.makeScale(1.05 * size.widest, 1.05 * size.widest, high));
  }

  /** Where a pointer hits the body, if it does; 1 is the distance from the middle of the picture to its edge. */
  hitAt(pointed: Vector2, camera: Camera): Intersection | undefined {
    this.caster.setFromCamera(pointed, camera);
    return this.caster.intersectObject(this.hull, false)[0];
  }

  /** Whether the body hides a spot of the table from a camera. */
  hides(x: number, y: number, { position }: Camera): boolean {
    const { ray } = this.caster;
    ray.origin.copy(position);
    ray.direction.set(x, y, 0).sub(position).normalize();
    return this.caster.intersectObject(this.hull, false).length > 0;
  }

  /** Its extent in a camera's picture with a size in px. */
  outlineIn(camera: Camera, { width, height }: { width: number; height: number }): Outline {
    this.outline.project(this.hull.matrixWorld, camera, width, height);
    return this.outline;
  }

  private build({ look, setup, seeThrough }: Instant): void {
    this.look = look;
    dispose(this.body);
    this.group.remove(this.body);
    this.body = pictureOf(setup);
    this.body.matrixAutoUpdate = false;
    this.group.add(this.body);
    setSeeThrough(this.body, seeThrough);
  }
}

export class Shade {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private darkest = 0.5;

  constructor() {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 128;
    const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
    const fade = pen.createRadialGradient(64, 64, 0, 64, 64, 64);
    for (const [at, alpha] of [
      [0, 1],
      [0.6, 0.9],
      [0.72, 0.5],
      [0.85, 0.16],
      [1, 0],
    ] as const)
      fade.addColorStop(at, `rgb(0 0 0 / ${alpha})`);
    pen.fillStyle = fade;
    pen.fillRect(0, 0, 128, 128);
    const material = new MeshBasicMaterial({
      map: new CanvasTexture(canvas),
      color: "#000000",
      transparent: true,
      depthWrite: false,
    });
    this.mesh = new Mesh(new PlaneGeometry(2.8, 2.8), material);
    this.mesh.position.z = 0.0003;
    this.mesh.renderOrder = -8;
  }

  paint({ dark }: Palette): void {
    this.darkest = dark ? 0.6 : 0.42;
  }

  /** Shows the shadow under a base with a radius; it is paler at larger tilts. */
  show(x: number, y: number, radius: number, tilt: number): void {
    this.mesh.position.set(x, y, this.mesh.position.z);
    this.mesh.scale.setScalar(radius);
    this.mesh.material.opacity =
      this.darkest * (1 - 0.75 * Math.min(Math.abs(Math.sin(tilt)) * 2, 1));
  }
}
