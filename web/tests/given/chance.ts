/** Chance that is the same in every run. */
export class Chance {
  constructor(private state: number) {}

  /** An even number in [0, 1): Knuth's and Lewis's congruence, its upper bits. */
  even(): number {
    this.state = (Math.imul(this.state, 1664525) + 1013904223) >>> 0;
    return (this.state >>> 4) / 2 ** 28;
  }

  between(low: number, high: number): number {
    return low + (high - low) * this.even();
  }

  one<T>(of: readonly T[]): T {
    return of[Math.floor(this.even() * of.length)] as T;
  }
}
