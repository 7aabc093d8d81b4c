// The worker that computes one long motion. It sends the whole memory of its core, in which the motion is, because a page
// can give this memory to another instance of the same core. It also sends the table of all steps.

import { type Call, addressOf } from "./computation";
import { Exchange } from "./exchange";
import { Motion } from "./motion";

export interface Question {
  module: WebAssembly.Module;
  call: Call;
}

/** Undefined if the motion could not be computed. */
export type Answer = { memory: ArrayBuffer; address: number; steps: Float64Array } | undefined;

async function answer({ module, call }: Question): Promise<void> {
  const exchange = await Exchange.of(module);
  const address = addressOf(exchange, call);
  const memory = exchange.core.memory.buffer.slice(0);
  const steps = new Motion(exchange, address).samples(1).numbers;
  const found: Answer = { memory, address, steps };
  postMessage(found, { transfer: [memory, steps.buffer] });
}

addEventListener("message", ({ data }: MessageEvent<Question>) => {
  answer(data).catch((error: unknown) => {
    console.error(error);
    postMessage(undefined);
  });
});
