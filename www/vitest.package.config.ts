import { defineConfig } from "vitest/config";

/** What the packed tarball promises; scripts/consumers.mjs must have unpacked it. */
export default defineConfig({
  test: {
    include: ["tests/package/**/*.test.ts"],
    environment: "node",
    // No test depends on speed; these only end a run that hangs.
    testTimeout: 120_000,
    hookTimeout: 120_000,
  },
});
