/** What the page and its renderer say to each other besides what everybody does who shows a river: questions, each with an answer. */

import type { Measure } from "../engine/full.ts";
import type { Format } from "../player/format-names.ts";
import type { Thumbnail } from "../player/thumbnails.ts";

/** The names on a map, as the engine tells them, three texts each. */
export interface Names {
  /** Of which map. */
  link: string;
  texts: readonly string[];
}

interface Questions {
  /** A link's finished rivers as a file; begun from the river of a number, as far as that has come, if there is one. */
  file: { of: number | undefined; link: string; format: Format };
  /** The greatest names of a river's finished map; none while it is not finished. */
  names: { of: number | undefined; count: number };
  /** The parameter `names` with another name for something, or its usual one. */
  renamed: { names: string; mark: string; name: string | undefined };
  /** Small pictures of a river's finished map, in their own pixels; none while it is not finished, or if it does not stay until they are made. */
  thumbnails: { of: number | undefined; styles: readonly string[]; size: { width: number; height: number } };
  /** What is measured of a river's finished map; none while it is not finished. */
  measures: { of: number | undefined };
  /** Nothing: what was said to a river before has been done. */
  now: { of: number };
}

export interface Answers {
  file: Blob;
  names: Names | undefined;
  renamed: string;
  thumbnails: readonly Thumbnail[] | undefined;
  measures: readonly Measure[] | undefined;
  now: undefined;
}

export type About = keyof Answers;
export type QuestionAbout<Key extends About> = Questions[Key] & { about: Key };
export type Question = { [Key in About]: QuestionAbout<Key> }[About];
export type Answer = Answers[About];

/** The first message to a worker: the engine, which the page has compiled. */
export interface Init {
  engine: WebAssembly.Module;
}
