import { expect, it } from "vitest";
import { choiceOf, titleOfPlace } from "../../../src/apps/page/naming/words.ts";

const thing = { mark: "b1", kind: "bay", line: [] } as const;

it("calls a gulf by its word, and a bay by its own", () => {
  expect(titleOfPlace({ ...thing, name: "Gulf of Ral" })).toEqual(["Gulf of Ral", "A gulf"]);
  expect(titleOfPlace({ ...thing, name: "Ral Bay" })).toEqual(["Ral Bay", "A bay"]);
  expect(titleOfPlace({ ...thing, name: "" })).toEqual(["A bay without a name", ""]);
  expect(choiceOf({ ...thing, name: "Gulf of Ral" })).toBe("Gulf of Ral, the gulf");
  expect(choiceOf({ ...thing, name: "Engulfed Water" })).toBe("Engulfed Water, the bay");
});
