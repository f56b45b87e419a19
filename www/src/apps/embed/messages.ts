/**
 * The messages between an embedded river and the page around it: `{ riverseed: { height } }` goes out, in CSS pixels,
 * and `{ riverseed: { theme } }` comes in. Other messages are ignored, and are not errors.
 */

export type Theme = "auto" | "light" | "dark";

export interface HeightMessage {
  readonly riverseed: { readonly height: number };
}

export function heightMessage(height: number): HeightMessage {
  return { riverseed: { height } };
}

/** Returns the theme that a message asks for, if it is a valid message of this kind. */
export function themeIn(message: unknown): Theme | undefined {
  const theme = member(member(message, "riverseed"), "theme");
  return theme === "auto" || theme === "light" || theme === "dark" ? theme : undefined;
}

function member(value: unknown, name: string): unknown {
  return typeof value === "object" && value !== null && Object.hasOwn(value, name)
    ? (value as Record<string, unknown>)[name]
    : undefined;
}
