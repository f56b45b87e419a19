import { defineConfig } from "vite";
import { buttonPictures } from "./build/button-pictures.ts";
import { tellsOfMissingFiles } from "./build/changed.ts";
import { crawlers } from "./build/crawlers.ts";
import { DOCS_INPUTS, docs } from "./build/docs/plugin.ts";
import { gallery, SHEET } from "./build/gallery/plugin.ts";
import { licences } from "./build/licences.ts";
import { offline } from "./build/offline.ts";
import { contentSecurityPolicy } from "./build/policy.ts";
import { poster } from "./build/poster.ts";
import { preloadEngine } from "./build/preload.ts";
import { wholeAddresses } from "./build/social.ts";
import { typefaces } from "./build/typefaces.ts";
import { widgetFiles } from "./build/widget.ts";
import { targets } from "./scripts/browsers.mjs";

export default defineConfig({
  // Relative addresses: the built folder works on any static host, in any subfolder.
  base: "./",
  plugins: [
    poster("index.html"),
    // Not embed.html: its engine is fetched by a worker, which does not see what its document has preloaded.
    preloadEngine("index.html"),
    typefaces("index.html", "real-or-grown.html"),
    buttonPictures(),
    offline("index.html"),
    tellsOfMissingFiles("index.html"),
    // After what writes scripts into pages.
    contentSecurityPolicy(),
    wholeAddresses(process.env["RIVERSEED_SITE"]),
    widgetFiles(),
    licences(),
    gallery(process.env["RIVERSEED_SITE"]),
    docs(process.env["RIVERSEED_SITE"]),
    crawlers(process.env["RIVERSEED_SITE"]),
  ],
  // The digest page imports tests/digest.txt, one folder up.
  server: { fs: { allow: [".."] } },
  build: {
    // The wasm stays a file of its own, so that it streams and is cached.
    assetsInlineLimit: 0,
    target: targets(),
    rolldownOptions: {
      input: [
        "index.html",
        "real-or-grown.html",
        "digest.html",
        "embed.html",
        "examples/blog.html",
        SHEET,
        ...DOCS_INPUTS,
      ],
    },
  },
});
