/*
 * For pages that show Riverseed in iframes (optional):
 *
 *   <script src="https://…/embed-host.js" async></script>
 *
 * Makes each iframe as high as its river, and hands it the theme that its data-theme attribute names: auto, light or dark.
 * Heard are messages whose source is the window of an iframe of this page, and whose origin is that of the iframe's address.
 * Works as a module too; leaves nothing behind on the page.
 */
(() => {
  /** More than any screen, less than what a page chokes on. */
  const HIGHEST_PX = 20_000;

  /** The address of an iframe that shows a river. */
  const addressOf = (iframe) => {
    const address = URL.canParse(iframe.src) ? new URL(iframe.src) : undefined;
    return address?.pathname.endsWith("/embed.html") ? address : undefined;
  };

  const tellTheme = (iframe) => {
    const { theme } = iframe.dataset;
    const address = addressOf(iframe);
    if (theme !== undefined && address) iframe.contentWindow?.postMessage({ riverseed: { theme } }, address.origin);
  };

  const heightIn = (message) => {
    const height = message?.riverseed?.height;
    return Number.isFinite(height) && height > 0 && height <= HIGHEST_PX ? height : undefined;
  };

  window.addEventListener("message", ({ data, origin, source }) => {
    const height = heightIn(data);
    if (height === undefined) return;
    const iframe = [...document.querySelectorAll("iframe")].find(({ contentWindow }) => contentWindow === source);
    if (!iframe || addressOf(iframe)?.origin !== origin) return;
    iframe.style.height = `${height}px`;
    // It has begun to listen, at the latest when it speaks.
    tellTheme(iframe);
  });

  new MutationObserver((changes) => {
    for (const { target } of changes) if (target instanceof HTMLIFrameElement) tellTheme(target);
  }).observe(document, { subtree: true, attributeFilter: ["data-theme"] });
})();
