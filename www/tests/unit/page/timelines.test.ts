import { expect, test } from "vitest";
import { Timelines } from "../../../src/apps/page-worker/timelines.ts";
import type { WholeRiver } from "../../../src/engine/whole.ts";
import type { RiverPlayer } from "../../../src/player/river-player.ts";
import { engine } from "../../core.ts";

test.each(["ink&lakes=0", "ink&lakes=0.5", "atlas"])(
  "the timeline of a map in the making in %s never goes back, while the sea rises either",
  async (style) => {
    const river = new engine.River(`seed=kea&land=island&attractors=600&drowning=0.6&style=${style}`);
    const player = { river, link: river.link, state: "growing" } as unknown as RiverPlayer<WholeRiver>;
    const timelines = new Timelines();
    const parts = ["growth", "bends", "map"];
    let before = 0;
    let risen = 0;
    while (river.phase !== "finished") {
      const { at, progress } = (await timelines.making(player, undefined)) ?? { at: { part: "map" }, progress: 0 };
      const now = parts.indexOf(at.part) + progress;
      expect(now, river.phase).toBeGreaterThanOrEqual(before);
      if (river.phase === "drowning") risen++;
      before = now;
      river.advance(1);
    }
    river.free();
    expect(risen).toBeGreaterThan(12);
  },
);
