/**
 * Puts the address of this site into what readers paste, in place of the stand-in, on sites that were built without knowing it. A script
 * of its own, small enough for the first frame to wait for it: text that changed later would move what is below.
 */

const { href, protocol } = new URL(document.body.dataset["root"] ?? "../", document.baseURI);
if (/^https?:$/.test(protocol)) for (const place of document.querySelectorAll("[data-site]")) place.textContent = href;
