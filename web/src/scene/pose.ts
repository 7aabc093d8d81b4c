// The pose of the body on the table, from the angles of the mechanics to the matrix of the picture.

import type { Matrix4 } from "three";
import type { Event, Moment, Motion, Turn } from "../core/motion";
import type { TurnProgress } from "../lab";

/** Angles in rad, and the centre of the base, m. */
export interface Pose {
  tilt: number;
  yaw: number;
  spin: number;
  x: number;
  y: number;
  z: number;
}

/** A spot on the table, m. */
export interface Spot {
  x: number;
  y: number;
}

/** The radius of the rim and the height of the centre of mass, m. */
export interface Rim {
  radius: number;
  height: number;
}

/** The matrix that places a body whose axis is z and whose base is at z = 0. */
export function setPose(matrix: Matrix4, { tilt, yaw, spin, x, y, z }: Pose): Matrix4 {
  const [ct, st, cy, sy] = [Math.cos(tilt), Math.sin(tilt), Math.cos(yaw), Math.sin(yaw)];
  const [cs, ss] = [Math.cos(spin), Math.sin(spin)];
  // The columns are the body's axes after yaw, tilt (about −y) and spin.
  const [ax, ay, az] = [ct * cy, ct * sy, st];
  const [bx, by] = [-sy, cy];
  return matrix.set(
    ...[cs * ax + ss * bx, cs * bx - ss * ax, -st * cy, x],
    ...[cs * ay + ss * by, cs * by - ss * ay, -st * sy, y],
    ...[cs * az, -ss * az, ct, z],
    ...[0, 0, 0, 1],
  );
}

/** The pose at a moment of a motion. */
export function poseOf(moment: Moment, height: number, shift: Spot): Pose {
  const { tilt, yaw, spin } = moment;
  const out = height * Math.sin(tilt);
  return {
    tilt,
    yaw,
    spin,
    x: moment.x + out * Math.cos(yaw) + shift.x,
    y: moment.y + out * Math.sin(yaw) + shift.y,
    z: moment.z - height * Math.cos(tilt),
  };
}

/** How the motion is placed on the drawn table.
 *
 * The mechanics starts with the centre of mass over the origin. In the picture the base comes down
 * round the origin, where the body stands when it is upright. */
export interface Footing {
  /** Offset of the motion, m. */
  shift: Spot;
  /** How a body slides while it is tipped: at 0 its contact point stays at rest, at 1 its centre of
   * mass stays over the origin, as on ice. */
  slide: number;
}

export function footingOf(motion: Motion, rim: Rim): Footing {
  const start = motion.at([0]).moment(0);
  const slide = slideOf(motion, rim, start);
  const contact = heldContact(rim, start.tilt, start.yaw, slide);
  return { shift: { x: contact.x - start.contact_x, y: contact.y - start.contact_y }, slide };
}

function slideOf(motion: Motion, rim: Rim, start: Moment): number {
  const turn = motion.turns[0];
  if (!turn) return 0;
  const flat = poseOf(motion.at([turn.t]).moment(0), rim.height, { x: 0, y: 0 });
  const [c, s] = [Math.cos(start.yaw), Math.sin(start.yaw)];
  const along = (start.contact_x - flat.x) * c + (start.contact_y - flat.y) * s;
  const range = rim.radius - overhang(rim, start.tilt);
  return range > 1e-9 ? Math.min(Math.max((along + rim.radius) / range, 0), 1) : 0;
}

/** The centre of the base at the smallest tilt of a turn, about which the contact point runs. */
export function standingSpot(
  motion: Motion,
  { start, turn }: TurnProgress,
  rim: Rim,
  { shift }: Footing,
): Spot {
  const lowest = lowestOf(motion, start, turn)?.t;
  const moment = motion.at([lowest ?? start]).moment(0);
  if (lowest !== undefined) return poseOf(moment, rim.height, shift);
  return {
    x: moment.contact_x + rim.radius * Math.cos(moment.yaw) + shift.x,
    y: moment.contact_y + rim.radius * Math.sin(moment.yaw) + shift.y,
  };
}

/** The smallest tilt of a turn, complete or not, and its time. */
export function lowestOf(
  motion: Motion | undefined,
  start: number,
  turn: Turn | undefined,
): { t: number; tilt: number } | undefined {
  if (turn) return { t: turn.t, tilt: turn.minTilt };
  const isLowest = ({ kind, moment }: Event) => kind === "tilt_min" && moment.t >= start;
  return motion?.events.find(isLowest)?.moment;
}

/** Horizontal distance of the centre of mass from the contact point, m. */
const overhang = ({ radius, height }: Rim, tilt: number) =>
  radius * Math.cos(tilt) - height * Math.sin(tilt);

/** The contact point of a held body. */
export function heldContact(rim: Rim, tilt: number, yaw: number, slide: number): Spot {
  const out = -rim.radius + slide * (rim.radius - overhang(rim, tilt));
  return { x: out * Math.cos(yaw), y: out * Math.sin(yaw) };
}

/** The pose of a held body. */
export function heldPose(rim: Rim, tilt: number, yaw: number, slide: number): Pose {
  const { x, y } = heldContact(rim, tilt, yaw, slide);
  const out = rim.radius * Math.cos(tilt);
  return {
    tilt,
    yaw,
    spin: 0,
    x: x + out * Math.cos(yaw),
    y: y + out * Math.sin(yaw),
    z: rim.radius * Math.sin(tilt),
  };
}
