// Why the core gave no answer, in words.

import { Refused } from "./exchange";

/** The reason behind an error of the core; one that is not the core's is thrown on. */
export function reasonOrRethrow(error: unknown): string {
  if (error instanceof Refused) return error.message;
  // It stopped in the midst of computing, as when there is no more memory.
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
    return `the computation broke off (${error.message}); change the set-up, or load the page again`;
  throw error;
}
