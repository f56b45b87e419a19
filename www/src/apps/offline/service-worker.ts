/**
 * Keeps the page for visits without a connection: the page itself, its engine and what makes charts, all of one version; and of the gallery
 * what has been visited. All else in its folder, the element's files and `embed.html` among it, goes by untouched.
 *
 * A new version is fetched beside the old one and takes its place when no page of the old one is open any more: a page that is open finds
 * what it fetches late.
 */

import { precacheAndRoute } from "workbox-precaching";
import { registerRoute } from "workbox-routing";
import { NetworkFirst, StaleWhileRevalidate } from "workbox-strategies";

/** What the page is made of: build/offline.ts puts it here. */
declare const PAGE_FILES: readonly { url: string; revision: string | null }[];

/** Its own folder, which is all that it hears of. */
const FOLDER = new URL("./", location.href);
/** What is kept when it was seen. */
const SEEN = /^gallery\//;

/** The page is the same for all links. */
const FOR_ALL_LINKS = { ignoreURLParametersMatching: [/./] };

precacheAndRoute([...PAGE_FILES], FOR_ALL_LINKS);

const pages = new NetworkFirst({ cacheName: "riverseed-pages" });
const pictures = new StaleWhileRevalidate({ cacheName: "riverseed-pictures" });

registerRoute(
  ({ url }) => url.href.startsWith(FOLDER.href) && SEEN.test(url.href.slice(FOLDER.href.length)),
  (given) => (given.request.mode === "navigate" ? pages : pictures).handle(given),
);
