/**
 * Films the growth with the browser's encoder. The frames follow the river's steps and not the clock: growth, quick at
 * first, then the rise of the sea, then the bends, then the finished map.
 */

import {
  BufferTarget,
  canEncodeVideo,
  Mp4OutputFormat,
  Output,
  type OutputFormat,
  QUALITY_HIGH,
  type VideoCodec,
  VideoSample,
  VideoSampleSource,
  WebMOutputFormat,
} from "mediabunny";
import { PageError } from "../engine/errors.ts";
import type { WholeCore, WholeRiver } from "../engine/whole.ts";
import { type Course, inSteps, partOf } from "./course.ts";
import { painted } from "./painting.ts";

/** The longer side, in pixels, and frames to the second. */
const LONGER_SIDE = 1200;
const RATE = 30;

/** The number of frames of each part, and of all, six seconds: the finished map stays for what is left of them. */
const FRAMES = { growing: 87, drowning: 24, meandering: 27, fading: 12, all: 180 } as const;

/**
 * The progress of each phase at a share of its time. The first third of growth is quick, since most of it is trimmed
 * again.
 */
const PACES = { growing: Math.sqrt, drowning: evenly, meandering: evenly } as const;

/** The end of each part, as a share of the whole. */
const SHARES = { growing: 0.5, drowning: 0.6, meandering: 0.75, finishing: 0.8 } as const;

/** The formats that browsers can encode, the most widely played first. */
const CODECS: readonly (readonly [codec: VideoCodec, container: () => OutputFormat])[] = [
  ["avc", () => new Mp4OutputFormat()],
  ["vp9", () => new WebMOutputFormat()],
  ["vp8", () => new WebMOutputFormat()],
  ["av1", () => new WebMOutputFormat()],
];

export async function animationOf(link: string, core: WholeCore, course: Course): Promise<Blob> {
  const river = new core.engine.River(link);
  try {
    const [width = 0, height = 0] = [...river.sidesFor(LONGER_SIDE)].map(even);
    river.resize(width, height);
    return await filmed(new Scenes(river, core, await Video.begin(width, height)), course);
  } finally {
    river.free();
  }
}

async function filmed(scenes: Scenes, course: Course): Promise<Blob> {
  try {
    await scenes.film("growing", partOf(course, 0, SHARES.growing));
    await scenes.film("drowning", partOf(course, SHARES.growing, SHARES.drowning));
    // While rivers are made from the tree there is nothing to see.
    await scenes.skip("shaping", course);
    await scenes.film("meandering", partOf(course, SHARES.drowning, SHARES.meandering));
    await scenes.finish(partOf(course, SHARES.meandering, SHARES.finishing), partOf(course, SHARES.finishing, 1));
    return await scenes.video.end();
  } catch (error) {
    await scenes.video.cancel();
    throw error;
  }
}

function evenly(share: number): number {
  return share;
}

/** Rounds a side to an even length, since encoders take no other. */
function even(length: number): number {
  return Math.max(2, 2 * Math.round(length / 2));
}

/** The river that is filmed. */
class Scenes {
  constructor(
    private readonly river: WholeRiver,
    private readonly core: WholeCore,
    readonly video: Video,
  ) {}

  /** Films a phase, frame by frame; nothing if the river is in another. */
  async film(phase: keyof typeof PACES, course: Course): Promise<void> {
    const { river } = this;
    const frames = FRAMES[phase];
    for (let frame = 1; frame <= frames && river.phase === phase; frame++) {
      const wanted = PACES[phase](frame / frames);
      const isBefore = (): boolean => river.phase === phase && (frame === frames || river.progress < wanted);
      await inSteps(
        course,
        () => isBefore() && river.advance(1),
        () => frame / frames,
      );
      await this.#shoot(course);
      course.tell(frame / frames);
    }
  }

  async skip(phase: WholeRiver["phase"], course: Course): Promise<void> {
    const { river } = this;
    await inSteps(
      course,
      () => river.phase === phase && river.advance(1),
      () => SHARES.drowning,
    );
  }

  /** Films the end: from the rivers to the finished map, which fades in and stays. */
  async finish(making: Course, showing: Course): Promise<void> {
    const { river, video } = this;
    const before = this.#pixels();
    await inSteps(
      making,
      () => river.advance(1),
      () => 0,
    );
    await painted(river, making);
    const after = this.#pixels();
    const frames = FRAMES.all - video.frames;
    for (let frame = 1; frame <= frames; frame++) {
      await video.add(frame < FRAMES.fading ? mixed(before, after, frame / FRAMES.fading) : after);
      showing.tell(frame / frames);
      await showing.pause();
    }
  }

  async #shoot(course: Course): Promise<void> {
    while (this.river.paint());
    await this.video.add(this.#pixels());
    await course.pause();
  }

  #pixels(): Uint8Array {
    const { river, core } = this;
    return new Uint8Array(core.memory.buffer, river.pixelsPointer(), river.pixelsLength()).slice();
  }
}

/** Blends one picture into another. */
function mixed(from: Uint8Array, to: Uint8Array, share: number): Uint8Array {
  return from.map((value, i) => value + ((to[i] ?? 0) - value) * share);
}

/** A video in the making. */
class Video {
  #frames = 0;

  private constructor(
    private readonly output: Output,
    private readonly target: BufferTarget,
    private readonly source: VideoSampleSource,
    private readonly size: { codedWidth: number; codedHeight: number },
  ) {}

  static async begin(width: number, height: number): Promise<Video> {
    const [codec, format] = await encodable(width, height);
    const target = new BufferTarget();
    const output = new Output({ format, target });
    const source = new VideoSampleSource({ codec, quality: QUALITY_HIGH });
    output.addVideoTrack(source, { frameRate: RATE });
    await output.start();
    return new Video(output, target, source, { codedWidth: width, codedHeight: height });
  }

  /** The number of frames so far. */
  get frames(): number {
    return this.#frames;
  }

  async add(pixels: Uint8Array): Promise<void> {
    const times = { timestamp: this.#frames++ / RATE, duration: 1 / RATE };
    const sample = new VideoSample(pixels, { format: "RGBX", ...this.size, ...times });
    try {
      await this.source.add(sample);
    } finally {
      sample.close();
    }
  }

  async end(): Promise<Blob> {
    await this.output.finalize();
    const { buffer } = this.target;
    if (!buffer) throw new PageError("unknown", "the browser's encoder gave no video");
    return new Blob([buffer], { type: this.output.format.mimeType });
  }

  async cancel(): Promise<void> {
    await this.output.cancel().catch(() => {});
  }
}

/** Finds the first codec with which the browser can encode this size. */
async function encodable(width: number, height: number): Promise<[VideoCodec, OutputFormat]> {
  for (const [codec, container] of CODECS)
    if (await canEncodeVideo(codec, { width, height, quality: QUALITY_HIGH })) return [codec, container()];
  const tried = "H.264, VP9, VP8 or AV1";
  throw new PageError("unknown", `this browser cannot encode a video of ${width} × ${height} pixels as ${tried}`);
}
