import { expect, test } from "vitest";
import { Core } from "../../src/core/core";

test("a core that is missing on the server gives an error in words", async () => {
  const missing = new Response("no such page", { status: 404 });
  await expect(Core.load(missing)).rejects.toThrow(
    "the mechanics could not be loaded (HTTP status 404)",
  );
});
