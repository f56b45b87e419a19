import { expect, test } from "vitest";
import { linkToRead } from "../../../src/apps/widget/protocol.ts";
import { engine } from "../../core.ts";

/** The river of what a widget asks for. */
function created(text: string, isDark = false): InstanceType<typeof engine.River> {
  const asked = linkToRead(text, isDark);
  return new engine.River(asked.text, asked.options);
}

test("a river says how its link was read", () => {
  const { link, seed, aspect, notices } = created("curl=0.6&seed=r%C4%81t%C4%81&aspect=2");
  expect(link).toBe(engine.readLink("curl=0.6&seed=rātā&aspect=2").link);
  expect([seed, aspect, notices]).toEqual(["rātā", 2, []]);
});

test("a widget's river is within the widget's limits, and says so", () => {
  const { link, notices } = created("country=usual&attractors=24001&curl=9");
  expect(link).toBe(engine.readLink("country=usual&attractors=24000&curl=2").link);
  expect(notices.map(({ key }) => key)).toEqual(["curl", "attractors"]);
  expect(new engine.River("country=usual&attractors=24001").notices).toEqual([]);
});

test("a river that goes over to another link says how that was read", () => {
  const river = created("country=usual&attractors=24001");
  expect(river.change("curl=0.6&country=usual&attractors=24000", { widget: true })).toBe("grow");
  expect([river.link, river.notices]).toEqual([engine.readLink("curl=0.6&country=usual&attractors=24000").link, []]);
  expect(river.change("curl=0.60&country=usual&attractors=99999", { widget: true })).toBe("none");
  expect(river.notices).toHaveLength(1);
});

test("whatever the text, there is a river", () => {
  for (const text of ["%", "&&&", "seed", "x".repeat(10_000), "seed=\u0000", "attractors=1e99"]) {
    const { link } = created(text);
    expect(engine.readLink(link).notices).toEqual([]);
  }
});

const style = (link: string): string | null => new URLSearchParams(link).get("style");

test("on a dark page it is the dark style, unless another is chosen", () => {
  expect(style(created("seed=a", true).link)).toBe("night");
  expect(style(created("seed=a").link)).toBeNull();
  expect(style(created("style=ink", true).link)).toBe("ink");
});
