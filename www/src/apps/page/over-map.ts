/** Puts together what lies over the map and follows it: the cards of rivers and of names, the looks inside, and the line of time. */

import type { Escapable } from "../../browser/keys.ts";
import type { Recipe } from "../../engine/recipe.ts";
import type { Summary } from "../../engine/types.ts";
import type { State } from "../../player/frame-loop.ts";
import { elements } from "./elements.ts";
import { LookInside } from "./look-inside/look-inside.ts";
import { RiverPointer } from "./look-inside/river-pointer.ts";
import type { Insets, Point } from "./map/camera.ts";
import { covered } from "./map/covered.ts";
import type { MapQuestions } from "./map/questions.ts";
import { Naming } from "./naming/naming.ts";
import type { MapNames } from "./panel/map-names.ts";
import { Track } from "./timeline/track.ts";

export class OverMap {
  /** What Escape closes: the cards before anything else on the page, and the looks inside late. */
  readonly cards: readonly Escapable[];
  readonly inside: LookInside;
  readonly #pointer: RiverPointer;
  readonly #naming: Naming;
  readonly #track: Track;

  constructor(ask: MapQuestions, recipe: Recipe, names: MapNames) {
    const onStage = { ...elements, stage: elements.drawing.stage };
    this.#pointer = new RiverPointer(onStage, {
      river: (place) => ask.river(place),
      greatest: () => names.greatest(),
      covered,
    });
    this.#naming = new Naming(onStage, this.#pointer, {
      nameables: (place) => ask.nameables(place),
      hasLabels: () => hasLetters(recipe.values),
      isOwn: (mark) => names.isOwn(mark),
      rename: (mark, name) => names.rename(mark, name),
    });
    this.inside = new LookInside(elements, {
      overlay: (name) => ask.overlay(name),
      middle: () => middleOf(covered()),
    });
    this.#track = new Track(elements.bar, {
      making: async (to) => {
        const making = await ask.making(to);
        if (to) this.inside.refresh();
        return making;
      },
    });
    this.cards = [this.#naming, this.#pointer];
  }

  /** Follows a change of the map's state. `link` is that of the map on show. */
  follow(state: State, link: string, growth: Summary["growth"]): void {
    this.#pointer.follow(state, link);
    this.#naming.follow();
    this.inside.follow(state, growth);
    void this.#track.follow();
  }
}

/** Returns the middle of the part of the window that nothing covers. */
function middleOf({ left, top, right, bottom }: Insets): Point {
  return { x: (left + innerWidth - right) / 2, y: (top + innerHeight - bottom) / 2 };
}

/** Returns whether names or a title are shown. An automatic title comes with names. */
function hasLetters(values: ReadonlyMap<string, string>): boolean {
  return values.get("labels") !== "none" || !/^(none|auto)$/.test(values.get("cartouche") ?? "none");
}
