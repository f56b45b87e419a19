import { expect, type Page, test } from "@playwright/test";
import { elementSnippet, iframeSnippet } from "../../src/apps/page/share/snippets.ts";
import { engine } from "../core.ts";
import { address, fixChance, openFinished } from "./riverpage.ts";

const LINK = "seed=kowhai&attractors=300&style=atlas&width=20";

test.use({ permissions: ["clipboard-read", "clipboard-write"] });

async function openShare(page: Page, link = LINK): Promise<void> {
  await openFinished(page, link);
  await page.getByRole("button", { name: "Share" }).click();
  await expect(sharing(page)).toBeVisible();
}

const sharing = (page: Page) => page.getByRole("dialog", { name: "Share these rivers" });

/** Copies one of the forms; what is then on the clipboard. */
async function copied(page: Page, name: string): Promise<string> {
  await sharing(page)
    .getByRole("button", { name: `Copy ${name}` })
    .click();
  await expect(sharing(page).getByRole("status")).toContainText(new RegExp(`^${name} copied\\.$`, "i"));
  return page.evaluate(() => navigator.clipboard.readText());
}

/** What a browser makes of HTML: the attributes of the element that a selector finds. */
function parsed(page: Page, html: string, selector: string): Promise<[string, string][]> {
  return page.evaluate(
    ([html, selector]) => {
      const element = new DOMParser().parseFromString(html, "text/html").querySelector(selector);
      return [...(element?.attributes ?? [])].map(({ name, value }): [string, string] => [name, value]);
    },
    [html, selector] as const,
  );
}

/** The recipe that an element's attributes stand for; `style` is CSS. */
function recipeOf(attributes: [string, string][]): string {
  const own = attributes.filter(([name]) => name !== "style");
  const values = own.map(([name, value]): [string, string] => [name.replace(/^river-/, ""), value]);
  return engine.readLink(new URLSearchParams(values).toString()).link;
}

test("the link that is copied is the one of the rivers on show @core", async ({ page }) => {
  await openShare(page);
  const link = new URL(await copied(page, "link"));
  expect(link.search).toBe(`?${address(page)}`);
  expect(link.search.slice(1)).toBe(engine.readLink(LINK).link);
});

test("the element that is copied has the same recipe, and a link to it inside @core", async ({ page }) => {
  await openShare(page);
  const html = await copied(page, "element");
  const attributes = await parsed(page, html, "river-seed");
  expect(attributes.map(([name]) => name)).toContain("river-style");
  expect(recipeOf(attributes)).toBe(engine.readLink(LINK).link);
  const link = new Map(await parsed(page, html, "river-seed > a"));
  expect(new URL(link.get("href") ?? "").search.slice(1)).toBe(engine.readLink(LINK).link);
});

for (const [name, before, after] of [
  ["Markdown", "](", ")](http"],
  ["element", '<img src="', '"'],
] as const) {
  test(`the ${name} that is copied names the picture that is saved`, async ({ page }) => {
    await openShare(page);
    const text = await copied(page, name);
    const section = sharing(page).locator("section", { has: page.getByRole("button", { name: `Copy ${name}` }) });
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      section.getByRole("button", { name: "Save picture" }).click(),
    ]);
    expect(text).toContain(before + download.suggestedFilename() + after);
    await expect(sharing(page).getByRole("status")).toHaveText("kowhai-atlas-2000.png is in your downloads.");
  });
}

test("a parser finds a seed in every snippet, and nothing else, whatever signs it has @core", async ({ page }) => {
  for (const seed of [
    `"><img src=x onerror=alert(1)>`,
    "' onload='alert(1)",
    "&quot;&amp;&#34;",
    "</river-seed><b>--><!--",
    "[x](javascript:alert(1))",
    "māori ü 🌊 \u202e",
  ])
    await test.step(seed, async () => {
      const { link } = engine.readLink(new URLSearchParams({ seed, curl: "0.6" }).toString());
      const shared = { link, seed, aspect: "1.5", page: "https://rivers.example/" };
      const picture = `${seed}.png`;
      const snippet = elementSnippet(shared, picture);
      const element = await parsed(page, snippet, "body > river-seed");
      expect(recipeOf(element)).toBe(link);
      expect((await parsed(page, snippet, "body > river-seed > a > img")).slice(0, 2)).toEqual([
        ["src", picture],
        ["alt", `Rivers grown from “${seed}”`],
      ]);
      const iframe = new Map(await parsed(page, iframeSnippet(shared), "body > iframe"));
      expect(new URL(iframe.get("src") ?? "").search.slice(1)).toBe(link);
      expect(iframe.get("title")).toBe(`Rivers grown from “${seed}”`);
      expect([...iframe.keys()].filter((name) => name.startsWith("on"))).toEqual([]);
      for (const html of [snippet, iframeSnippet(shared)])
        expect(await parsed(page, html, "body > :not(river-seed, iframe, script), :not(a) > img, b")).toEqual([]);
    });
});

test("it is said beforehand where a widget shows other rivers", async ({ page }) => {
  await openShare(page, "seed=kowhai&attractors=20001&meander=none");
  await expect(sharing(page).getByRole("status")).toContainText(
    "attractors: 20001 exceeds the widget's limit: 20000 is used",
  );
});

test("what is shared follows the rivers", async ({ page }) => {
  await fixChance(page);
  await openShare(page);
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await page.getByRole("button", { name: "Share" }).click();
  const seed = await page.getByLabel("Seed", { exact: true }).inputValue();
  expect(seed).not.toBe("kowhai");
  await expect(sharing(page).getByRole("textbox", { name: "Link" })).toHaveValue(new RegExp(`seed=${seed}&`));
});

test("the dialog is used by keys: the link first, no way out but closing, and the focus comes back", async ({
  page,
}) => {
  await openFinished(page, LINK);
  const button = page.getByRole("button", { name: "Share" });
  await button.focus();
  await page.keyboard.press("Enter");
  await expect(sharing(page).getByRole("button", { name: "Copy link" })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(sharing(page).getByRole("status")).toHaveText("Link copied.");
  for (let i = 0; i < 14; i++) {
    await page.keyboard.press("Tab");
    const isOutside = await page.evaluate(() => {
      const { activeElement } = document;
      return activeElement !== document.body && !activeElement?.closest("dialog");
    });
    expect(isOutside).toBe(false);
  }
  await page.keyboard.press("Escape");
  await expect(sharing(page)).toBeHidden();
  await expect(button).toBeFocused();
  await button.click();
  await sharing(page).getByRole("button", { name: "Close" }).click();
  await expect(button).toBeFocused();
});

test("where copying is refused, the text is selected", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(navigator, "clipboard", { value: undefined });
  });
  await openShare(page);
  await sharing(page).getByRole("button", { name: "Copy iframe" }).click();
  await expect(sharing(page).getByRole("status")).toContainText("is selected");
  const box = sharing(page).getByRole("textbox", { name: "Iframe" });
  await expect(box).toBeFocused();
  const selected = await box.evaluate((area: HTMLTextAreaElement) => area.selectionEnd - area.selectionStart);
  expect(selected).toBe((await box.inputValue()).length);
});

for (const [width, height] of [
  [1440, 900],
  [390, 844],
  [320, 568],
] as const) {
  test(`everything in the dialog can be reached and nothing is cut off sideways, ${width} wide`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openShare(page, `${LINK}&seed=${"W".repeat(64)}`);
    const overflow = await sharing(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth);
    expect(overflow).toBeLessThanOrEqual(0);
    for (const button of await sharing(page).getByRole("button").all()) {
      // Away from the edges: text is laid out in 64ths of a pixel and scrolled in whole ones, so that a button which already is in
      // sight but for one 64th stays as it is.
      await button.evaluate((element) => element.scrollIntoView({ block: "center" }));
      await expect(button).toBeInViewport({ ratio: 1 });
    }
  });
}
