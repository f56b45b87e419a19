/**
 * The Content-Security-Policy of the built page. The dev server has none, since it injects styles and uses a socket.
 * `'wasm-unsafe-eval'` is the permission to compile WebAssembly; it allows no script evaluation.
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

/**
 * Returns the policy for a page. Of inline scripts it allows exactly those that are in the page now, by their hashes.
 */
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
