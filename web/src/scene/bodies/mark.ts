// A red mark on the side and the top of the body, which shows the rotation of the body itself.

import { Group, Mesh, MeshStandardMaterial, RingGeometry, Vector3 } from "three";
import type { Size } from "./shapes";
import { revolved } from "./revolved";

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
