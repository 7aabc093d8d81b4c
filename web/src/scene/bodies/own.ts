// The visitor's own body: base plate, wall and filling, with a sector cut out to show the inside; or a plain
// cylinder if only its inertia is known.

import {
  Color,
  Group,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  type BufferGeometry,
  DoubleSide,
} from "three";
import type { Setup } from "../../setup/setup";
import { type Outline, revolved } from "./revolved";
import type { Size } from "./shapes";

/** Angle of the sector that is cut out, rad. */
const CUT = 1.45;

export function ownBody(setup: Readonly<Setup>, { rim, length }: Size): Group {
  const inBase = setup.base / 100;
  const inWall = (setup.wall / 100) * (1 - inBase);
  const inside = 1 - inBase - inWall;
  // The drawn thickness indicates the mass; in the mechanics the plate and the wall are thin.
  const plate = Math.min((0.02 + 0.16 * inBase) * length + 0.01 * rim, length);
  const wall = rim * (inWall > 0 ? 0.03 + 0.13 * inWall : 0);
  const body = new Group();
  body.add(new Mesh(revolved(block(0, rim, 0, plate)), look("#37506b", 0.55)));
  if (plate >= length) return body;
  const red = look("#c8553d", 0.5);
  if (wall > 0) addCut(body, rim - wall, rim, plate, length, look("#e3b04b", 0.45), red);
  if (inside > 0.001) {
    const paleness = 1 - Math.min(inside * 1.2, 1);
    const stuff = look("#6f8f72", 0.8);
    stuff.color.lerp(new Color("#e8efe4"), paleness);
    addCut(body, 0, rim - wall, plate, length - (wall > 0 ? 0.03 * length : 0), stuff, stuff);
  }
  return body;
}

/** A body of which only the mass and the inertia are known. */
export const plainBody = ({ rim, length }: Size): Group =>
  new Group().add(new Mesh(revolved(block(0, rim, 0, length)), look("#37506b", 0.55)));

const look = (color: string, roughness: number) =>
  new MeshStandardMaterial({ color, roughness, side: DoubleSide });

/** The outline of a block between two radii and two heights. */
const block = (inner: number, outer: number, low: number, high: number): Outline => [
  ...(inner > 0 ? ([[inner, high]] as Outline) : []),
  [inner, low],
  [outer, low],
  [outer, high],
  [inner, high],
];

function addCut(
  body: Group,
  inner: number,
  outer: number,
  low: number,
  high: number,
  outside: MeshStandardMaterial,
  section: MeshStandardMaterial,
): void {
  body.add(
    new Mesh(revolved(block(inner, outer, low, high), 80, CUT / 2, 2 * Math.PI - CUT), outside),
  );
  for (const angle of [CUT / 2, -CUT / 2]) {
    const geometry: BufferGeometry = new PlaneGeometry(outer - inner, high - low);
    const flat = new Mesh(geometry, section);
    flat.rotation.set(Math.PI / 2, 0, angle, "ZYX");
    const middle = (outer + inner) / 2;
    flat.position.set(middle * Math.cos(angle), middle * Math.sin(angle), (low + high) / 2);
    body.add(flat);
  }
}
