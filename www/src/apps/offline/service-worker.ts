/**
 * Keeps the page for visits without a connection: the page itself and its engine, all of one version, and the visited
 * parts of the gallery. All other files in its folder, such as the element's and `embed.html`, are not touched.
 *
 * A new version is fetched beside the old one and replaces it when no page of the old one is open any more, so that an
 * open page still finds the files that it fetches late.
 */

import { precacheAndRoute } from "workbox-precaching";
import { registerRoute } from "workbox-routing";
import { NetworkFirst, StaleWhileRevalidate } from "workbox-strategies";

/** The files of the page, which build/offline.ts inserts here. */
declare const PAGE_FILES: readonly { url: string; revision: string | null }[];

/** The worker's folder, whose requests are all that it sees. */
const FOLDER = new URL("./", location.href);
/** The files that are kept once they have been visited. */
const SEEN = /^gallery\//;

/** The match options of the page, which is the same file for all links. */
const FOR_ALL_LINKS = { ignoreURLParametersMatching: [/./] };

precacheAndRoute([...PAGE_FILES], FOR_ALL_LINKS);

const pages = new NetworkFirst({ cacheName: "riverseed-pages" });
const pictures = new StaleWhileRevalidate({ cacheName: "riverseed-pictures" });

registerRoute(
  ({ url }) => url.href.startsWith(FOLDER.href) && SEEN.test(url.href.slice(FOLDER.href.length)),
  (given) => (given.request.mode === "navigate" ? pages : pictures).handle(given),
);
