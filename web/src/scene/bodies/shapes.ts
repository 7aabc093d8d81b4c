// Shapes of the bodies: their sizes, surfaces of revolution, the visitor's own body, and the mark on the rim.

import type { Setup } from "../../setup/setup";
import { RING_RADIUS } from "../../setup/simulation_input";
import {
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  RingGeometry,
  Vector3,
} from "three";

/** m */
export interface Size {
  /** radius of the rim on which the body stands */
  rim: number;
  /** radius of the widest part */
  widest: number;
  length: number;
}

export function sizeOf(setup: Readonly<Setup>): Size {
  switch (setup.body) {
    case "can_2007":
      return { rim: 0.051, widest: 0.051, length: 0.138 };
    case "soda_can":
      return { rim: 0.024, widest: 0.033, length: 0.115 };
    case "beer_bottle":
      return { rim: 0.026, widest: 0.0305, length: 0.23 };
    case "coin":
      return { rim: 0.5 * 23.25e-3, widest: 0.5 * 23.25e-3, length: 2.33e-3 };
    case "ring":
      return { rim: RING_RADIUS, widest: RING_RADIUS, length: 0.12 * RING_RADIUS };
    case "battery":
      return { rim: 7.25e-3, widest: 7.25e-3, length: 50.5e-3 };
    case "euler_disk":
      return { rim: 0.0375, widest: 0.0375, length: 12.7e-3 };
    case "own": {
      const [radius, length] = [setup.radius / 100, setup.length / 100];
      return { rim: radius, widest: radius, length: Math.max(length, 0.03 * radius) };
    }
    case "inertia": {
      // As long as if the centre of mass were in the middle.
      const [radius, length] = [setup.radius / 100, (2 * setup.height) / 100];
      return { rim: radius, widest: radius, length: Math.max(length, 0.03 * radius) };
    }
  }
}

/** Radius of the circle of degrees round a body, m, which is the unit of length of the scene. */
export const reachOf = ({ widest, length }: Size) =>
  Math.max(1.6 * widest, 0.95 * widest + 0.4 * length);

// Surfaces of revolution about z from an outline, smooth at small bends and with an edge at large ones.

/** Points (r, z) of an outline, m, in an order that has the outside on the right. */
export type Outline = readonly (readonly [r: number, z: number])[];

/** An outline that bends by less than this (rad) at a point is smooth there. */
const SMOOTH = 0.6;

/** In the texture coordinates, u runs round the axis and v along the outline. */
export function revolved(outline: Outline, sectors = 96, from = 0, sweep = 2 * Math.PI) {
  const points = outline.filter(
    (p, k) => k === 0 || Math.hypot(p[0] - outline[k - 1]![0], p[1] - outline[k - 1]![1]) > 1e-9,
  );
  const normals = points.slice(1).map((p, k) => {
    const [dr, dz] = [p[0] - points[k]![0], p[1] - points[k]![1]];
    const length = Math.hypot(dr, dz);
    return { r: dz / length, z: -dr / length, length };
  });
  const whole = normals.reduce((sum, n) => sum + n.length, 0);
  const [position, normal, uv, index]: number[][] = [[], [], [], []];
  let walked = 0;
  normals.forEach((own, k) => {
    const ends = [
      { p: points[k]!, n: mixed(own, normals[k - 1]), v: walked / whole },
      { p: points[k + 1]!, n: mixed(own, normals[k + 1]), v: (walked + own.length) / whole },
    ];
    walked += own.length;
    const first = position!.length / 3;
    for (let j = 0; j <= sectors; j++) {
      const angle = from + (sweep * j) / sectors;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      for (const { p, n, v } of ends) {
        position!.push(p[0] * c, p[0] * s, p[1]);
        normal!.push(n.r * c, n.r * s, n.z);
        uv!.push(j / sectors, v);
      }
      if (j === sectors) break;
      const a = first + 2 * j;
      index!.push(a, a + 2, a + 1, a + 1, a + 2, a + 3);
    }
  });
  return new BufferGeometry()
    .setAttribute("position", new Float32BufferAttribute(position!, 3))
    .setAttribute("normal", new Float32BufferAttribute(normal!, 3))
    .setAttribute("uv", new Float32BufferAttribute(uv!, 2))
    .setIndex(index!);
}

interface Normal {
  r: number;
  z: number;
}

/** The normal at the point where two segments of an outline meet. */
function mixed(own: Normal, other: Normal | undefined): Normal {
  if (!other || own.r * other.r + own.z * other.z < Math.cos(SMOOTH)) return own;
  const [r, z] = [own.r + other.r, own.z + other.z];
  const length = Math.hypot(r, z);
  return { r: r / length, z: z / length };
}

/** Points on an arc round (r, z) from one angle to another, both counted from the r axis. */
export function arc(r: number, z: number, size: number, from: number, to: number, count = 8) {
  return Array.from({ length: count + 1 }, (_, k): [number, number] => {
    const angle = from + ((to - from) * k) / count;
    return [r + size * Math.cos(angle), z + size * Math.sin(angle)];
  });
}

// The visitor's own body: base plate, wall and filling, with a sector cut out to show the inside; or a plain
// cylinder if only its inertia is known.

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

// A red mark on the side and the top of the body, which shows the rotation of the body itself.

/** Azimuth on the body, rad: visible in the initial view if the body leans to the left. */
export const MARK_PLACE = -1.2;
/** Half the width of the mark, rad. */
const HALF_WIDTH = 0.075;

export const MARK_COLOUR = "#e4572e";

/** `inner` is the inner radius of a hollow body, m. */
export function markOn(size: Size, inner = 0): Group {
  const { widest, length } = size;
  const [low, high] = heights(size);
  // Outside the print.
  const out = 1.006 * widest;
  const look = new MeshStandardMaterial({ color: MARK_COLOUR, roughness: 0.5 });
  const [from, sweep] = [MARK_PLACE - HALF_WIDTH, 2 * HALF_WIDTH];
  const outline = [
    [out, low],
    [out, high],
  ] as const;
  const side = new Mesh(revolved(outline, 12, from, sweep), look);
  const begins = Math.max(0.7 * widest, inner);
  const top = new Mesh(new RingGeometry(begins, widest, 12, 1, from, sweep), look);
  top.position.z = 1.004 * length;
  return isFlat(size) ? new Group().add(side, top) : new Group().add(side);
}

/** The middle of the mark on an upright body with its base at the origin. */
export function markPlace(size: Size): Vector3 {
  const [low, high] = heights(size);
  const { widest } = size;
  return new Vector3(
    widest * Math.cos(MARK_PLACE),
    widest * Math.sin(MARK_PLACE),
    (low + high) / 2,
  );
}

/** Direction in which the mark faces, on the body. */
export const MARK_FACES = new Vector3(Math.cos(MARK_PLACE), Math.sin(MARK_PLACE), 0);

/** Heights of the mark on the side of the body, m: at the bottom, above a narrower base. */
function heights(size: Size): [low: number, high: number] {
  const { rim, widest, length } = size;
  const low = Math.min(1.8 * (widest - rim), 0.2 * length);
  return [low, isFlat(size) ? length : low + 0.22 * length];
}

const isFlat = ({ widest, length }: Size) => length < widest;
