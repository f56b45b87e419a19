/** The page around an embedded river: whom messages go to, and whose are heard. */

import { type HeightMessage, type Theme, themeIn } from "./messages.ts";

/** What of a window says who is around it. */
export interface Surroundings {
  readonly self: unknown;
  readonly parent: unknown;
  readonly location: { readonly ancestorOrigins?: ArrayLike<string> };
  readonly document: { readonly referrer: string };
}

/**
 * The origin of the page around: as the browser gives it, or else (older Firefox) of the page that asked for this one.
 * Undefined where there is no page around, where it has no origin (a file, a sandbox), and where it asks not to be named: then
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

  /** Hears the page itself only: not its other frames, and not what another origin has put in its place. */
  onTheme(take: (theme: Theme) => void): void {
    this.around.addEventListener("message", ({ data, origin, source }) => {
      if (source !== this.around.parent || origin !== this.#origin) return;
      const theme = themeIn(data);
      if (theme !== undefined) take(theme);
    });
  }
}
