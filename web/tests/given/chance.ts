/** Random numbers that are the same in every run. */
export class Chance {
  constructor(private state: number) {}

  /** A uniform number in [0, 1): the upper bits of Knuth's and Lewis's linear congruential generator. */
  uniform(): number {
    this.state = (Math.imul(this.state, 1664525) + 1013904223) >>> 0;
    return (this.state >>> 4) / 2 ** 28;
  }

  between(low: number, high: number): number {
    return low + (high - low) * this.uniform();
  }

  one<T>(of: readonly T[]): T {
    return of[Math.floor(this.uniform() * of.length)] as T;
  }
}
