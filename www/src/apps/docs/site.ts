/** Puts the address of this site into what readers paste, in place of the stand-in, if the site was built without knowing it. */

/** Replaces all stand-ins of a page, and hides what explains them. `root` leads from the page to the site. */
export function fillInSite(page: Document, root: string): void {
  const { href, protocol } = new URL(root, page.baseURI);
  if (!/^https?:$/.test(protocol)) return;
  for (const place of page.querySelectorAll("[data-site]")) place.textContent = href;
  for (const remark of page.querySelectorAll<HTMLElement>("[data-stand-in]")) remark.hidden = true;
}
