/** The page without a connection: what keeps it is installed once there is a map, of whose time it takes nothing. */

let isAsked = false;

/** Where there is nothing that could keep it, or nowhere, the page is as ever. */
export async function keepForOffline(): Promise<void> {
  if (isAsked || !import.meta.env.PROD) return;
  isAsked = true;
  try {
    await navigator.serviceWorker.register("./service-worker.js", { scope: "./" });
  } catch {
    // Storage or service workers are refused here.
  }
}
