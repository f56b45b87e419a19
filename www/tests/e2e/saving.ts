/** What tests do with the Save dialog. */

import { type Download, expect, type Locator, type Page } from "@playwright/test";

export const saving = (page: Page): Locator => page.getByRole("dialog", { name: "Save this map" });

export const saveButton = (page: Page): Locator => saving(page).getByRole("button", { name: "Save", exact: true });

export const said = (page: Page): Locator => saving(page).getByRole("status");

/** Opens the dialog, unless it is, and chooses what file there is to be, by how its name begins. */
export async function choose(page: Page, kind: string): Promise<void> {
  if (!(await saving(page).isVisible())) await page.getByRole("button", { name: "Save", exact: true }).click();
  await saving(page)
    .getByRole("radio", { name: new RegExp(`^${kind} `) })
    .check();
}

export async function chooseSize(page: Page, size: string): Promise<void> {
  await saving(page).getByRole("combobox", { name: "Size" }).selectOption(size);
}

export async function chooseOwnSize(page: Page, pixels: number | string): Promise<void> {
  await chooseSize(page, "own");
  await saving(page).getByRole("spinbutton", { name: "Longer side" }).fill(String(pixels));
}

export interface Saved {
  name: string;
  bytes: Buffer;
}

/** Has the file that is chosen made; it, with its name. */
export async function saved(page: Page): Promise<Saved> {
  const [download] = await Promise.all([page.waitForEvent("download"), saveButton(page).click()]);
  const file = { name: download.suggestedFilename(), bytes: await bytesOf(download) };
  await expect(saveButton(page)).toBeVisible();
  return file;
}

/** A file of a kind, with all else as it was chosen last, and the dialog closed again. */
export async function download(page: Page, kind: string): Promise<Saved> {
  await choose(page, kind);
  const file = await saved(page);
  await page.keyboard.press("Escape");
  await expect(saving(page)).toBeHidden();
  return file;
}

export async function bytesOf(download: Download): Promise<Buffer> {
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return Buffer.concat(chunks);
}
