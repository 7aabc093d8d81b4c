// The contact point: a bright dot with a constant size on the screen, faintly visible through the body.

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
