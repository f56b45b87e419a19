/**
 * Makes the page available without a connection: its service worker, with the list of the page's files, and the
 * manifest and icons that installing it needs.
 */

import { createHash } from "node:crypto";
import sharp from "sharp";
import { build, type Plugin, type Rolldown } from "vite";
import { targets } from "../scripts/browsers.mjs";

type Bundle = Rolldown.OutputBundle;

const WORKER = "service-worker.js";
const MANIFEST = "manifest.webmanifest";
/**
 * Files that are kept besides: the posters, the pictures on buttons, and the style sheet of the gallery, whose pages
 * are kept once visited.
 */
const BESIDES = /^(?:poster\/.+|countries\/.+|styles\/.+|assets\/gallery-[\w-]+\.css)$/;
/** Files with a hash in their name, which need no revision. */
const HASHED = /^assets\/.+-[\w-]{8}\.\w+$/;

const ICONS = [
  { file: "icon-192.png", size: 192, purpose: "any" },
  { file: "icon-512.png", size: 512, purpose: "any" },
  { file: "icon-maskable-512.png", size: 512, purpose: "maskable" },
] as const;

/** A page that is kept besides, with all that it needs: the game. */
const GAME = "real-or-grown.html";

export function offline(page: string): Plugin {
  return {
    name: "offline",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler: (_html, { path }) =>
        path.slice(1) === page ? [{ tag: "link", attrs: { rel: "manifest", href: `./${MANIFEST}` } }] : [],
    },
    generateBundle: {
      // After all kept files have been written.
      order: "post",
      async handler(_options, bundle) {
        const emit = (fileName: string, source: string | Uint8Array) =>
          this.emitFile({ type: "asset", fileName, source });
        emit(MANIFEST, manifest());
        emit("icon.svg", icon("any"));
        for (const { file, size, purpose } of ICONS)
          emit(
            file,
            await sharp(Buffer.from(icon(purpose)), { density: 1200 })
              .resize(size, size)
              .png()
              .toBuffer(),
          );
        const mentioned = [page, GAME].flatMap((first) => mentionedFrom(first, bundle));
        const besides = Object.keys(bundle).filter((name) => BESIDES.test(name));
        const files = [...new Set([...mentioned, ...besides])];
        emit(WORKER, await workerWith(files.map((url) => ({ url, revision: revisionOf(url, bundle) }))));
      },
    },
  };
}

/** Returns a file and all files that it mentions, directly or through others, sorted. */
function mentionedFrom(first: string, bundle: Bundle): string[] {
  const names = Object.keys(bundle).filter((name) => name.startsWith("assets/"));
  const found = new Set([first]);
  // The loop also visits elements that are added to the set meanwhile.
  for (const name of found) {
    const text = textOf(name, bundle);
    for (const other of names) if (text.includes(other.slice("assets/".length))) found.add(other);
  }
  return [...found].sort();
}

function textOf(name: string, bundle: Bundle): string {
  const file = bundle[name];
  if (file?.type === "chunk") return file.code;
  return typeof file?.source === "string" ? file.source : "";
}

function revisionOf(name: string, bundle: Bundle): string | null {
  if (HASHED.test(name)) return null;
  const file = bundle[name];
  const content = file?.type === "asset" ? file.source : textOf(name, bundle);
  return createHash("sha256").update(content).digest("hex").slice(0, 16);
}

/** Builds the service worker as one classic script, which all browsers accept. */
async function workerWith(files: readonly { url: string; revision: string | null }[]): Promise<string> {
  const made = await build({
    configFile: false,
    logLevel: "warn",
    publicDir: false,
    define: { PAGE_FILES: JSON.stringify(files), "process.env.NODE_ENV": '"production"' },
    build: {
      write: false,
      target: targets(),
      lib: { entry: "src/apps/offline/service-worker.ts", formats: ["iife"], name: "worker", fileName: () => WORKER },
    },
  });
  const [built] = Array.isArray(made) ? made : [made];
  const [chunk] = built && "output" in built ? built.output : [];
  if (chunk?.type !== "chunk") throw new Error("no service worker was built");
  return chunk.code;
}

function manifest(): string {
  const raster = ICONS.map(({ file, size, purpose }) => ({
    src: file,
    sizes: `${size}x${size}`,
    type: "image/png",
    purpose,
  }));
  const about = {
    name: "Riverseed",
    short_name: "Riverseed",
    description: "A river network that grows from a word.",
    lang: "en",
    start_url: "./",
    scope: "./",
    display: "standalone",
    background_color: "#8fb6c6",
    theme_color: "#dde6e4",
    icons: [{ src: "icon.svg", sizes: "any", type: "image/svg+xml", purpose: "any" }, ...raster],
  };
  return `${JSON.stringify(about, null, 2)}\n`;
}

/**
 * Draws the page's icon. A maskable one may be cut to a circle: its paper extends to the edge, and its river keeps away
 * from it.
 */
function icon(purpose: "any" | "maskable"): string {
  const [corner, place] =
    purpose === "any" ? [3, ""] : [0, ' transform="translate(16 16) scale(0.75) translate(-16 -16)"'];
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32"><rect width="32" height="32" rx="${corner}" fill="#f4eee0"/><path${place} d="M16 31c0-7-3-8-3-13 0-4 4-5 4-10M13 19C10 16 8 14 8 8M14.500 24c5-4 8-5 9-13" fill="none" stroke="#1c5876" stroke-width="2.500" stroke-linecap="round"/></svg>\n`;
}
