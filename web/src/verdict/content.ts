// All that the verdict says, of a motion or of a body in the hand.

/** A big number, what it is, and a word on it. */
export interface Tile {
  name: string;
  number: string;
  note: string;
}

export interface Content {
  /** How far round the contact point ran. */
  turned: Tile;
  /** How far the body itself turned about its axis. */
  itself: Tile;
  theory: Tile;
  lowest: Tile;
  /** At the smallest tilt, or in the hand. */
  then: Tile;
  said: string;
  ended: string;
  /** Whether the end is none that one would wait for. */
  abnormal: boolean;
}
