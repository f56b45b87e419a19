/**
 * The viewport: the map that is seen on the page. The river itself is in the renderer: commands go there, and reports
 * come back. The viewport remembers the last request and the last report.
 */

import { isRecoverable, PageError } from "../../../engine/errors.ts";
import type { Phase, Summary } from "../../../engine/types.ts";
import type { Report } from "../../../host/protocol.ts";
import type { State } from "../../../player/frame-loop.ts";
import type { ShowMode } from "../../../player/river-player.ts";
import type { Answer } from "../../page-worker/protocol.ts";
import type { PageRenderHost } from "../backend.ts";
import type { Insets } from "./camera.ts";
import { FirstView } from "./first-view.ts";
import { LastPicture } from "./last-picture.ts";
import { Line } from "./line.ts";
import { PicturePlace, type PlaceElements } from "./picture-place.ts";
import { MapQuestions } from "./questions.ts";

export interface ViewportEvents {
  /** Called when the state or the river changed. It belongs to the link that was shown last. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: PageError): void;
}

/** The way in which a new renderer shows a river by its state: not from the same step, but to the same end. */
const HOW: Record<State, ShowMode> = { growing: "watch", paused: "watch", settling: "settle", finished: "still" };

/** A map to be shown: its canonical link, and its width over its height. */
export interface MapLink {
  link: string;
  aspect: number;
}

/** The map that was asked for last. */
interface Wanted extends MapLink {
  how: ShowMode;
  /** Its number among the links that this renderer was sent. Only reports of it or of later links count. */
  number: number;
}

/** The map that was reported last. */
interface Shown extends MapLink {
  state: State;
}

type SceneReport = Exclude<Report<Answer>, { is: "answer" }>;

export class RiverViewport {
  /** Asks about the map on show. */
  readonly ask: MapQuestions;
  #wanted: Wanted;
  #shown: Shown | undefined;
  #speed = 1;
  /** The requested state, until it is reported: there may be no river yet, or a worker that no longer answers. */
  #asked: State | undefined;
  #events: ViewportEvents | undefined;
  /** Reports that came before there was a listener. */
  readonly #untold: ((events: ViewportEvents) => void)[] = [];
  /** The number of links that this renderer was sent after the first. */
  #links = 0;
  #isCovered = false;
  readonly #awaited = { map: false, land: false };
  readonly #line: Line;
  readonly #place: PicturePlace;
  readonly #firstView: FirstView;
  readonly #lastPicture: LastPicture;

  constructor(
    renderHost: PageRenderHost,
    private readonly elements: PlaceElements,
    first: MapLink,
    covered: () => Insets,
  ) {
    this.#wanted = { ...first, how: "still", number: 0 };
    this.#lastPicture = new LastPicture(elements.frame);
    this.#line = new Line(renderHost, {
      opened: () => this.#open(),
      hear: (report) => this.#hear(report),
      moved: () => this.#move(),
      failed: (error) => this.#tell((events) => events.failed(error)),
    });
    const map = () => ({ aspect: this.#wanted.aspect, isFinished: this.state === "finished" });
    this.#place = new PicturePlace(elements, this.#line, this.#lastPicture, map, covered, () => {
      // A hand that moves the map decides what is seen.
      this.#firstView.isToCome = false;
    });
    this.#firstView = new FirstView(elements.frame, this.#line, this.#place, (land) => this.#await({ land }));
    this.ask = new MapQuestions(this.#line, () => ({ wanted: this.#wanted.link, shown: this.link }));
    document.addEventListener("visibilitychange", () => this.#rest());
  }

  /** Registers the listener, and tells it everything that was reported before. */
  listen(events: ViewportEvents): void {
    this.#events = events;
    for (const tell of this.#untold.splice(0)) tell(events);
  }

  /** The link of the river on show; empty while there is none. */
  get link(): string {
    return this.#shown?.link ?? "";
  }

  get state(): State {
    return this.#shown?.state ?? "paused";
  }

  set speed(speed: number) {
    this.#speed = speed;
    this.#line.send({ do: "speed", speed });
  }

  /** True while something covers the whole viewport: then the river rests. */
  set isCovered(isCovered: boolean) {
    this.#isCovered = isCovered;
    this.#rest();
  }

  toggle(): void {
    const state = this.#asked ?? this.state;
    this.#asked = state === "growing" || state === "settling" ? "paused" : "growing";
    this.#line.send({ do: "toggle" });
  }

  /** Shows the first river. If its link may come from a wider window, a narrow one shows its land alone. */
  start(how: ShowMode, isFromElsewhere: boolean): void {
    this.#wanted.how = how;
    this.#firstView.isToCome = isFromElsewhere;
    void this.#line.enter();
  }

  show({ link, aspect }: MapLink, how: ShowMode): void {
    // Another word is another country.
    const isAnother = seedOf(link) !== seedOf(this.#wanted.link);
    if (isAnother) this.#firstView.isToCome = false;
    this.#place.leave(isAnother);
    this.#wanted = { link, aspect, how, number: this.#wanted.number };
    this.#asked = undefined;
    if (this.#line.id === undefined) return;
    this.#wanted.number = ++this.#links;
    this.#await({ map: true });
    if (how === "still") this.#lastPicture.keep(this.elements.canvas, this.#place.seen);
    else this.#lastPicture.drop();
    this.#line.send({ do: "show", link: { text: link }, how, size: this.#place.sizeOfNext() });
  }

  /** Moves the map after other things have come to cover more or less of the picture's place. */
  refit(): void {
    this.#place.refit();
  }

  /** Closes the viewport for good, after a failure that leaves the engine in an unknown state. */
  close(): void {
    this.#line.close();
    this.#place.close();
  }

  /** Opens the river that was asked for last in a renderer, in its last state. */
  #open(): void {
    const { link, how } = this.#wanted;
    const state = this.#asked ?? (this.#shown?.link === link ? this.#shown.state : undefined);
    const { canvas } = this.#place;
    this.#links = this.#wanted.number = 0;
    const size = this.#place.sizeOfNext();
    this.#line.send({ do: "open", canvas, link: { text: link }, how: state ? HOW[state] : how, size });
    this.#line.send({ do: "speed", speed: this.#speed });
    if (state === "paused") this.#line.send({ do: "pause" });
    if (this.#isUnseen) this.#rest();
  }

  #hear(report: Report<Answer>): void {
    if (report.is === "shown") this.#show(report);
    if (report.is === "failed") this.#fail(report);
  }

  #show({ reading, state, phase, summary }: Extract<SceneReport, { is: "shown" }>): void {
    this.#place.reveal();
    this.#shown = { link: reading.link, aspect: reading.aspect, state };
    this.#asked = undefined;
    // Another link is on its way.
    if (reading.links < this.#wanted.number) return;
    this.#place.arrived();
    // Before that the sea may still rise over much of the land.
    if (state === "finished") void this.#firstView.show(() => this.#wanted);
    this.#await({ map: false });
    if (state === "finished") this.#lastPicture.fade();
    // Somebody has asked for its growth, or stopped it.
    else if (state !== "settling") this.#lastPicture.drop();
    this.#tell((events) => events.changed(state, phase, summary));
  }

  #fail({ code, message, links = 0 }: Extract<SceneReport, { is: "failed" }>): void {
    const error = new PageError(code, message);
    if (isRecoverable(error)) {
      // Another link is on its way and may succeed. Without a first river none does.
      if (links < this.#links && this.#shown) return;
      // The old river stays, in its own shape.
      const { aspect } = this.#shown ?? this.#wanted;
      this.#wanted = { ...this.#wanted, link: this.link, aspect, number: 0 };
      void this.#place.resize();
      this.#await({ map: false });
      this.#lastPicture.drop();
    }
    this.#tell((events) => events.failed(error));
  }

  /** Moves to another renderer. What is on the old canvas is seen until the map is finished there. */
  #move(): void {
    this.#lastPicture.keep(this.elements.canvas, this.#place.seen);
    this.#place.renewCanvas();
  }

  /** Marks the frame while the map that was asked for, or the view of its land, is not there yet. */
  #await(change: { map?: boolean; land?: boolean }): void {
    const { map, land } = Object.assign(this.#awaited, change);
    const { dataset } = this.elements.frame;
    if (map || land) dataset["pending"] = "";
    else delete dataset["pending"];
  }

  #tell(what: (events: ViewportEvents) => void): void {
    if (this.#events) what(this.#events);
    else this.#untold.push(what);
  }

  get #isUnseen(): boolean {
    return document.hidden || this.#isCovered;
  }

  #rest(): void {
    this.#line.send({ do: this.#isUnseen ? "rest" : "wake" });
  }
}

function seedOf(link: string): string | null {
  return new URLSearchParams(link).get("seed");
}
