/** The page around an embedded river: the origin that messages go to and are accepted from. */

import { type HeightMessage, type Theme, themeIn } from "./messages.ts";

/** The properties of a window that tell about the page around it. */
export interface Surroundings {
  readonly self: unknown;
  readonly parent: unknown;
  readonly location: { readonly ancestorOrigins?: ArrayLike<string> };
  readonly document: { readonly referrer: string };
}

/**
 * Returns the origin of the page around: the browser's `ancestorOrigins`, or else (older Firefox) the referrer's.
 * Undefined if there is no page around, if it has no origin (a file, a sandbox), or if it withholds its name: then
 * nothing is posted.
 */
export function hostOrigin({ self, parent, location, document }: Surroundings): string | undefined {
  if (parent === self) return undefined;
  const origin = location.ancestorOrigins?.[0] ?? originOf(document.referrer);
  return origin === "null" ? undefined : origin;
}

function originOf(address: string): string | undefined {
  return URL.canParse(address) ? new URL(address).origin : undefined;
}

export class HostPage {
  readonly #origin: string | undefined;

  constructor(private readonly around: Window) {
    this.#origin = hostOrigin(around);
  }

  tell(message: HeightMessage): void {
    if (this.#origin !== undefined) this.around.parent.postMessage(message, this.#origin);
  }

  /** Listens for themes from the page itself only: not from its other frames, nor from another origin in its place. */
  onTheme(take: (theme: Theme) => void): void {
    this.around.addEventListener("message", ({ data, origin, source }) => {
      if (source !== this.around.parent || origin !== this.#origin) return;
      const theme = themeIn(data);
      if (theme !== undefined) take(theme);
    });
  }
}
