// Repeats of a test that `make soak` runs, and `make test` leaves out.

const SOAK = (process.env["RIMROLL_CASES"] ?? "1") !== "1";

/** All cases in `make soak`, otherwise the first ones: they guard the others. */
export const first = <Case>(count: number, cases: readonly Case[]): readonly Case[] =>
  SOAK ? cases : cases.slice(0, count);
