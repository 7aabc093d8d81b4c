// The contact point: a bright dot as large on the screen at any distance, seen faintly through the
// body.

import { CircleGeometry, Group, Mesh, MeshBasicMaterial } from "three";
import { PIXEL } from "./ribbon";

export class Contact {
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
    const disc = (size: number, material: MeshBasicMaterial, order: number) => {
      const mesh = new Mesh(new CircleGeometry(size, 32), material);
      mesh.renderOrder = order;
      this.group.add(mesh);
    };
    // Pixels.
    disc(7.5, this.halo, 4);
    disc(5.5, this.core, 5);
    disc(4.5, this.ghost, 6);
  }

  /** At a spot of the table, facing an eye at a distance; `near` if no body is before it. */
  show(x: number, y: number, color: string, distance: number, near: boolean): void {
    this.core.depthTest = this.halo.depthTest = !near;
    this.group.position.set(x, y, 0.004);
    this.group.scale.setScalar(PIXEL.value * distance);
    this.core.color.set(color);
    this.ghost.color.set(color);
  }
}
