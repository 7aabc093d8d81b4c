import { signal } from "@preact/signals-core";
import { expect, test, vi } from "vitest";
import type { Held } from "../../src/setup/release";
import { apart, unlessHeld } from "../../src/transport/transport";

test("of overlapping marks only the more important one remains", () => {
  const collisions = [0.05, 0.0501, 0.5];
  const landings = [0.0502, 0.2, 0.201, 0.495, 0.9];
  expect(apart([collisions, landings])).toEqual([
    [0.05, 0.5],
    [0.2, 0.9],
  ]);
});

test("no key lets time pass while a hand holds the body", () => {
  const held = signal<Held | undefined>({ tilt: 0.3, yaw: 0 });
  const act = vi.fn();
  unlessHeld({ held }, act)();
  expect(act).not.toHaveBeenCalled();
  held.value = undefined;
  unlessHeld({ held }, act)();
  expect(act).toHaveBeenCalledOnce();
});
