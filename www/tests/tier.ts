/**
 * The two tiers of tests without a browser. With RIVERSEED_TIER=second only what the first leaves out is tried
 * (`make test-page-more`).
 */

export const isSecondTier = process.env["RIVERSEED_TIER"] === "second";

/** Returns the cases of this tier: one in `step` in the first, all others in the second. */
export function ofTier<Case>(cases: readonly Case[], step: number): Case[] {
  return cases.filter((_, i) => (i % step === 0) !== isSecondTier);
}
