// A motion to be computed: at once, or in a worker while the page answers its visitor.

import { Exchange, nextTask } from "./exchange";
import { type Known, Motion } from "./motion";

/** Which function of the core computes the motion, and its arguments. */
export interface Call {
  name: "simulate" | "simulate_shaken";
  numbers: readonly number[];
}

/** What the page asks of the worker. */
export interface Question {
  module: WebAssembly.Module;
  call: Call;
}

/** What it answers; undefined if the motion could not be computed. */
export type Answer = { memory: ArrayBuffer; address: number; known: Known } | undefined;

/** Computes a motion and gives its address. Throws `Refused` for invalid input. */
export function addressOf(exchange: Exchange, { name, numbers }: Call): number {
  exchange.put(numbers);
  return exchange.checked(exchange.core[name]());
}

/** A worker; undefined where there are none. The page that rimroll.lab makes may load nothing, not even a worker. */
const newWorker = (): Worker | undefined =>
  import.meta.env.MODE === "alone" || typeof Worker !== "function"
    ? undefined
    : new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });

export class Computation {
  constructor(
    private readonly exchange: Exchange,
    private readonly call: Call,
  ) {}

  /** Computes the motion now. Throws `Refused` for invalid input. */
  now(): Motion {
    return new Motion(this.exchange, addressOf(this.exchange, this.call));
  }

  /** Computes the motion in a worker of its own, until the signal aborts it. Gives undefined where there are no workers, and
   * rejects if the worker fails. */
  async inWorker(signal: AbortSignal): Promise<Motion | undefined> {
    const { module } = this.exchange;
    const worker = newWorker();
    if (!worker) return undefined;
    signal.addEventListener("abort", () => worker.terminate());
    const answer = await new Promise<Answer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<Answer>) => resolve(data);
      worker.onerror = ({ message }) => reject(new Error(message || "there is no worker"));
      worker.postMessage({ module, call: this.call } satisfies Question);
    }).finally(() => worker.terminate());
    if (!answer) throw new Error("the worker could not compute the motion");
    const exchange = await Exchange.of(module, answer.memory);
    const motion = new Motion(exchange, answer.address, answer.known);
    // Those who wait for the motion go on in the next task.
    await nextTask();
    return motion;
  }
}
