import { beforeEach, expect, test, vi } from "vitest";
import type { PageRenderHost } from "../../../src/apps/page/backend.ts";
import type { PlaceElements } from "../../../src/apps/page/map/picture-place.ts";
import { type MapLink, RiverViewport } from "../../../src/apps/page/map/viewport.ts";
import type { Answer, Question } from "../../../src/apps/page-worker/protocol.ts";
import type { Summary } from "../../../src/engine/types.ts";
import type { Command, Report } from "../../../src/host/protocol.ts";

type Sent = Command<Question>;
interface Client {
  hear(report: Report<Answer>): void;
  moved(): void;
}

/** Takes commands and never draws. */
class StandIn {
  client: Client | undefined;
  readonly sent: Sent[] = [];
  answer: Answer = "";
  #last = 0;

  async enter(client: Client): Promise<number> {
    this.client = client;
    return ++this.#last;
  }

  send(id: number, command: object): void {
    this.sent.push({ ...command, id } as Sent);
  }

  async ask(question: Question): Promise<Answer> {
    this.sent.push({ id: 0, do: "ask", question });
    return this.answer;
  }

  leave(id: number): void {
    this.send(id, { do: "close" });
  }

  get done(): string[] {
    return this.sent.map(({ do: what }) => what);
  }

  last(what: Sent["do"]): Sent | undefined {
    return this.sent.findLast((command) => command.do === what);
  }
}

class Element {
  readonly dataset: Record<string, string> = {};
  readonly style: Record<string, unknown> = { setProperty: () => {} };
  replaced: unknown;
  disabled = false;
  readonly #listeners = new Map<string, () => void>();

  addEventListener(name: string, listener: () => void): void {
    this.#listeners.set(name, listener);
  }

  click(): void {
    this.#listeners.get("click")?.();
  }

  getBoundingClientRect(): object {
    return { x: 0, y: 0, width: 300, height: windowHeight };
  }

  querySelector(): null {
    return null;
  }

  cloneNode(): Element {
    return new Element();
  }

  replaceWith(other: unknown): void {
    this.replaced = other;
  }
}

const SUMMARY = {} as Summary;
/** The height of all elements, which are 300 wide. */
let windowHeight = 200;

/** The width of a place over its height. */
function shapeOf({ style }: Element): number {
  return Number.parseFloat(String(style["width"])) / Number.parseFloat(String(style["height"]));
}

beforeEach(() => {
  windowHeight = 200;
  vi.stubGlobal("window", { devicePixelRatio: 2, matchMedia: () => ({ matches: false }) });
  vi.stubGlobal("requestAnimationFrame", (draw: () => void) => queueMicrotask(draw));
  const canvas = { setAttribute: () => {}, append: () => {}, getContext: () => null };
  vi.stubGlobal("document", { hidden: false, addEventListener: () => {}, createElement: () => canvas });
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe(): void {}
      disconnect(): void {}
    },
  );
});

/** The renderer is another from now on. */
async function moved(host: StandIn): Promise<void> {
  host.sent.length = 0;
  host.client?.moved();
  await Promise.resolve();
  await Promise.resolve();
}

/** A link with the aspect that it says. */
function map(link: string): MapLink {
  return { link, aspect: Number(/aspect=(.*)/.exec(link)?.[1] ?? 1.6) };
}

async function opened(isHeard = true, isFromElsewhere = false) {
  const host = new StandIn();
  const zoom = { closer: new Element(), farther: new Element(), all: new Element() };
  const elements = { frame: new Element(), canvas: new Element(), mapPlace: new Element(), zoom };
  const events = { changed: vi.fn(), failed: vi.fn() };
  const viewport = new RiverViewport(
    host as unknown as PageRenderHost,
    elements as unknown as PlaceElements,
    map("seed=one"),
    () => ({ left: 0, top: 0, right: 0, bottom: 0 }),
  );
  viewport.start("watch", isFromElsewhere);
  if (isHeard) viewport.listen(events);
  await Promise.resolve();
  await Promise.resolve();
  const shown = (link: string, links: number, state: "growing" | "paused" | "finished" = "growing") =>
    host.client?.hear({
      id: 1,
      is: "shown",
      reading: { ...map(link), seed: "", notices: [], links },
      state,
      phase: state === "finished" ? "finished" : "growing",
      progress: state === "finished" ? 1 : 0.5,
      summary: SUMMARY,
    });
  const failed = (links: number, code: "too-large" | "panic" = "too-large") =>
    host.client?.hear({ id: 1, is: "failed", code, message: "no", links });
  return { host, elements, events, viewport, shown, failed };
}

test("a river is opened in its place's pixels, at the speed that was chosen before", async () => {
  const { host, viewport } = await opened();
  expect(host.done).toEqual(["open", "speed"]);
  expect(host.last("open")).toMatchObject({ link: { text: "seed=one" }, how: "watch", size: { width: 600, ratio: 2 } });
  viewport.speed = 4;
  expect(host.last("speed")).toMatchObject({ speed: 4 });
});

test("nothing is told of a river that another is to follow", async () => {
  const { events, viewport, elements, shown } = await opened();
  shown("seed=one", 0);
  viewport.show(map("seed=two"), "settle");
  viewport.show(map("seed=three"), "settle");
  expect(elements.frame.dataset).toHaveProperty("pending", "");
  shown("seed=one", 0, "finished");
  shown("seed=two", 1, "finished");
  expect(events.changed).toHaveBeenCalledTimes(1);
  // What is on the canvas is known all the same: a failure leads back to it.
  expect(viewport.link).toBe("seed=two");
  shown("seed=three", 2, "finished");
  expect(events.changed).toHaveBeenCalledTimes(2);
  expect([viewport.link, viewport.state]).toEqual(["seed=three", "finished"]);
  expect(elements.frame.dataset).not.toHaveProperty("pending");
});

test("a failure is told of if nothing newer was asked for, and the river that was there is told of again", async () => {
  const { events, viewport, shown, failed, elements } = await opened();
  shown("seed=one&aspect=2", 0, "finished");
  viewport.show(map("seed=two&aspect=3"), "settle");
  expect(shapeOf(elements.mapPlace)).toBeCloseTo(3);
  viewport.show(map("seed=three&aspect=4"), "settle");
  failed(1);
  expect(events.failed).not.toHaveBeenCalled();
  failed(2);
  expect(events.failed).toHaveBeenCalledTimes(1);
  expect(viewport.link).toBe("seed=one&aspect=2");
  expect(shapeOf(elements.mapPlace)).toBeCloseTo(2);
  shown("seed=one&aspect=2", 0, "paused");
  expect(events.changed).toHaveBeenLastCalledWith("paused", "growing", SUMMARY);
});

test("a first river that fails is told of, whatever was asked for since: nothing follows it", async () => {
  const { events, viewport, failed } = await opened();
  viewport.show(map("seed=two"), "settle");
  failed(0);
  expect(events.failed).toHaveBeenCalledTimes(1);
  expect(viewport.link).toBe("");
});

test("a trap is told of whatever was asked for since", async () => {
  const { events, viewport, failed } = await opened();
  viewport.show(map("seed=two"), "settle");
  failed(0, "panic");
  expect(events.failed.mock.calls.map(([{ code }]) => code)).toEqual(["panic"]);
});

test("what there is to be told before anybody listens is told then", async () => {
  const { viewport, shown, events } = await opened(false);
  shown("seed=one", 0);
  shown("seed=one", 0, "paused");
  viewport.listen(events);
  expect(events.changed.mock.calls.map(([state]) => state)).toEqual(["growing", "paused"]);
});

for (const [state, how] of [
  ["finished", "still"],
  ["growing", "watch"],
  ["paused", "watch"],
] as const) {
  test(`in another renderer a ${state} river goes on as it was, on another canvas, seen with the first word of it`, async () => {
    const { host, elements, shown } = await opened();
    const old = elements.canvas;
    shown("seed=one", 0, state);
    await moved(host);
    expect(host.last("open")).toMatchObject({ link: { text: "seed=one" }, how });
    expect(host.done.includes("pause")).toBe(state === "paused");
    const { canvas } = host.last("open") as { canvas?: unknown };
    expect(elements.canvas).toBe(old);
    shown("seed=one", 0, state);
    expect([elements.canvas, old.replaced]).toEqual([canvas, canvas]);
  });
}

test("what was asked of a renderer that answered no more is done in the next", async () => {
  const { host, viewport, shown } = await opened();
  shown("seed=one", 0, "finished");
  viewport.toggle();
  await moved(host);
  expect(host.last("open")).toMatchObject({ how: "watch" });
  viewport.toggle();
  await moved(host);
  expect(host.done.at(-1)).toBe("pause");
  // Once there is word of it, it is done.
  shown("seed=one", 0, "finished");
  await moved(host);
  expect(host.last("open")).toMatchObject({ how: "still" });
  viewport.show(map("seed=two"), "settle");
  await moved(host);
  expect(host.last("open")).toMatchObject({ link: { text: "seed=two" } });
});

test("a picture is moved at once to where it will be, and painted there when the hand rests", async () => {
  vi.useFakeTimers();
  const { host, elements, viewport, shown } = await opened();
  shown("seed=one", 0, "finished");
  const first = elements.frame.dataset["framing"];
  expect(elements.canvas.style["transform"]).toBe("");
  elements.zoom.closer.click();
  elements.zoom.closer.click();
  expect(elements.canvas.style["transform"]).toMatch(/^translate\(.*scale\(2.25\)$/);
  expect(host.last("resize")).toBeUndefined();
  await vi.runAllTimersAsync();
  expect(host.done.filter((what) => what === "resize")).toHaveLength(1);
  expect(elements.canvas.style["transform"]).toBe("");
  expect(elements.frame.dataset["framing"]).not.toBe(first);
  // A river that is on its way brings its own framing with it.
  viewport.show(map("seed=two"), "settle");
  elements.zoom.all.click();
  await vi.runAllTimersAsync();
  expect(elements.frame.dataset["framing"]).not.toBe(first);
  shown("seed=two", 1, "finished");
  expect(elements.frame.dataset["framing"]).toBe(first);
  expect(elements.canvas.style["transform"]).toBe("");
  vi.useRealTimers();
});

test("names are those of the link that was shown last, or none", async () => {
  const { host, viewport, shown } = await opened();
  shown("seed=one", 0, "finished");
  const names = [{ mark: "t", name: "Kauri", isOwn: false }];
  host.answer = { link: "seed=one", names };
  expect(await viewport.ask.names(12)).toEqual(names);
  const asked = viewport.ask.names(12);
  viewport.show(map("seed=two"), "settle");
  expect(await asked).toEqual([]);
});

test("a name that is given while another is asked for is not lost", async () => {
  const { host, viewport } = await opened();
  let names = "";
  const first = viewport.ask.renamed(() => names, "1", "Home");
  names = "2.Away";
  host.answer = "1.Home_2.Away";
  expect(await first).toBe("1.Home_2.Away");
  expect(host.sent.filter(({ do: what }) => what === "ask")).toMatchObject([
    { question: { names: "" } },
    { question: { names: "2.Away" } },
  ]);
});

test("a viewport that is closed gives its river up, and files can be had from another", async () => {
  const { host, viewport, events } = await opened();
  viewport.close();
  expect(host.done.at(-1)).toBe("close");
  host.client?.moved();
  viewport.toggle();
  expect(host.done.at(-1)).toBe("close");
  await viewport.ask.file("seed=one", "svg");
  expect(host.last("ask")).toMatchObject({ question: { about: "file", of: undefined, link: "seed=one" } });
  expect(events.failed).not.toHaveBeenCalled();
});

const LAND = { left: 0.25, top: 0.25, right: 0.75, bottom: 0.75 };

/** Opens a link from elsewhere in an upright window. */
async function openedUpright() {
  windowHeight = 600;
  const made = await opened(true, true);
  made.host.answer = LAND;
  const width = (): number => Number.parseFloat(String(made.elements.mapPlace.style["width"]));
  const asksForLand = (): boolean => made.host.sent.some((sent) => sent.do === "ask" && sent.question.about === "land");
  return { ...made, width, asksForLand };
}

test("a wide map from elsewhere shows its land alone in an upright window, once it is finished", async () => {
  const { elements, shown, width, asksForLand } = await openedUpright();
  shown("seed=one", 0);
  expect([width(), asksForLand()]).toEqual([300, false]);
  shown("seed=one", 0, "finished");
  expect(elements.frame.dataset).toHaveProperty("pending", "");
  await vi.waitFor(() => expect(elements.frame.dataset).not.toHaveProperty("pending"));
  expect(width()).toBe(600);
});

test("the whole map stays where the land cannot be told", async () => {
  const { host, elements, shown, width } = await openedUpright();
  host.ask = () => Promise.reject(new Error("no engine"));
  shown("seed=one", 0, "finished");
  await vi.waitFor(() => expect(elements.frame.dataset).not.toHaveProperty("pending"));
  expect(width()).toBe(300);
});

test("a hand that moves the map first, or another word, decides what is seen", async () => {
  const moved = await openedUpright();
  moved.shown("seed=one", 0);
  moved.elements.zoom.closer.click();
  moved.shown("seed=one", 0, "finished");
  const other = await openedUpright();
  other.shown("seed=one", 0);
  other.viewport.show(map("seed=two"), "still");
  other.shown("seed=two", 1, "finished");
  for (const { asksForLand, elements } of [moved, other]) {
    expect(asksForLand()).toBe(false);
    expect(elements.frame.dataset).not.toHaveProperty("pending");
  }
});
