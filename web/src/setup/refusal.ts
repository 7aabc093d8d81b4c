// A refused value and the reason, for the visitor who typed it or followed a link that holds it.

import type { FieldName, PlaybackName } from "./fields";

export interface Refusal {
  field: FieldName | PlaybackName;
  /** The text as the visitor wrote it. */
  text: string;
  message: string;
}

/** The message for an unknown choice; `names` are those that a visitor reads, not those of the link. */
export function noSuchChoice(label: string, names: readonly string[], text: string): string {
  const all = [names.slice(0, -1).join(", "), ...names.slice(-1)].join(" or ");
  return `${label}: there is no “${text}”; choose ${all}.`;
}
