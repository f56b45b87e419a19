/** The means by which the page's renderer makes rivers and answers questions about them. */

import type { WholeCore, WholeRiver } from "../../engine/whole.ts";
import { fileOf } from "../../files/formats.ts";
import type { Means } from "../../host/renderer.ts";
import type { RiverPlayer } from "../../player/river-player.ts";
import { SharedClock } from "../../player/shared-clock.ts";
import { finishedPicture, type Picture, type Thumbnail, thumbnails } from "../../player/thumbnails.ts";
import { Inspections } from "./inspections.ts";
import { landBoundsOf } from "./land-bounds.ts";
import type { Answer, Measured, Names, Question, QuestionAbout } from "./protocol.ts";
import { Timelines } from "./timelines.ts";

type Player = RiverPlayer<WholeRiver>;

/** Returns the means of a renderer. `holdOn` is called before a long step. */
export function meansOf(core: WholeCore, holdOn: () => void = () => {}): Means<WholeRiver, Question, Answer> {
  const inspections = new Inspections();
  const timelines = new Timelines();
  /** The number of pictures that were asked for. Only the last one is still wanted. */
  let pictures = 0;
  return {
    makerFor: () => core,
    // There is only one river.
    shareMs: Number.POSITIVE_INFINITY,
    clock: new SharedClock(),
    async answer(question, playerOf) {
      switch (question.about) {
        case "file": {
          const { of, link, format, rasters } = question;
          return fileOf(copyFor(link, playerIn(of, playerOf), core), { ...core, holdOn }, format, rasters);
        }
        case "names":
          return namesOn(playerIn(question.of, playerOf), question.count);
        case "letters":
          return finishedOf(playerIn(question.of, playerOf))?.lettersFor(question.link);
        case "renamed": {
          const { names, mark, name } = question;
          return core.engine.renamed(names, mark, name);
        }
        case "thumbnails":
          return thumbnailsOf(playerIn(question.of, playerOf), core, question);
        case "picture": {
          const number = ++pictures;
          return pictureFrom(playerIn(question.of, playerOf), core, question, () => number === pictures);
        }
        case "measures":
          return measuresOf(playerIn(question.of, playerOf));
        case "river":
          return inspections.river(playerIn(question.of, playerOf), question.place);
        case "nameables":
          return inspections.nameables(playerIn(question.of, playerOf), question.place);
        case "overlay":
          return inspections.overlay(playerIn(question.of, playerOf), question.name);
        case "making":
          return timelines.making(playerIn(question.of, playerOf), question.to);
        case "land": {
          const river = playerIn(question.of, playerOf)?.river;
          return river && landBoundsOf(river);
        }
        case "now":
          return;
      }
    },
  };
}

function playerIn(of: number | undefined, playerOf: (id: number) => Player | undefined): Player | undefined {
  return of === undefined ? undefined : playerOf(of);
}

/** Makes a river of a link, for a file or a picture: a copy of the one on show, which then changes independently. */
function copyFor(link: string, player: Player | undefined, { engine }: WholeCore): WholeRiver {
  const river = player?.river?.copy();
  if (!river) return new engine.River(link);
  try {
    river.change(link);
    return river;
  } catch (error) {
    river.free();
    throw error;
  }
}

function namesOn(player: Player | undefined, count: number): Names | undefined {
  const river = finishedOf(player);
  return player && river && { link: player.link, names: river.greatest(count) };
}

function measuresOf(player: Player | undefined): Measured | undefined {
  const river = finishedOf(player);
  return river && { measures: river.measures(), promises: river.promises() };
}

/** Returns the river of a player if it is finished. */
function finishedOf(player: Player | undefined): WholeRiver | undefined {
  return player?.state === "finished" ? player.river : undefined;
}

/** Makes thumbnails in slices, so that the river on show comes first. */
async function thumbnailsOf(
  player: Player | undefined,
  { memory }: WholeCore,
  { styles, size }: QuestionAbout<"thumbnails">,
): Promise<Thumbnail[] | undefined> {
  const river = player?.river;
  if (!player || !river || player.state !== "finished") return;
  const { link } = player;
  const stays = (): boolean => player.link === link && player.state === "finished";
  const pause = pauseWhile(stays);
  const made: Thumbnail[] = [];
  for await (const thumbnail of thumbnails(river.copy(), memory, styles, size, pause)) made.push(thumbnail);
  return stays() ? made : undefined;
}

/** Makes a picture of another map in slices, unless the map on show changes or another picture is asked for meanwhile. */
async function pictureFrom(
  player: Player | undefined,
  core: WholeCore,
  { link, size }: QuestionAbout<"picture">,
  isLatest: () => boolean,
): Promise<Picture | undefined> {
  const from = player?.link;
  const pause = pauseWhile(() => isLatest() && player?.link === from);
  return finishedPicture(copyFor(link, player, core), core.memory, size, pause);
}

/** Returns a pause between slices, in which other messages are handled. It tells whether to go on. */
function pauseWhile(isWanted: () => boolean): () => Promise<boolean> {
  return () => new Promise((done) => setTimeout(() => done(isWanted())));
}
