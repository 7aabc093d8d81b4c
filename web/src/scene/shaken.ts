// A table that is shaken: a slab with edges, over the floor of a room that stands still. In the picture the table is
// the frame of reference, so that the room and the camera move.

import {
  BoxGeometry,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  type PerspectiveCamera,
  type Texture,
} from "three";
import type { Displacement, InPicture } from "../floor/shaking";
import type { Motion } from "../core/motion";
import type { Palette } from "./palette";
import { Table } from "./table";

/** Half a side of the slab, its thickness and its height above the room's floor, in radii of the circle of degrees. */
const [HALF, THICK, HEIGHT] = [1.7, 0.09, 0.2];

export class ShakenTable {
  private readonly room = new Table();
  private readonly slab = new Mesh(
    new BoxGeometry(2, 2, THICK).translate(0, 0, -THICK / 2 - 0.002),
    new MeshStandardMaterial({ roughness: 0.8 }),
  );
  private readonly meshes = [this.room.mesh, this.slab];

  constructor(
    private readonly table: Table,
    place: Object3D,
  ) {
    place.add(...this.meshes);
    this.room.mesh.renderOrder = -20;
    this.hide();
  }

  setEnvironment(room: Texture | null): void {
    this.room.setEnvironment(room);
  }

  setCell(cell: number): void {
    this.room.setCell(cell);
  }

  paint(palette: Palette): void {
    this.room.paint(palette, palette.room);
    this.slab.material.color.set(palette.table);
  }

  hide(): void {
    for (const mesh of this.meshes) mesh.visible = false;
    this.table.cut();
  }

  /** Makes a slab that holds all of a motion; lengths are multiplied by `scale`. */
  hold(motion: Motion, scale: number): void {
    const curve = motion.curve();
    const far = [curve.column("x"), curve.column("y")].map((places) =>
      places.reduce((most, place) => Math.max(most, Math.abs(place)), 0),
    );
    const half = Math.max(HALF, Math.max(...far) * scale + 1);
    this.slab.scale.set(half, half, 1);
    this.table.cut(half);
    for (const mesh of this.meshes) mesh.visible = true;
  }

  /** Places the room's floor under the focus of the camera, and moves the camera; lengths are multiplied by `scale`. */
  place(
    { table, camera: followed }: InPicture,
    focus: { x: number; y: number },
    camera: PerspectiveCamera,
    scale: number,
  ): void {
    const all = (axis: keyof Displacement) => scale * (table[axis] + followed[axis]);
    camera.position.x -= scale * table.x;
    camera.position.y -= scale * table.y;
    camera.position.z -= scale * table.z;
    this.room.follow(focus.x, focus.y, -HEIGHT - all("z"));
    this.room.slide(-all("x"), -all("y"));
  }
}
