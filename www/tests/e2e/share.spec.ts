import { expect, type Locator, type Page, test } from "@playwright/test";
import { elementSnippet, iframeSnippet } from "../../src/apps/page/share/snippets.ts";
import { engine } from "../core.ts";
import { address, fixChance, openFinished } from "./riverpage.ts";

const LINK = "seed=kowhai&attractors=300&style=parchment&labels=none&width=20";

test.use({ permissions: ["clipboard-read", "clipboard-write"] });

async function openShare(page: Page, link = LINK): Promise<void> {
  await openFinished(page, link);
  await page.getByRole("button", { name: "Share" }).click();
  await expect(sharing(page)).toBeVisible();
}

const sharing = (page: Page) => page.getByRole("dialog", { name: "Share this country" });

/** Says where the country is to be seen. */
async function choose(page: Page, place: string): Promise<void> {
  await sharing(page).getByRole("radio", { name: place }).check();
}

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

test("each place is given its one thing, and nothing of the others @core", async ({ page }) => {
  await openShare(page);
  for (const [place, copying] of [
    ["Message", "Copy link"],
    ["Blog", "Copy snippet"],
    ["Notebook", "Copy address"],
    ["README", "Copy Markdown"],
    ["Print", undefined],
  ] as const) {
    await choose(page, place);
    const shown = await sharing(page).getByRole("button", { name: /^Copy/ }).allTextContents();
    expect(shown, place).toEqual(copying === undefined ? [] : [copying]);
  }
});

test("a snippet is three clicks from the bare address @core", async ({ page }) => {
  await openFinished(page);
  let clicks = 0;
  const click = async (target: Locator): Promise<void> => {
    await target.click();
    clicks++;
  };
  await click(page.getByRole("button", { name: "Share" }));
  await click(sharing(page).getByText("Blog", { exact: true }));
  await click(sharing(page).getByRole("button", { name: "Copy snippet" }));
  await expect(sharing(page).getByRole("status")).toHaveText("Snippet copied.");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain("<river-seed ");
  expect(clicks).toBe(3);
});

test("a snippet names no style that the page would have anyway, so that it follows the page it stands on", async ({
  page,
}) => {
  const style = new Map(engine.readLink("").values).get("style");
  await openShare(page, `seed=kowhai&attractors=300&style=${style}`);
  await choose(page, "Blog");
  const attributes = await parsed(page, await copied(page, "snippet"), "river-seed");
  expect(attributes.map(([name]) => name)).not.toContain("river-style");
  await sharing(page).getByText("My blog allows no scripts").click();
  expect(await copied(page, "iframe")).not.toContain("style=parchment");
  await choose(page, "Notebook");
  expect(new URL(await copied(page, "address")).searchParams.has("style")).toBe(false);
  // A style of one's own stays.
  await openShare(page);
  await choose(page, "Notebook");
  expect(new URL(await copied(page, "address")).searchParams.get("style")).toBe("parchment");
});

test("the address for notebooks shows the map alone", async ({ page }) => {
  await openShare(page);
  await choose(page, "Notebook");
  const address = new URL(await copied(page, "address"));
  expect(address.pathname).toBe("/embed.html");
  expect(address.search.slice(1)).toBe(engine.readLink(LINK).link);
});

test("print closes the dialog and opens the browser's print view", async ({ page }) => {
  await page.addInitScript(() => {
    window.print = () => Object.assign(globalThis, { printed: document.querySelector("dialog[open]") === null });
  });
  await openShare(page);
  await choose(page, "Print");
  await sharing(page).getByRole("button", { name: "Print…" }).click();
  expect(await page.evaluate(() => Reflect.get(globalThis, "printed"))).toBe(true);
});

for (const canSend of [true, false]) {
  test(`a message ${canSend ? "can be sent with its picture where there is" : "is a link alone without"} a share sheet`, async ({
    page,
  }) => {
    await page.addInitScript((canSend) => {
      const share = async ({ files }: ShareData): Promise<void> =>
        void Object.assign(globalThis, { sent: files?.[0]?.name });
      const value = canSend ? share : undefined;
      Object.defineProperty(navigator, "share", { value });
      Object.defineProperty(navigator, "canShare", { value: () => canSend });
    }, canSend);
    await openShare(page);
    const button = sharing(page).getByRole("button", { name: "Send with its picture" });
    await expect(button).toBeVisible({ visible: canSend });
    if (!canSend) return;
    await button.click();
    await expect(sharing(page)).toBeHidden();
    await expect.poll(() => page.evaluate(() => Reflect.get(globalThis, "sent"))).toBe("kowhai-parchment-portrait.png");
  });
}

test("the element that is copied has the same recipe, and a link to it inside @core", async ({ page }) => {
  await openShare(page);
  await choose(page, "Blog");
  const html = await copied(page, "snippet");
  const attributes = await parsed(page, html, "river-seed");
  expect(attributes.map(([name]) => name)).toContain("river-style");
  expect(recipeOf(attributes)).toBe(engine.readLink(LINK).link);
  const link = new Map(await parsed(page, html, "river-seed > a"));
  expect(new URL(link.get("href") ?? "").search.slice(1)).toBe(engine.readLink(LINK).link);
});

for (const [place, name, before, after] of [
  ["README", "Markdown", "](", ")](http"],
  ["Blog", "snippet", '<img src="', '"'],
] as const) {
  test(`the ${name} that is copied names the picture that is saved`, async ({ page }) => {
    await openShare(page);
    await choose(page, place);
    const text = await copied(page, name);
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      sharing(page).getByRole("button", { name: "Save picture" }).click(),
    ]);
    expect(text).toContain(before + download.suggestedFilename() + after);
    await expect(sharing(page).getByRole("status")).toHaveText("kowhai-parchment-2000.png is in your downloads.");
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
  await openShare(page, "seed=kowhai&attractors=24001&meander=none");
  await expect(sharing(page).getByRole("status")).toContainText(
    "attractors: 24001 exceeds the widget's limit: 24000 is used",
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
  await choose(page, "Blog");
  await sharing(page).getByText("My blog allows no scripts").click();
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
    for (const place of ["Message", "Blog", "Notebook", "README", "Print"]) {
      await choose(page, place);
      if (place === "Blog") await sharing(page).getByText("My blog allows no scripts").click();
      const overflow = await sharing(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth);
      expect(overflow, place).toBeLessThanOrEqual(0);
      for (const button of await sharing(page).getByRole("button").all()) {
        // Away from the edges: text is laid out in 64ths of a pixel and scrolled in whole ones, so that a button which already is in
        // sight but for one 64th stays as it is.
        await button.evaluate((element) => element.scrollIntoView({ block: "center" }));
        await expect(button).toBeInViewport({ ratio: 1 });
      }
    }
  });
}
