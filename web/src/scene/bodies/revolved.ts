// Surfaces of revolution about z from an outline, smooth at small bends and with an edge at large ones.

import { BufferGeometry, Float32BufferAttribute } from "three";

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
