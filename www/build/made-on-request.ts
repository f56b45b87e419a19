/** Serves the files of a folder of the built site from the dev server, each made when it is requested. */

import type { Plugin } from "vite";

export type Source = string | Uint8Array;

/**
 * Returns the hook of a plugin. `made` makes a file by its name in the folder, or gives `undefined` if there is none; `types` are
 * content types by endings, besides HTML.
 */
export function madeOnRequest(
  folder: string,
  types: Readonly<Record<string, string>>,
  made: (file: string) => Promise<Source | undefined>,
): NonNullable<Plugin["configureServer"]> {
  const start = `/${folder}/`;
  return ({ middlewares }) => {
    middlewares.use((request, response, next) => {
      const [path = ""] = (request.url ?? "").split("?");
      if (!path.startsWith(start)) return next();
      const file = path.slice(start.length) || "index.html";
      made(file).then((source) => {
        if (source === undefined) return next();
        response.setHeader("Content-Type", types[file.split(".").at(-1) ?? ""] ?? "text/html");
        response.end(source);
      }, next);
    });
  };
}
