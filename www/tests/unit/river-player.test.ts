import { expect, test, vi } from "vitest";
import { type Canvas, RiverPlayer } from "../../src/player/river-player.ts";
import { charts } from "../charts.ts";
import { engine, memory, pixelsOf } from "../core.ts";
import { Display, Image } from "../display.ts";

const SIZE = { width: 320, height: 300, ratio: 1 };

/** A player on a canvas without pixels, and its display. */
function player(text: string): [RiverPlayer<engine.River>, Display] {
  vi.stubGlobal("ImageData", Image);
  const canvas = { ...SIZE, getContext: () => ({ putImageData: () => {} }) } as unknown as Canvas;
  const display = new Display();
  const events = {
    sizeFor: () => SIZE,
    changed: () => {},
    failed: (error: unknown) => {
      throw error;
    },
  };
  return [
    new RiverPlayer({ engine, memory, loadCharts: () => Promise.resolve(charts) }, canvas, { text }, display, events),
    display,
  ];
}

function frames(display: Display): void {
  for (let i = 0; i < 2000 && display.frame(); i++);
}

/** What it shows. */
function shown(one: RiverPlayer<engine.River>): Uint8Array {
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
  for (let i = 0; i < 200 && held.river?.phase !== "meandering"; i++) display.frame();
  held.pause();
  const rounds = held.river?.summary().rounds;
  for (const change of [link("atlas"), `${link("atlas")}&names=12.Home`]) {
    held.show({ text: change }, "settle");
    frames(display);
    expect([held.state, held.river?.phase, held.river?.summary().rounds]).toEqual(["paused", "meandering", rounds]);
  }
});
