import { rmSync } from "node:fs";
import { basename, resolve } from "node:path";
import { defineConfig, type EnvironmentOptions, type Plugin } from "vite";
import { targets } from "./scripts/browsers.mjs";

const FOLDER = "dist-widget";

/**
 * Five builds into one folder, from the same sources: one file for a script tag, one for the worker, modules that a
 * bundler may take apart, one for Node, and a classic script for pages opened from disk. Each is whole without the
 * others' chunks, so that a reader fetches two scripts, one after the other.
 */
const BUILDS: Record<string, readonly string[]> = {
  tag: ["widget/river-seed"],
  worker: ["widget/worker"],
  modules: ["widget/element", "widget/define", "widget/core"],
  node: ["node/node"],
  classic: ["widget/classic"],
};

/** The stand-in for a module in the classic script, which can load no other file. */
const STAND_INS: Record<string, string> = {
  "./backend.ts": "src/apps/widget/page-host.ts",
  "./engines.ts": "src/apps/widget/whole-engine.ts",
};
const GLUE_URL = /new URL\('\w+_bg\.wasm', import\.meta\.url\)/;

/** Makes the classic script whole: stand-ins for what it cannot load, and one copy of its engine, the one that is asked for by name. */
function whole(): Plugin {
  return {
    name: "whole",
    enforce: "pre",
    applyToEnvironment: ({ name }) => name === "classic",
    resolveId: (source, importer) =>
      importer?.includes("/apps/widget/") && STAND_INS[source] ? resolve(STAND_INS[source]) : undefined,
    transform: {
      filter: { code: GLUE_URL },
      handler: (code) => code.replace(GLUE_URL, "undefined"),
    },
  };
}

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
  const isClassic = name === "classic";
  return {
    consumer: "client",
    build: {
      outDir: FOLDER,
      emptyOutDir: false,
      // Wasm that streams, and is cached apart from the scripts, but where no other file can be loaded.
      chunkSizeWarningLimit: isClassic ? 2000 : 500,
      assetsInlineLimit: isClassic ? Number.POSITIVE_INFINITY : 0,
      rolldownOptions: {
        // A classic script has none, and nothing in this one asks for its address.
        ...(isClassic ? { transform: { define: { "import.meta": "{}" } } } : {}),
        input: Object.fromEntries(entries.map((entry) => [basename(entry), `src/apps/${entry}.ts`])),
        external: /^node:/,
        preserveEntrySignatures: "exports-only",
        output: {
          ...(isClassic ? { format: "iife", codeSplitting: false } : {}),
          entryFileNames: isClassic ? "river-seed.classic.js" : "[name].js",
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
  plugins: [workerBeside(), noPreload(), whole()],
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
    modulePreload: false,
  },
});
