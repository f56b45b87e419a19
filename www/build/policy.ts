/**
 * What the built page allows itself. Not in the dev server, which injects styles and talks over a socket.
 * `'wasm-unsafe-eval'` is what browsers call permission to compile WebAssembly; it allows no script evaluation.
 */

import { createHash } from "node:crypto";
import type { Plugin } from "vite";

const INLINE = /<script>([\s\S]*?)<\/script>/g;

export function contentSecurityPolicy(): Plugin {
  return {
    name: "content-security-policy",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler: (html) => [
        {
          tag: "meta",
          attrs: { "http-equiv": "Content-Security-Policy", content: policyFor(html) },
          injectTo: "head-prepend",
        },
      ],
    },
  };
}

/** The policy for a page: of scripts in it, those that stand there now, to the letter. */
export function policyFor(html: string): string {
  const inline = [...html.matchAll(INLINE)].map(([, script = ""]) => ` 'sha256-${hash(script)}'`);
  return [
    "default-src 'none'",
    `script-src 'self' 'wasm-unsafe-eval'${inline.join("")}`,
    "style-src 'self'",
    "font-src 'self'",
    "img-src 'self' data: blob:",
    "connect-src 'self'",
    "manifest-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
}

function hash(text: string): string {
  return createHash("sha256").update(text).digest("base64");
}
