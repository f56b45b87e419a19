import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    include: ["tests/unit/**/*.test.ts"],
    environment: "node",
    // By itself vitest leaves a core free.
    maxWorkers: "100%",
    // Only what hangs is to fail by its time: a busy machine takes many times as long.
    testTimeout: 120_000,
  },
});
