import { defineConfig } from "vitest/config";

export default defineConfig({
  // By itself vitest leaves a core free.
  test: { include: ["tests/unit/**/*.test.ts"], environment: "node", maxWorkers: "100%" },
});
