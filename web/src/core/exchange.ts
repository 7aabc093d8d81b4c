// Passes numbers and texts to and from the core. WebAssembly functions take only numbers, so the core
// gives the addresses of its arguments and answers (crates/rimroll-wasm/src/exchange.rs).

/** Functions of the core; all but the first six return their results through those. */
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
  /** Only in the core with tables that move. */
  simulate_shaken(): number;
  forget(motion: number): void;
  columns(): void;
  samples(motion: number, perStep: number): void;
  at(motion: number): void;
  events(motion: number): void;
  phases(motion: number): void;
  turns(motion: number): void;
  validity(motion: number, start: number, lowest: number, end: number): void;
  status(motion: number): void;
  message(motion: number): void;
  falls(): number;
  outcomes(): void;
  laws(): void;
  presets(): void;
  shapes(): void;
  theory(): number;
}

/** A tuple of N numbers. */
export type Row<N extends number, A extends number[] = []> = A["length"] extends N
  ? A
  : Row<N, [...A, number]>;

/** Lets the page answer its visitor. */
export const nextTask = (): Promise<void> => new Promise((next) => setTimeout(next));

/** Thrown when the core refuses to compute; the message tells the visitor the reason. */
export class Refused extends Error {
  override name = "Refused";
}

/** The unit of the core's memory, bytes. */
const PAGE = 65_536;

/** So many bytes are copied in one task, which takes some ms. */
const PIECE = 8_000_000;

export class Exchange {
  private readonly decoder = new TextDecoder();

  private constructor(
    readonly module: WebAssembly.Module,
    readonly core: Exports,
  ) {}

  /** Instantiates the core from a fetched response or from its bytes. */
  static async with(core: Response | BufferSource): Promise<Exchange> {
    if (core instanceof Response && !core.ok)
      throw new Error(`the mechanics could not be loaded (HTTP status ${core.status})`);
    const module = await compile(core).catch((error: unknown) => {
      throw new Error("the file of the mechanics is damaged or is none", { cause: error });
    });
    return Exchange.of(module);
  }

  /** Instantiates the compiled core, with a copy of the memory of another instance if it is given. */
  static async of(module: WebAssembly.Module, memory?: ArrayBuffer): Promise<Exchange> {
    const core = (await WebAssembly.instantiate(module)).exports as unknown as Exports;
    if (typeof core.simulate !== "function")
      throw new Error("the file of the mechanics does not belong to this page");
    if (memory) {
      core.memory.grow((memory.byteLength - core.memory.buffer.byteLength) / PAGE);
      await copyInPieces(new Uint8Array(memory), new Uint8Array(core.memory.buffer));
    }
    return new Exchange(module, core);
  }

  /** Writes the arguments of the next call. */
  put(numbers: ArrayLike<number>): void {
    const address = this.core.arguments(numbers.length);
    new Float64Array(this.core.memory.buffer, address, numbers.length).set(numbers);
  }

  /** The numbers of the last answer, copied, because the core's memory moves when it grows. */
  numbers(): Float64Array {
    const { buffer } = this.core.memory;
    return new Float64Array(buffer, this.core.numbers(), this.core.number_count()).slice();
  }

  /** The text of the last answer. */
  text(): string {
    const { buffer } = this.core.memory;
    return this.decoder.decode(new Uint8Array(buffer, this.core.text(), this.core.text_length()));
  }

  /** The names of the last answer. */
  names(): string[] {
    const text = this.text();
    return text === "" ? [] : text.split(" ");
  }

  /** Returns the result of a call, or throws if the call was refused. */
  checked(returned: number): number {
    if (!returned) throw new Refused(this.text());
    return returned;
  }
}

async function copyInPieces(from: Uint8Array, to: Uint8Array): Promise<void> {
  for (let start = 0; start < from.length; start += PIECE) {
    to.set(from.subarray(start, start + PIECE), start);
    await nextTask();
  }
}

/** Compiles the core while it is still loading, if the server sends its content type. */
async function compile(core: Response | BufferSource): Promise<WebAssembly.Module> {
  if (!(core instanceof Response)) return WebAssembly.compile(core);
  const type = core.headers.get("Content-Type");
  return type === "application/wasm"
    ? WebAssembly.compileStreaming(core)
    : WebAssembly.compile(await core.arrayBuffer());
}
