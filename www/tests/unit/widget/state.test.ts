import { expect, test } from "vitest";
import type { Seen } from "../../../src/apps/widget/protocol.ts";
import { Requested } from "../../../src/apps/widget/state.ts";
import type { Phase, Summary } from "../../../src/engine/types.ts";
import type { State } from "../../../src/player/frame-loop.ts";

const SUMMARY = { sources: 7 } as Summary;

function seen(state: State, phase: Phase, link = "seed=a"): Seen {
  const reading = { link, seed: "a", aspect: 1.6, notices: [], links: 0 };
  return { state, phase, progress: 0.5, summary: SUMMARY, reading };
}

/** How a promise ended. */
function end(promise: Promise<{ link: string }>): Promise<string> {
  return promise.then(
    ({ link }) => link,
    ({ name, message }: Error) => `${name}: ${message}`,
  );
}

test("rivers have no state before they begin, then that which they tell, and a promise of their end", async () => {
  const rivers = new Requested();
  const { finished } = rivers;
  expect([rivers.now, rivers.phase]).toEqual([undefined, undefined]);
  rivers.advance(seen("growing", "growing"));
  expect(rivers.now).toMatchObject({ link: "seed=a", state: "growing", progress: 0.5, summary: SUMMARY });
  rivers.advance(seen("finished", "finished"));
  expect([rivers.phase, await finished]).toEqual(["finished", { link: "seed=a", summary: SUMMARY }]);
});

test("other rivers have a promise of their own, and who waited for the old ones is told why", async () => {
  const rivers = new Requested();
  const first = end(rivers.finished);
  rivers.advance(seen("growing", "growing"));
  rivers.renew("no more");
  expect([rivers.now, await first]).toEqual([undefined, "AbortError: no more"]);
  rivers.advance(seen("finished", "finished", "seed=b"));
  expect(await end(rivers.finished)).toBe("seed=b");
});

test("finished rivers that grow again, asked or not, have a new promise; those that grow keep theirs", () => {
  const rivers = new Requested();
  const first = rivers.finished;
  rivers.growAgain();
  rivers.advance(seen("growing", "growing"));
  rivers.growAgain();
  expect(rivers.finished).toBe(first);
  rivers.advance(seen("finished", "finished"));
  rivers.growAgain();
  const second = rivers.finished;
  expect(second).not.toBe(first);
  rivers.advance(seen("finished", "finished"));
  rivers.advance(seen("growing", "growing"));
  expect(rivers.finished).not.toBe(second);
});

test("a failure is the end of rivers, until they tell of themselves again", async () => {
  const rivers = new Requested();
  const { finished } = rivers;
  rivers.advance(seen("growing", "growing"));
  rivers.fail(new Error("no room"));
  expect([rivers.now, rivers.phase, await end(finished)]).toEqual([undefined, "failed", "Error: no room"]);
  rivers.advance(seen("growing", "growing"));
  expect(rivers.phase).toBe("growing");
});
