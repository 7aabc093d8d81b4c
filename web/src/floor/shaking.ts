// What the page knows of a floor that moves before the part that shakes it has been loaded.

import type { Computation } from "../core/computation";
import type { Input } from "../core/core";
import type { Motion } from "../core/motion";
import type { Setup } from "../setup/setup";
import type { Content } from "../verdict/content";

/** Distances along x, y and z, m. */
export interface Displacement {
  x: number;
  y: number;
  z: number;
}

/** The displacements of the table from the middle of the picture and of the camera from its place. */
export interface InPicture {
  table: Displacement;
  camera: Displacement;
}

/** How the table moves at times: the acceleration (m/s²) and the displacement (m) along x, y and z. */
export type TableMotion = Record<
  | "ground_acceleration_x"
  | "ground_acceleration_y"
  | "ground_acceleration_z"
  | "ground_displacement_x"
  | "ground_displacement_y"
  | "ground_displacement_z",
  Float64Array
>;

/** A motion of the floor. */
export interface Shaking {
  simulation(input: Input): Computation;
  /** The motion of the table at times, s. */
  at(times: ArrayLike<number>): TableMotion;
  /** Where the table and the camera are at a time (s). The camera follows a table that moves farther than `leash` (m)
   * from the middle of the picture. */
  inPicture(time: number, leash: number): InPicture;
  /** What the verdict says of a motion in place of the words for a table at rest. */
  verdict(motion: Motion, balanceTilt: number, setup: Readonly<Setup>): Partial<Content>;
  /** Lines of Python code. */
  python: {
    start: string | undefined;
    ground: string;
    flat: string;
  };
}

/** The part of the page that shakes the floor. */
export interface Shaker {
  /** What is simulated on the floor of a set-up, given what would be simulated on a floor at rest. */
  inputOf(setup: Readonly<Setup>, atRest: Input): Input & { shaking: Shaking };
}
