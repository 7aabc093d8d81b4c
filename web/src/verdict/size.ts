// The gap and the speed of the near-collision for a body of this size.

import { formatLengthShort, formatSpeed } from "../format/sizes";
import type { Passage } from "./passage";

/** Height of the highest point of a rim (radius in m) above the table at the smallest tilt. */
export const gapOf = ({ minTilt }: Passage, radius: number): string =>
  formatLengthShort(2 * radius * Math.sin(minTilt));

/** Speed of the contact point along a rim (radius in m) at the smallest tilt. */
export const speedOf = ({ yawRate }: Passage, radius: number): string =>
  formatSpeed(radius * Math.abs(yawRate));
