/** Observers that all widgets of a page share: for those near the window, and for changes of their size. */

import { observeSize } from "../../browser/canvas.ts";

/**
 * The distance from the window at which a widget's river begins: about one turn of a wheel, so that the engine has
 * arrived when it is seen, and no more, so that its growth is seen from the beginning.
 */
const MARGIN_PX = 150;

/** The notifications of a watched element. */
export interface Watcher {
  near(isNear: boolean): void;
  resized(): void;
}

const watchers = new WeakMap<Element, Watcher>();

/** One observer of each kind, made for the first element and dropped with the last. */
let observers: { near: IntersectionObserver; size: ResizeObserver } | undefined;
let watched = 0;

/** Watches an element until the signal is aborted. */
export function watch(element: Element, watcher: Watcher, signal: AbortSignal): void {
  observers ??= observe();
  const { near, size } = observers;
  watchers.set(element, watcher);
  watched++;
  near.observe(element);
  observeSize(size, element);
  signal.addEventListener("abort", () => {
    near.unobserve(element);
    size.unobserve(element);
    watchers.delete(element);
    if (--watched === 0) observers = undefined;
  });
}

function observe(): NonNullable<typeof observers> {
  return {
    near: new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries) watchers.get(target)?.near(isIntersecting);
      },
      { rootMargin: `${MARGIN_PX}px` },
    ),
    size: new ResizeObserver((entries) => {
      for (const { target } of entries) watchers.get(target)?.resized();
    }),
  };
}
