// The texts of index.html in other languages. English is in the file itself, so that it is there before any script.

/**
 * A text for each element of index.html with `data-words` or `data-label`, by that name. `{0}` stands for the
 * first element inside, such as a number or a formula, `{1}` for the second; each is used once, in any order.
 */
export type Prose = Readonly<Record<ProseName, string>>;

type ProseName =
  | "title"
  | "skip"
  | "tagline"
  | `part.${"nav" | "controls" | "compare" | "flicks" | "plots" | "share" | "limits" | "gyro"}`
  | "to-lab"
  | "to-essay"
  | `question.${"title" | "text"}`
  | `slap-or-roll.${"title" | "text" | "slow"}`
  | `hand.${"title" | "text" | "limit" | "symbols"}`
  | `friction.${"title" | "text" | "try"}`
  | `tall-and-flat.${"title" | "text"}`
  | `disks-and-coins.${"title" | "text"}`
  | `experiment.${"title" | "text" | "try"}`
  | `left-out.${"title" | "text"}`
  | `your-turn.${"title" | "text" | "lab"}`
  | `section.${"scene" | "transport" | "verdict" | "story" | "controls" | "compare" | "plots" | "flicks" | "share" | "limits" | "gyro"}`
  | `foot.${"paper" | "private" | "licences" | "parts" | "languages"}`;
