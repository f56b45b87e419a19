/**
 * Keeps the page for use without a connection. The service worker is installed after the first map, so that it does not
 * delay it.
 */

let isAsked = false;

/** Installs the service worker, once. If that is impossible the page works as before. */
export async function keepForOffline(): Promise<void> {
  if (isAsked || !import.meta.env.PROD) return;
  isAsked = true;
  try {
    await navigator.serviceWorker.register("./service-worker.js", { scope: "./" });
  } catch {
    // Storage or service workers are refused here.
  }
}
