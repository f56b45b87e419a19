/**
 * Keeps the page for use without a connection. The service worker is installed after the first map, so that it does not
 * delay it.
 */

let isAsked = false;

/**
 * Hides links to pages that cannot be had just now: there is no connection, and they are not kept. A page that no service
 * worker gave came from the network.
 */
export function hideWhatIsAway(links: Iterable<HTMLAnchorElement>): void {
  const all = [...links];
  const look = (): void => void Promise.all(all.map(hideIfAway));
  for (const change of ["online", "offline"]) window.addEventListener(change, look);
  if (isControlled()) look();
}

/** Says whether a service worker gave this page. Where storage is refused, even asking fails. */
function isControlled(): boolean {
  try {
    return navigator.serviceWorker.controller !== null;
  } catch {
    return false;
  }
}

async function hideIfAway(link: HTMLAnchorElement): Promise<void> {
  link.hidden = !((await isOnline(link.href)) || (await isKept(link.href)));
}

/** Asks only for the head of the page: that is never answered from what is kept. */
async function isOnline(address: string): Promise<boolean> {
  if (!navigator.onLine) return false;
  return fetch(address, { method: "HEAD" }).then(
    () => true,
    () => false,
  );
}

async function isKept(address: string): Promise<boolean> {
  return (await caches.match(address).catch(() => undefined)) !== undefined;
}

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
