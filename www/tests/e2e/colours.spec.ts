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

/** Puts all buttons into states until the session is detached. If one leaves the page meanwhile, all are sought again. */
async function force(page: Page, states: string[]): Promise<CDPSession> {
  const session = await page.context().newCDPSession(page);
  await session.send("DOM.enable");
  await session.send("CSS.enable");
  const { root } = await session.send("DOM.getDocument", { depth: 0 });
  await expect(async () => {
    const { nodeIds } = await session.send("DOM.querySelectorAll", { nodeId: root.nodeId, selector: "button" });
    await Promise.all(
      nodeIds.map((nodeId) => session.send("CSS.forcePseudoState", { nodeId, forcedPseudoClasses: states })),
    );
  }).toPass();
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

const SCHEMES = ["light", "dark"] as const;
type Scheme = (typeof SCHEMES)[number];

/** On a light page and on a dark one, once no colour is on its way any more. */
async function inBoth(page: Page, look: (colorScheme: Scheme) => Promise<void>): Promise<void> {
  for (const colorScheme of SCHEMES) {
    await page.emulateMedia({ colorScheme });
    await page.evaluate(() => Promise.all(document.getAnimations().map((animation) => animation.finished)));
    await look(colorScheme);
  }
}

/** Looks at the page while no button can be used. */
async function whileIdle(page: Page, look: () => Promise<void>): Promise<void> {
  const usable = page.locator("button:enabled");
  await usable.evaluateAll((buttons: HTMLButtonElement[]) => {
    for (const button of buttons) Object.assign(button, { disabled: true }).dataset["wasUsable"] = "";
  });
  await look();
  await page.locator("[data-was-usable]").evaluateAll((buttons: HTMLButtonElement[]) => {
    for (const button of buttons) {
      button.disabled = false;
      delete button.dataset["wasUsable"];
    }
  });
}

test("every button can be read at rest, under the pointer, with the focus, while it is pressed, and when it stays so @core", async ({
  page,
}) => {
  // A pressed style, a pressed preset, and notices.
  await openUnfolded(page, "preset=trimmed-curl&attractors=300&depth=3");
  await expect(page.getByRole("button", { pressed: true })).toHaveCount(2);
  await whileIdle(page, () =>
    inBoth(page, async (scheme) => expect(await faint(page), `of no use, ${scheme}`).toEqual([])),
  );
  for (const [where, open] of Object.entries(OPENED)) {
    await open(page);
    await inBoth(page, (scheme) => expectReadable(page, `${where}, ${scheme}`));
  }
});

test("every button can be read when the engine has failed", async ({ page }) => {
  await openFailed(page);
  await page.evaluate(() => {
    for (const button of document.querySelectorAll("button")) button.disabled = false;
  });
  await inBoth(page, (scheme) => expectReadable(page, `failed, ${scheme}`));
});
