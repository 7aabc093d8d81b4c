// The worker that computes one long motion. It sends the whole memory of its core, in which the motion is, because a page
// can give this memory to another instance of the same core. It also sends what the page needs of all steps.

import { type Answer, type Question, addressOf } from "./computation";
import { Exchange } from "./exchange";
import { Motion } from "./motion";

async function answer({ module, call }: Question): Promise<void> {
  const exchange = await Exchange.of(module);
  const address = addressOf(exchange, call);
  const memory = exchange.core.memory.buffer.slice(0);
  const motion = new Motion(exchange, address);
  const [steps, yaws] = [motion.samples(1).numbers, motion.yaws()];
  const found: Answer = { memory, address, known: { steps, yaws } };
  postMessage(found, { transfer: [memory, steps.buffer, yaws.t.buffer, yaws.yaw.buffer] });
}

addEventListener("message", ({ data }: MessageEvent<Question>) => {
  answer(data).catch((error: unknown) => {
    console.error(error);
    postMessage(undefined);
  });
});
