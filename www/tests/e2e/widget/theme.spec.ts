/** Light and dark: the element follows its page while that changes. */

import { expect, test } from "./hosts.ts";
import { heard, listen, pixels, post } from "./post.ts";

const river = (id: string, theme: string): string =>
  `<river-seed id="${id}" recipe="seed=rimu&attractors=300&labels=none" still style="width: 240px" ${theme}></river-seed>`;

for (const [what, css] of [
  ["a class, as blogs have it", ":root { color-scheme: light } :root.night { color-scheme: dark }"],
  ["a class around the post alone", ".night main { color-scheme: dark }"],
]) {
  test(`without a style it follows a page that turns dark and light again by ${what}`, async ({ page, blog }) => {
    const rivers = river("auto", "") + river("dark", 'theme="dark"') + river("light", 'theme="light"');
    const events = await listen(page);
    blog.answer("/", { body: post(`<style>${css}</style>${rivers}`) });
    await page.goto(blog.origin);
    await heard(events, "complete", 3);
    const picture = async (id: string): Promise<string> => (await pixels(page, `#${id}`)).sha256;
    const [dark, light] = [await picture("dark"), await picture("light")];
    expect(dark).not.toBe(light);
    expect(await picture("auto")).toBe(light);
    await page.evaluate(() => document.documentElement.classList.add("night"));
    await expect.poll(() => picture("auto")).toBe(dark);
    await page.evaluate(() => document.documentElement.classList.remove("night"));
    await expect.poll(() => picture("auto")).toBe(light);
    expect([await picture("dark"), await picture("light")]).toEqual([dark, light]);
  });
}
