import { expect, type Page, test } from "@playwright/test";
import { engine } from "../steer.ts";
import { told } from "../tell.ts";
import { openWithPanel, shown } from "./riverpage.ts";

const LINK = "seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=5&style=ink";
const TELLER = /riverseed_tell_bg.*\.wasm/;

/** The greatest names of a link's map, mark and name in turn. */
function greatest(link: string): string[][] {
  const river = new engine.River(link);
  while (river.advance(1000));
  const texts = told(river, (map) => map.greatest(12));
  return texts.flatMap((mark, i) => (i % 3 === 0 ? [[mark, texts[i + 1] ?? ""]] : []));
}

/** All addresses that a page asks for from now on. */
function asked(page: Page): string[] {
  const urls: string[] = [];
  page.on("request", (request) => urls.push(request.url()));
  return urls;
}

async function picture(page: Page): Promise<string> {
  return (await shown(page)).sha256;
}

test("a map without labels fetches nothing of what makes them, and one that gets them is told in words, too", async ({
  page,
}) => {
  const urls = asked(page);
  await openWithPanel(page, LINK);
  expect(urls.filter((url) => TELLER.test(url))).toEqual([]);
  const bare = await picture(page);
  await page.getByRole("heading", { name: "Names" }).click();
  await page.getByLabel("Labels", { exact: true }).selectOption("some");
  await expect.poll(() => picture(page)).not.toBe(bare);
  const rivers = greatest(LINK).filter(([mark]) => /^\d/.test(mark ?? ""));
  await expect(page.locator("#canvas")).toHaveAttribute(
    "aria-label",
    new RegExp(`Its greatest rivers: ${rivers[0]?.[1]}, `),
  );
  expect(urls.filter((url) => TELLER.test(url)).length).toBe(1);
});

test("names on the map are listed, can be typed over, and are in the link @core", async ({ page }) => {
  await openWithPanel(page, `${LINK}&labels=some`);
  await page.getByRole("heading", { name: "Names" }).click();
  const fields = page.locator(".names input");
  const names = greatest(LINK);
  await expect
    .poll(() => fields.evaluateAll((all) => all.map((one) => (one as HTMLInputElement).value)))
    .toEqual(names.map(([, name]) => name));
  const before = await picture(page);
  await fields.first().fill("Silver_Water <b>");
  await fields.first().press("Enter");
  const mark = names[0]?.[0];
  await expect(page).toHaveURL(new RegExp(`names=${mark}\\.Silver\\+Water`));
  await expect(fields.first()).toHaveValue("Silver Water <b>");
  await expect.poll(() => picture(page)).not.toBe(before);
  // Escape takes back what is typed, not what is said.
  await fields.first().fill("Other");
  await fields.first().press("Escape");
  await expect(fields.first()).toHaveValue("Silver Water <b>");
  await page.getByRole("button", { name: "Reset Silver Water <b>" }).click();
  await expect(fields.first()).toHaveValue(names[0]?.[1] ?? "");
  await expect(page).not.toHaveURL(/names=/);
  await expect(fields.first()).toBeFocused();
});

test("offline, the map has no labels, and a note says so @core", async ({ page }) => {
  await page.route(TELLER, (route) => route.abort());
  await openWithPanel(page, `${LINK}&labels=some`);
  await expect(page.locator("#notices")).toContainText("The map is shown without names");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "finished");
});
