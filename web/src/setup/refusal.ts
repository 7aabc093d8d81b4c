// A refused value and the reason, for the visitor who typed it or followed a link that holds it.

import type { FieldName, PlaybackName } from "./fields";

export interface Refusal {
  field: FieldName | PlaybackName;
  /** The text as the visitor wrote it. */
  text: string;
  message: string;
}
