/**
 * Shows <river-seed> in a notebook, as anywidget and marimo ask for it. What Python sets goes to the element's attributes and methods;
 * what the element tells and the reader does goes to Python. The kernel may be busy, stopped or not there at all: the map goes on without
 * it, since it grows in the browser.
 *
 * riverseed/widget.py adds the function `defineElement` to this file, which holds the element.
 */

/** Traits that are attributes of the element, by their names there. */
const ATTRIBUTES = {
  link: "recipe",
  still: "still",
  controls: "controls",
  speed: "speed",
  theme: "theme",
  alt: "alt",
};

/** The time after which it is said that Python does not answer. A kernel that computes answers late. */
const PATIENCE_MS = 5000;

/** The time in which the element does what Python asks for. */
const MOMENT_MS = 1000;

/** The least step of progress that is worth a message to Python. */
const STEP = 0.05;

const SILENT = "kernel-silent: Python does not answer: its kernel is busy or has stopped. The map goes on without it.";

function render({ model, el }) {
  if (!customElements.get("river-seed")) defineElement();
  const river = document.createElement("river-seed");
  const link = new Link(model);
  const stopTelling = tell(model, river, link);
  const stopFollowing = follow(model, river, link);
  el.append(river, link.note);
  return () => {
    stopFollowing();
    stopTelling();
    link.close();
    el.replaceChildren();
  };
}

/** Does what Python asks for. */
function follow(model, river, link) {
  const listeners = { "msg:custom": (message) => obey(message, river, link) };
  for (const [trait, attribute] of Object.entries(ATTRIBUTES)) {
    const set = () => setAttribute(river, attribute, model.get(trait));
    set();
    listeners[`change:${trait}`] = set;
  }
  listeners["change:paused"] = () => {
    const isPaused = model.get("paused");
    if (isPaused === river.paused) return;
    link.wait(isPaused);
    if (isPaused) river.pause();
    else river.play();
  };
  listeners["change:paused"]();
  for (const [event, listener] of Object.entries(listeners)) model.on(event, listener);
  return () => {
    for (const [event, listener] of Object.entries(listeners)) model.off(event, listener);
  };
}

function setAttribute(river, name, value) {
  if (value === null || value === undefined || value === false) river.removeAttribute(name);
  else river.setAttribute(name, value === true ? "" : String(value));
}

function obey(message, river, link) {
  if (message?.answer !== undefined) link.answered();
  else if (message?.do === "play") river.play();
  else if (message?.do === "restart") river.restart();
  else if (message?.do === "seek") river.seek(message.share);
}

/** Tells Python how far the river is, and what the reader does. */
function tell(model, river, link) {
  const told = { phase: undefined, progress: -1 };
  const state = () => {
    const { phase, progress, paused, summary } = river;
    const isNews = phase !== told.phase || Math.abs(progress - told.progress) >= STEP || paused !== model.get("paused");
    if (!isNews) return;
    Object.assign(told, { phase, progress });
    // Until the engine has read it, the link is only what was asked for.
    const shown = summary ? { shown: river.link } : {};
    link.tell({ phase, progress, summary, error: null, ...shown, ...link.pausedOf(river) });
  };
  const listeners = {
    progress: state,
    complete: state,
    error: ({ detail }) => link.tell({ phase: river.phase, progress: 0, summary: null, error: { ...detail } }),
  };
  link.onMoment = state;
  for (const [event, listener] of Object.entries(listeners)) river.addEventListener(event, listener);
  return () => {
    for (const [event, listener] of Object.entries(listeners)) river.removeEventListener(event, listener);
  };
}

/** The way to Python, which may be cut. */
class Link {
  /** True or false while Python has just paused or continued, which the element does a moment later. */
  #wanted;
  #until = 0;
  /** Stands below the map, and says something only while Python does not answer. */
  note = document.createElement("div");
  /** Is called when the element has had its moment. */
  onMoment = () => {};
  /** True once a message could not be sent. */
  #isCut = false;
  #model;
  #waiting;

  constructor(model) {
    this.#model = model;
    this.note.setAttribute("role", "status");
    this.note.style.cssText = "font: 12px/1.6 system-ui, sans-serif; opacity: 0.75";
  }

  /** Sets traits. */
  tell(traits) {
    for (const [name, value] of Object.entries(traits)) this.#model.set(name, value);
    if (!this.#isCut) this.#reach(() => this.#model.save_changes());
  }

  /** Waits for the element to pause or continue. A finished map does neither. */
  wait(wanted) {
    this.#wanted = wanted;
    this.#until = Date.now() + MOMENT_MS;
    setTimeout(() => this.onMoment(), MOMENT_MS + 1);
  }

  /** Returns the trait `paused`, if it has changed by the reader's hand; then Python is asked whether it hears. */
  pausedOf({ paused, phase }) {
    const isDue = Date.now() > this.#until && phase !== "idle" && phase !== "loading";
    if (paused === this.#wanted || isDue) this.#wanted = undefined;
    if (this.#wanted !== undefined || paused === this.#model.get("paused")) return {};
    this.#ask();
    return { paused };
  }

  answered() {
    this.#isCut = false;
    clearTimeout(this.#waiting);
    this.note.textContent = "";
  }

  close() {
    clearTimeout(this.#waiting);
    this.onMoment = () => {};
  }

  #ask() {
    clearTimeout(this.#waiting);
    this.#waiting = setTimeout(() => this.#silent(), PATIENCE_MS);
    this.#reach(() => this.#model.send({ ask: "heard" }));
  }

  /** Does what fails where Python has gone: at once in some notebooks, later in others. */
  async #reach(send) {
    try {
      await send();
    } catch {
      this.#isCut = true;
      this.#silent();
    }
  }

  #silent() {
    clearTimeout(this.#waiting);
    this.note.textContent = SILENT;
  }
}

// biome-ignore lint/style/noDefaultExport: notebooks ask for it.
export default { render };
