/**
 * What an embedded river and the page around it tell each other: `{ riverseed: { height } }` goes out, in CSS pixels, and
 * `{ riverseed: { theme } }` comes in. Whatever else a page says is none of our business, and not an error.
 */

export type Theme = "auto" | "light" | "dark";

export interface HeightMessage {
  readonly riverseed: { readonly height: number };
}

export function heightMessage(height: number): HeightMessage {
  return { riverseed: { height } };
}

/** The theme that a message asks for, if it is one of ours and a sound one. */
export function themeIn(message: unknown): Theme | undefined {
  const theme = member(member(message, "riverseed"), "theme");
  return theme === "auto" || theme === "light" || theme === "dark" ? theme : undefined;
}

function member(value: unknown, name: string): unknown {
  return typeof value === "object" && value !== null && Object.hasOwn(value, name)
    ? (value as Record<string, unknown>)[name]
    : undefined;
}
