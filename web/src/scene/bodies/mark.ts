// A red mark on the body, on its side and on its top: it shows how far the body itself has turned while
// the contact point ran round.

import { Group, Mesh, MeshStandardMaterial, RingGeometry, Vector3 } from "three";
import type { Size } from "./shapes";
import { revolved } from "./revolved";

/** Where it is on the body, rad: toward the usual eye, if the body leans to the left of it. */
const PLACE = -1.2;
/** To both sides of there, rad. */
const WIDE = 0.075;

export const MARK_COLOUR = "#e4572e";

/** `inner`: the radius of what is hollow, m. */
export function markOn(size: Size, inner = 0): Group {
  const { widest, length } = size;
  const [low, high] = heights(size);
  // Over whatever is printed there.
  const out = 1.006 * widest;
  const look = new MeshStandardMaterial({ color: MARK_COLOUR, roughness: 0.5 });
  const [from, sweep] = [PLACE - WIDE, 2 * WIDE];
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

/** In the middle of the mark, on the body that stands upright with its base at the origin. */
export function markPlace(size: Size): Vector3 {
  const [low, high] = heights(size);
  const { widest } = size;
  return new Vector3(widest * Math.cos(PLACE), widest * Math.sin(PLACE), (low + high) / 2);
}

/** Which way the mark faces, on the body. */
export const MARK_FACES = new Vector3(Math.cos(PLACE), Math.sin(PLACE), 0);

/** From where to where it is on the side of the body, m: at the bottom, but not on what is narrower. */
function heights(size: Size): [low: number, high: number] {
  const { rim, widest, length } = size;
  const low = Math.min(1.8 * (widest - rim), 0.2 * length);
  return [low, isFlat(size) ? length : low + 0.22 * length];
}

const isFlat = ({ widest, length }: Size) => length < widest;
