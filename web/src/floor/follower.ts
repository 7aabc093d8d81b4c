// A camera that follows a table that moves away. Until then it stands still, and the table moves in the picture.

import type { Displacement, InPicture, TableMotion } from "./shaking";

/** Places of the table that are computed at once. */
const PLACES = 2000;

/** Where table and camera are at a time (s) of a motion with a duration (s). The camera is drawn along when the
 * table is farther than `leash` (m) from the middle. */
export function follower(
  tableAt: (times: ArrayLike<number>) => TableMotion,
  duration: number,
  leash: number,
): (time: number) => InPicture {
  const step = duration / PLACES;
  const times = Float64Array.from({ length: PLACES + 1 }, (_, k) => k * step);
  const table = tableAt(times);
  const [x, y, z] = [
    table.ground_displacement_x,
    table.ground_displacement_y,
    table.ground_displacement_z,
  ];
  const camera = { x: 0, y: 0, z: 0 };
  const places = Array.from(times, (_, k): InPicture => {
    const [dx, dy, dz] = [x[k], y[k], z[k]] as [number, number, number];
    const [ax, ay, az] = [dx - camera.x, dy - camera.y, dz - camera.z];
    const part = Math.max(1 - leash / Math.hypot(ax, ay, az), 0);
    camera.x += part * ax;
    camera.y += part * ay;
    camera.z += part * az;
    const inside = { x: dx - camera.x, y: dy - camera.y, z: dz - camera.z };
    return { table: inside, camera: { ...camera } };
  });
  return (time) => {
    const place = Math.min(Math.max(time / step, 0), PLACES);
    const low = Math.min(Math.floor(place), PLACES - 1);
    const [from, to] = [places[low] as InPicture, places[low + 1] as InPicture];
    const of = (what: keyof InPicture): Displacement => {
      const between = (axis: keyof Displacement) =>
        from[what][axis] + (place - low) * (to[what][axis] - from[what][axis]);
      return { x: between("x"), y: between("y"), z: between("z") };
    };
    return { table: of("table"), camera: of("camera") };
  };
}
