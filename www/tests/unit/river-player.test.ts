import { expect, test, vi } from "vitest";
import { type Canvas, RiverPlayer } from "../../src/player/river-player.ts";
import { engine, memory, pixelsOf } from "../core.ts";
import { Display, Image } from "../display.ts";

const SIZE = { width: 320, height: 300, ratio: 1 };

function rethrow(error: unknown): void {
  throw error;
}

/** A player on a canvas without pixels, its display, and what was last put on the canvas. */
function player(
  text: string,
  failed = rethrow,
  size = () => SIZE,
  display = new Display(),
): [player: RiverPlayer, display: Display, seen: () => Buffer] {
  vi.stubGlobal("ImageData", Image);
  let last = Buffer.alloc(0);
  const putImageData = ({ data }: Image): void => {
    last = Buffer.from(data);
  };
  const canvas = { ...SIZE, getContext: () => ({ putImageData }) } as unknown as Canvas;
  const events = {
    sizeFor: size,
    changed: () => {},
    failed,
  };
  return [new RiverPlayer({ engine, memory }, canvas, { text }, display, events), display, () => last];
}

function frames(display: Display): void {
  for (let i = 0; i < 2000 && display.frame(); i++);
}

/** What it shows. */
function shown(one: RiverPlayer): Uint8Array {
  return pixelsOf(one.river as engine.River);
}

test("a finished map in a style that shows a relief is that of a fresh one, whatever it was shown in before", () => {
  const link = (style: string) => `seed=kea&land=island&attractors=600&style=${style}`;
  const [changed, display] = player(link("ink"));
  changed.start("still");
  frames(display);
  for (const style of ["atlas", "dark", "survey", "ink", "parchment"]) {
    changed.show({ text: link(style) }, "settle");
    frames(display);
    expect([changed.state, changed.river?.phase], style).toEqual(["finished", "finished"]);
    const [fresh, other] = player(link(style));
    fresh.start("still");
    frames(other);
    expect(Buffer.compare(shown(changed), shown(fresh)), style).toBe(0);
  }
});

test("another style of a map that is held while it grows or meanders lets it stay held", () => {
  const link = (style: string) => `seed=kea&land=island&attractors=600&style=${style}`;
  const [held, display] = player(link("ink"));
  held.start("watch");
  for (let i = 0; i < 300 && held.river?.phase !== "meandering"; i++) display.frame();
  held.pause();
  const rounds = held.river?.summary().rounds;
  for (const change of [link("atlas"), `${link("atlas")}&names=12.Home`]) {
    held.show({ text: change }, "settle");
    frames(display);
    expect([held.state, held.river?.phase, held.river?.summary().rounds]).toEqual(["paused", "meandering", rounds]);
  }
});

test("who asks for another map and at once for a share of it, or for a pause, gets both", () => {
  const link = "seed=rimu&land=island&attractors=600&style=ink&labels=none";
  for (const how of ["watch", "still"] as const) {
    const [sought, display] = player("seed=kea&land=island&attractors=600&style=ink&labels=none");
    sought.start(how);
    frames(display);
    sought.show({ text: link }, "watch");
    sought.seek(0.3);
    frames(display);
    expect([sought.state, sought.river?.seed]).toEqual(["paused", "rimu"]);
    expect(sought.river?.phase).toBe("growing");
    sought.show({ text: "seed=tay&attractors=600&style=ink&labels=none" }, "watch");
    sought.pause();
    frames(display);
    expect([sought.state, sought.river?.seed]).toEqual(["paused", "tay"]);
  }
});

test("who asks for another map and at once for its growth sees that map grow", () => {
  for (const grow of ["play", "replay"] as const) {
    const [grown, display] = player("seed=kea&land=island&attractors=600&style=ink&labels=none");
    grown.start("still");
    frames(display);
    grown.show({ text: "seed=rimu&land=island&attractors=600&style=ink&labels=none" }, "still");
    grown[grow]();
    for (let i = 0; i < 3; i++) display.frame();
    expect([grown.state, grown.river?.seed, grown.river?.phase]).toEqual(["growing", "rimu", "growing"]);
  }
});

test("the sea is seen rising by who watches, and not by who wants no motion", () => {
  const link = "seed=kea&land=island&attractors=600&drowning=0.6";
  const picturesOf = (how: "watch" | "still"): Set<string> => {
    const [one, display, seen] = player(link);
    const pictures = new Set<string>();
    one.start(how);
    for (let i = 0; i < 600 && display.frame(); i++)
      if (one.river?.phase === "drowning") pictures.add(seen().toString("base64"));
    expect(one.state).toBe("finished");
    return pictures;
  };
  expect(picturesOf("watch").size).toBeGreaterThan(8);
  expect(picturesOf("still").size).toBeLessThanOrEqual(1);
});

test("a change that is refused while its draft is seen leaves the map that was there", () => {
  const link = "seed=kea&land=island&attractors=600&style=atlas";
  const refused = vi.fn();
  const [one, display, seen] = player(link, refused);
  one.start("still");
  frames(display);
  const before = seen();
  one.show({ text: `${link}&sea=0.7` }, "settle");
  expect(Buffer.compare(seen(), before)).not.toBe(0);
  vi.spyOn(one.river as engine.River, "adoptDraft").mockImplementation(() => {
    throw new Error("no memory");
  });
  frames(display);
  expect(refused).toHaveBeenCalledOnce();
  expect([one.state, Buffer.compare(seen(), before)]).toEqual(["finished", 0]);
});

/** A display on a slow machine: each look at the clock finds it later. */
class SlowDisplay extends Display {
  #late = 0;

  override now(): number {
    this.#late += 12;
    return super.now() + this.#late;
  }
}

test("the core reads each link of a moving slider once, and goes over to what it has read when the hand rests", () => {
  const link = "seed=kea&land=island&attractors=600&style=atlas";
  // So slow that each part of a draft takes a frame.
  const [one, display] = player(link, rethrow, () => SIZE, new SlowDisplay());
  one.start("still");
  frames(display);
  const river = one.river as engine.River;
  const [draft, paintDraft] = [vi.spyOn(river, "draft"), vi.spyOn(river, "paintDraft")];
  const [adoptDraft, change] = [vi.spyOn(river, "adoptDraft"), vi.spyOn(river, "change")];
  one.show({ text: `${link}&mountains=3` }, "settle");
  expect([draft, adoptDraft, change].map(({ mock }) => mock.calls.length)).toEqual([1, 0, 0]);
  frames(display);
  expect(paintDraft.mock.calls.length).toBeGreaterThan(2);
  expect([draft, adoptDraft, change].map(({ mock }) => mock.calls.length)).toEqual([1, 1, 0]);
  expect([one.state, one.link.includes("mountains=3")]).toEqual(["finished", true]);
  const [fresh, other] = player(`${link}&mountains=3`);
  fresh.start("still");
  frames(other);
  expect(Buffer.compare(shown(one), shown(fresh))).toBe(0);
});

/** Until nothing is left to do, what is fetched late included. */
async function rest(display: Display): Promise<void> {
  for (let i = 0; i < 3; i++) {
    frames(display);
    await new Promise((done) => setImmediate(done));
  }
}

test("wherever a hand goes, and whatever comes between, the map at rest is that of its link", async () => {
  const base = "seed=kea&land=island&attractors=300&style=atlas&labels=some";
  const wanted = ["&sea=0.6", "&sea=0.65", "&mountains=3", "&roughness=0.3", "&width=25", "&simplify=40", "", "", ""];
  // Any other small numbers would do as well.
  let state = 12345;
  const below = (count: number): number => {
    state = (state * 1103515245 + 12345) % 2 ** 31;
    return Math.floor(state / 65536) % count;
  };
  const wide = { width: 500, height: 400, ratio: 1 };
  let size = wide;
  const made = new Map<string, Buffer>();
  const fresh = async (text: string): Promise<Buffer> => {
    const key = `${size.width} ${text}`;
    const [another, display, seen] = player(text, rethrow, () => size);
    if (!made.has(key)) {
      another.start("still");
      await rest(display);
      made.set(key, seen());
    }
    return made.get(key) ?? seen();
  };
  const [one, display, seen] = player(base, rethrow, () => size, new SlowDisplay());
  one.start("still");
  for (let round = 0; round < 30; round++) {
    one.show({ text: base }, "settle");
    await rest(display);
    let text = base;
    for (let moves = 0; moves < 4; moves++) {
      text = base + wanted[below(wanted.length)];
      one.show({ text }, "settle");
      if (below(9) === 0) {
        size = size === wide ? SIZE : wide;
        one.resize();
      }
      for (let count = below(4); count > 0; count--) display.frame();
    }
    await rest(display);
    expect([one.state, Buffer.compare(seen(), await fresh(text))], `${round}: ${text}`).toEqual(["finished", 0]);
  }
});
