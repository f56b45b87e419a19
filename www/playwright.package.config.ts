import { defineConfig } from "@playwright/test";
import page from "./playwright.config.ts";

const PORT = Number(process.env["PORT"] ?? 4173);

/** The programs that use the packed tarball, built by scripts/consumers.mjs. */
export default defineConfig({
  ...page,
  testDir: "tests/package",
  testMatch: "*.spec.ts",
  webServer: {
    command: `vite preview --config tests/consumers/vite.config.ts --host 127.0.0.1 --port ${PORT} --strictPort`,
    url: `http://127.0.0.1:${PORT}/vite/`,
    reuseExistingServer: !process.env["CI"],
  },
});
