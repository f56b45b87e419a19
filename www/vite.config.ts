import { defineConfig, type Plugin } from "vite";
import { preloadEngine } from "./build/preload.ts";
import { wholeAddresses } from "./build/social.ts";
import { widgetFiles } from "./build/widget.ts";
import { targets } from "./scripts/browsers.mjs";

/**
 * What the built page allows itself. Not in the dev server, which injects styles and talks over a socket.
 * `'wasm-unsafe-eval'` is what browsers call permission to compile WebAssembly; it allows no script evaluation.
 */
const POLICY = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "connect-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

function contentSecurityPolicy(): Plugin {
  return {
    name: "content-security-policy",
    apply: "build",
    transformIndexHtml: () => [
      { tag: "meta", attrs: { "http-equiv": "Content-Security-Policy", content: POLICY }, injectTo: "head-prepend" },
    ],
  };
}

export default defineConfig({
  // Relative addresses: the built folder works on any static host, in any subfolder.
  base: "./",
  plugins: [
    contentSecurityPolicy(),
    preloadEngine("index.html"),
    wholeAddresses(process.env["RIVERSEED_SITE"]),
    widgetFiles(),
  ],
  // The digest page imports tests/digest.txt, one folder up.
  server: { fs: { allow: [".."] } },
  build: {
    // The wasm stays a file of its own, so that it streams and is cached.
    assetsInlineLimit: 0,
    target: targets(),
    rolldownOptions: { input: ["index.html", "digest.html", "embed.html", "examples/blog.html"] },
  },
});
