import { beforeEach, expect, test, vi } from "vitest";
import { Undo, type UndoElements } from "../../../src/apps/page/undo.ts";
import { AddressBar } from "../../../src/browser/address.ts";

const PAGE = "https://rivers.example/";

/** As much of a browser's history as is used, all of it at once. */
class History {
  entries: { state: unknown; url: string }[] = [{ state: null, url: PAGE }];
  at = 0;
  moved = (): void => {};

  get state(): unknown {
    return this.entries[this.at]?.state;
  }

  pushState(state: unknown, _: string, url: string): void {
    this.entries.splice(++this.at, Number.POSITIVE_INFINITY, { state, url });
  }

  replaceState(state: unknown, _: string, url: string): void {
    this.entries[this.at] = { state, url };
  }

  back(): void {
    this.#go(-1);
  }

  forward(): void {
    this.#go(1);
  }

  /** Somebody pastes a link over the address: an entry of which nobody on the page knows. */
  paste(link: string): void {
    this.entries.splice(++this.at, Number.POSITIVE_INFINITY, { state: null, url: `${PAGE}#${link}` });
    this.moved();
  }

  #go(by: number): void {
    if (!this.entries[this.at + by]) return;
    this.at += by;
    this.moved();
  }
}

class Button {
  disabled = false;
  press = (): void => {};

  addEventListener(_: string, press: () => void): void {
    this.press = press;
  }
}

let history = new History();
let [back, forth] = [new Button(), new Button()];
let group = { hidden: true };
let undo: Undo;
let address: AddressBar;

/** The links of the history, from the first. */
function links(): string[] {
  return history.entries.map(({ url }) => new URL(url).search.slice(1));
}

/** What can be pressed. */
function offered(): string {
  return [back.disabled ? "" : "undo", forth.disabled ? "" : "redo"].filter((one) => one !== "").join(" ");
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout", "performance"] });
  history = new History();
  [back, forth] = [new Button(), new Button()];
  group = { hidden: true };
  vi.stubGlobal("history", history);
  vi.stubGlobal("location", {
    get href() {
      return history.entries[history.at]?.url;
    },
  });
  vi.stubGlobal("document", { addEventListener: () => {} });
  const elements = { group, undo: back, redo: forth } as unknown as UndoElements;
  undo = new Undo(
    elements,
    () => address.flush(),
    () => false,
  );
  address = new AddressBar((link, isStep) => undo.write(link, isStep));
  history.moved = () => {
    undo.arrived();
    address.drop();
    address.show(new URL(history.entries[history.at]?.url ?? "").hash.slice(1) || (links()[history.at] ?? ""));
  };
  address.show("seed=one");
  vi.advanceTimersByTime(2000);
  return () => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  };
});

test("the buttons come with the first step, and stay: undoing it leaves both in their places", () => {
  expect(group.hidden).toBe(true);
  address.show("seed=two", true);
  expect([group.hidden, offered()]).toEqual([false, "undo"]);
  back.press();
  expect([group.hidden, offered()]).toEqual([false, "redo"]);
});

test("a link that is pasted over the address can be undone, and nothing follows it", () => {
  address.show("seed=two", true);
  vi.advanceTimersByTime(2000);
  history.paste("seed=three");
  expect(offered()).toBe("undo");
  vi.advanceTimersByTime(2000);
  expect(links()).toEqual(["seed=one", "seed=two", "seed=three"]);
  back.press();
  expect([history.at, offered()]).toEqual([1, "undo redo"]);
  forth.press();
  expect([history.at, offered()]).toEqual([2, "undo"]);
});

test("pasted over the first link, it can be undone, too, and what could be redone is gone", () => {
  address.show("seed=two", true);
  back.press();
  expect(offered()).toBe("redo");
  vi.advanceTimersByTime(2000);
  history.paste("seed=three");
  expect(offered()).toBe("undo");
  back.press();
  expect([history.at, offered()]).toEqual([0, "redo"]);
});

test("steps in quick succession are each an entry of the history", () => {
  for (const seed of ["two", "three", "four", "five"]) {
    address.show(`seed=${seed}`, undo.isStep());
    vi.advanceTimersByTime(120);
  }
  vi.advanceTimersByTime(2000);
  expect(links()).toEqual(["one", "two", "three", "four", "five"].map((seed) => `seed=${seed}`));
});

test("looking through styles is one step, however long each is looked at", () => {
  for (const style of ["night", "survey", "parchment"]) {
    address.show(`style=${style}`, undo.isStep("style"));
    vi.advanceTimersByTime(20_000);
  }
  expect(links()).toEqual(["seed=one", "style=parchment"]);
  expect(undo.isStep("sea")).toBe(true);
  expect(undo.isStep("style")).toBe(true);
});

test("what one slider changes is one step until the hand rests, and another thing's change ends it", () => {
  expect(undo.isStep("sea")).toBe(true);
  vi.advanceTimersByTime(500);
  expect(undo.isStep("sea")).toBe(false);
  expect(undo.isStep("aspect")).toBe(true);
  expect(undo.isStep()).toBe(true);
  expect(undo.isStep("aspect")).toBe(true);
  vi.advanceTimersByTime(1500);
  expect(undo.isStep("aspect")).toBe(true);
});

test("what waits to be written goes with the entry that is left", () => {
  address.show("seed=two", true);
  address.show("seed=two&sea=0.3");
  address.show("seed=two&sea=0.4", true);
  history.back();
  vi.advanceTimersByTime(2000);
  expect(links()).toEqual(["seed=one", "seed=two&sea=0.3"]);
  expect([history.at, offered()]).toEqual([0, "redo"]);
});

/** Safari refuses the 101st write in 30 s. */
for (const everyMs of [5, 33, 120, 480, 510]) {
  test(`a step each ${everyMs} ms stays below what browsers allow, and the last is always written`, () => {
    const writes: number[] = [];
    let [steps, written] = [0, ""];
    const bar = new AddressBar((link) => {
      written = link;
      writes.push(performance.now());
    });
    for (let time = 0; time < 90_000; time += everyMs, steps++) {
      bar.show(`seed=${steps}`, true);
      vi.advanceTimersByTime(everyMs);
    }
    vi.advanceTimersByTime(2000);
    for (const time of writes) {
      expect(writes.filter((other) => other >= time && other < time + 30_000).length).toBeLessThan(100);
    }
    expect(writes.length).toBeGreaterThan(150);
    expect(written).toBe(`seed=${steps - 1}`);
  });
}
