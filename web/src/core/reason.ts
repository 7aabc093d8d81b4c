// The reason why the core gave no answer, in words.

import { Refused } from "./exchange";
import { say, words } from "../words/words";

/** The reason behind an error of the core; any other error is thrown again. */
export function reasonOrRethrow(error: unknown): string {
  if (error instanceof Refused) return error.message;
  // The computation broke off, for example for lack of memory.
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
    return say(words.verdict.computationFailed, { why: error.message });
  throw error;
}
