import { expect, test } from "vitest";
import { small } from "../../shaders";

test("a shader keeps its directives and operators", () => {
  const shader =
    "#ifdef USE_A\\n\\tfloat a = b - -c; // why\\n\\n\\treturn a * ( b + 1.0 );\\n#endif\\nelse\\n\\tx = 1;";
  expect(small(shader)).toBe(
    "\\n#ifdef USE_A\\nfloat a=b - -c;return a*(b+1.0);\\n#endif\\nelse x=1;",
  );
  // The text before or after may be a directive.
  expect(small("\\nfloat a;\\n")).toBe("\\nfloat a;\\n");
});
