import { type CDPSession, expect, type Page, test } from "@playwright/test";
import { openUnfolded } from "./riverpage.ts";
import { OPENED, openFailed } from "./states.ts";

/** What a button can be in; the browser is told, so that no pointer has to be moved to each. */
const STATES = {
  "at rest": [],
  "under the pointer": ["hover"],
  "with the focus": ["focus", "focus-visible"],
  "being pressed": ["hover", "active"],
  "being pressed, with the focus": ["hover", "active", "focus"],
};

/** WCAG's contrast of text to its ground, for AA; of what cannot be used it asks nothing, but it is to be seen. */
const READABLE = 4.5;
const VISIBLE = 2;

async function force(page: Page, states: string[]): Promise<CDPSession> {
  const session = await page.context().newCDPSession(page);
  await session.send("DOM.enable");
  await session.send("CSS.enable");
  const { root } = await session.send("DOM.getDocument", { depth: 0 });
  const { nodeIds } = await session.send("DOM.querySelectorAll", { nodeId: root.nodeId, selector: "button" });
  const forced = nodeIds.map((nodeId) => session.send("CSS.forcePseudoState", { nodeId, forcedPseudoClasses: states }));
  await Promise.all(forced);
  return session;
}

/** The buttons that are seen whose text or icon has too little contrast. */
function faint(page: Page): Promise<string[]> {
  return page.evaluate(
    ([readable, visible]) => {
      const context = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
      if (!context) throw new Error("no canvas");
      const paint = (colour: string, opacity = 1): void => {
        context.globalAlpha = opacity;
        context.fillStyle = colour;
        context.fillRect(0, 0, 1, 1);
      };
      const light = (): number => {
        const [red = 0, green = 0, blue = 0] = [...context.getImageData(0, 0, 1, 1).data].map((byte) => {
          const value = byte / 255;
          return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
        });
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
      };
      const around = (element: Element): Element[] =>
        element.parentElement ? [...around(element.parentElement), element] : [element];
      const contrast = (element: Element, colour: string): number => {
        paint("white");
        for (const one of around(element)) paint(getComputedStyle(one).backgroundColor);
        const ground = light();
        const opacity = around(element).reduce((share, one) => share * Number(getComputedStyle(one).opacity), 1);
        paint(colour, opacity);
        const text = light();
        return (Math.max(ground, text) + 0.05) / (Math.min(ground, text) + 0.05);
      };
      const coloursOf = (element: Element): string[] => {
        const { color, fill, stroke } = getComputedStyle(element);
        if (element instanceof SVGElement) return [fill, stroke].filter((paint) => paint !== "none");
        return [...element.childNodes].some(({ nodeType, textContent }) => nodeType === 3 && textContent?.trim())
          ? [color]
          : [];
      };
      return [...document.querySelectorAll("button")]
        .filter((button) => button.checkVisibility())
        .flatMap((button) =>
          [button, ...button.querySelectorAll("*")].flatMap((part) =>
            coloursOf(part)
              .map((colour) => contrast(part, colour))
              .filter((found) => !(found >= (button.disabled ? visible : readable)))
              .map((found) => `${found.toFixed(2)}: ${part.outerHTML.slice(0, 100)}`),
          ),
        );
    },
    [READABLE, VISIBLE] as const,
  );
}

async function expectReadable(page: Page, where: string): Promise<void> {
  for (const [state, classes] of Object.entries(STATES)) {
    const session = await force(page, classes);
    expect(await faint(page), `${where}, ${state}`).toEqual([]);
    await session.detach();
  }
}

for (const colorScheme of ["light", "dark"] as const) {
  test.describe(`every button can be read, ${colorScheme}`, () => {
    test.use({ colorScheme });

    test("at rest, under the pointer, with the focus, while it is pressed, and when it stays so", async ({ page }) => {
      // A pressed style, a pressed preset, and notices.
      await openUnfolded(page, "preset=trimmed-curl&attractors=300&depth=3");
      await expect(page.getByRole("button", { pressed: true })).toHaveCount(2);
      for (const [where, open] of Object.entries(OPENED)) {
        await open(page);
        await expectReadable(page, where);
      }
    });

    test("when the engine has failed", async ({ page }) => {
      await openFailed(page);
      await page.evaluate(() => {
        for (const button of document.querySelectorAll("button")) button.disabled = false;
      });
      await expectReadable(page, "failed");
    });

    test("and seen when it can do nothing", async ({ page }) => {
      await openUnfolded(page, "preset=trimmed-curl&attractors=300&depth=3");
      await page.evaluate(() => {
        for (const button of document.querySelectorAll("button")) button.disabled = true;
      });
      expect(await faint(page)).toEqual([]);
    });
  });
}
