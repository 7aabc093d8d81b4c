// Numbers and words to and from the core. WebAssembly passes numbers and addresses only; the core
// says where its arguments go and where its answers lie (crates/rimroll-wasm/src/exchange.rs).

/** What the core offers; every function but the first six answers through them. */
interface Exports {
  memory: WebAssembly.Memory;
  arguments(count: number): number;
  numbers(): number;
  number_count(): number;
  text(): number;
  text_length(): number;
  preset(place: number): number;
  composed(): number;
  simulate(): number;
  forget(motion: number): void;
  columns(): void;
  samples(motion: number, perStep: number): void;
  at(motion: number): void;
  events(motion: number): void;
  phases(motion: number): void;
  turns(motion: number): void;
  status(motion: number): void;
  message(motion: number): void;
  falls(): number;
  outcomes(): void;
  laws(): void;
  presets(): void;
  shapes(): void;
  theory(): number;
}

/** As many numbers as the core is known to answer with. */
export type Row<N extends number, A extends number[] = []> = A["length"] extends N
  ? A
  : Row<N, [...A, number]>;

/** What the core does not compute, and says why in a sentence for whoever typed the value. */
export class Refused extends Error {
  override name = "Refused";
}

export class Exchange {
  private readonly decoder = new TextDecoder();

  private constructor(readonly core: Exports) {}

  /** From the compiled core: what was fetched, or its bytes. */
  static async with(core: Response | BufferSource): Promise<Exchange> {
    if (core instanceof Response && !core.ok)
      throw new Error(`the mechanics could not be loaded (the server says ${core.status})`);
    const { instance } = await instantiate(core);
    return new Exchange(instance.exports as unknown as Exports);
  }

  /** Puts down the arguments of the next call. */
  put(numbers: ArrayLike<number>): void {
    const address = this.core.arguments(numbers.length);
    new Float64Array(this.core.memory.buffer, address, numbers.length).set(numbers);
  }

  /** The numbers of the last answer. A copy: the core's memory moves when it grows. */
  numbers(): Float64Array {
    const { buffer } = this.core.memory;
    return new Float64Array(buffer, this.core.numbers(), this.core.number_count()).slice();
  }

  /** The words of the last answer. */
  text(): string {
    const { buffer } = this.core.memory;
    return this.decoder.decode(new Uint8Array(buffer, this.core.text(), this.core.text_length()));
  }

  /** The names of the last answer. */
  names(): string[] {
    const text = this.text();
    return text === "" ? [] : text.split(" ");
  }

  /** What a call returned, unless it was a refusal. */
  checked(returned: number): number {
    if (!returned) throw new Refused(this.text());
    return returned;
  }
}

/** Compiled while it still comes, where the server says what it is. */
async function instantiate(core: Response | BufferSource) {
  if (!(core instanceof Response)) return WebAssembly.instantiate(core);
  const type = core.headers.get("Content-Type");
  return type === "application/wasm"
    ? WebAssembly.instantiateStreaming(core)
    : WebAssembly.instantiate(await core.arrayBuffer());
}
