// A motion to be computed: at once, or in a worker while the page answers its visitor.

import { Exchange } from "./exchange";
import { Motion } from "./motion";
import type { Answer, Question } from "./worker";

/** Which function of the core computes the motion, and its arguments. */
export interface Call {
  name: "simulate" | "simulate_shaken";
  numbers: readonly number[];
}

/** Computes a motion and gives its address. Throws `Refused` for invalid input. */
export function addressOf(exchange: Exchange, { name, numbers }: Call): number {
  exchange.put(numbers);
  return exchange.checked(exchange.core[name]());
}

/** Whether a worker can be made. The page that rimroll.lab makes may load nothing, not even a worker. */
export const hasWorkers = (): boolean =>
  import.meta.env.MODE !== "alone" && typeof Worker === "function";

export class Computation {
  constructor(
    private readonly exchange: Exchange,
    private readonly call: Call,
  ) {}

  /** Computes the motion now. Throws `Refused` for invalid input. */
  now(): Motion {
    return new Motion(this.exchange, addressOf(this.exchange, this.call));
  }

  /** Computes the motion in a worker of its own, until the signal aborts it. Rejects if the worker cannot. */
  async inWorker(signal: AbortSignal): Promise<Motion> {
    const { module } = this.exchange;
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    signal.addEventListener("abort", () => worker.terminate());
    const answer = await new Promise<Answer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<Answer>) => resolve(data);
      worker.onerror = ({ message }) => reject(new Error(message || "there is no worker"));
      worker.postMessage({ module, call: this.call } satisfies Question);
    }).finally(() => worker.terminate());
    if (!answer) throw new Error("the worker could not compute the motion");
    const exchange = await Exchange.of(module, answer.memory);
    return new Motion(exchange, answer.address, answer.steps);
  }
}
