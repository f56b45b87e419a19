import { rmSync } from "node:fs";
import { defineConfig, type EnvironmentOptions, type Plugin } from "vite";
import { targets } from "./scripts/browsers.mjs";

const FOLDER = "dist-widget";

/**
 * Three builds into one folder, from the same sources: one file for a script tag, one for the worker, and modules that a
 * bundler may take apart. Each is whole without the others' chunks, so that a reader fetches two scripts, one after the other.
 */
const BUILDS: Record<string, readonly string[]> = {
  tag: ["river-seed"],
  worker: ["worker"],
  modules: ["element", "define", "core"],
};

/** In the built files the worker has the form that bundlers know, so that it goes wherever the package goes. */
function workerBeside(): Plugin {
  return {
    name: "worker-beside",
    enforce: "pre",
    transform: {
      filter: { id: /\/widget\/backend\.ts$/ },
      handler: (code) => code.replace('new URL("./worker.ts"', 'new URL(/* @vite-ignore */ "./worker.js"'),
    },
  };
}

/** What is fetched late is fetched late: nothing is to be preloaded, and what would do it weighs a kilobyte. */
function noPreload(): Plugin {
  return {
    name: "no-preload",
    enforce: "pre",
    load: {
      filter: { id: /vite\/preload-helper/ },
      handler: () => "export const __vitePreload = (load) => load();",
    },
  };
}

function environment(name: string, entries: readonly string[]): EnvironmentOptions {
  return {
    consumer: "client",
    build: {
      outDir: FOLDER,
      emptyOutDir: false,
      rolldownOptions: {
        input: Object.fromEntries(entries.map((entry) => [entry, `src/apps/widget/${entry}.ts`])),
        preserveEntrySignatures: "exports-only",
        output: {
          entryFileNames: "[name].js",
          chunkFileNames: `${name}-[name].js`,
          assetFileNames: "[name][extname]",
        },
      },
    },
  };
}

export default defineConfig({
  // Everything lies beside everything else, wherever that is.
  base: "./",
  publicDir: false,
  plugins: [workerBeside(), noPreload()],
  environments: Object.fromEntries(Object.entries(BUILDS).map(([name, entries]) => [name, environment(name, entries)])),
  builder: {
    buildApp: async (builder) => {
      rmSync(FOLDER, { recursive: true, force: true });
      for (const name of Object.keys(BUILDS)) {
        const environment = builder.environments[name];
        if (environment) await builder.build(environment);
      }
    },
  },
  build: {
    target: targets(),
    // Wasm that streams, and is cached apart from the scripts.
    assetsInlineLimit: 0,
    modulePreload: false,
  },
});
