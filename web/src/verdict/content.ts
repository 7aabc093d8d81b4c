// The content of the verdict, for a motion or for a held body.

/** A large number with its name and a note. */
export interface Tile {
  name: string;
  number: string;
  note: string;
}

export interface Content {
  /** Angle by which the contact point ran round. */
  turned: Tile;
  /** Rotation of the body itself about its axis. */
  itself: Tile;
  theory: Tile;
  lowest: Tile;
  /** The contact point at the smallest tilt, or the lean in the hand. */
  then: Tile;
  said: string;
  ended: string;
  /** The part of `ended` that is English in every language, or an empty text. */
  english: string;
  /** Whether the motion ends in an unusual way. */
  abnormal: boolean;
}
