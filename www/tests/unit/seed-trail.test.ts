import { beforeEach, describe, expect, it } from "vitest";
import { SeedTrail } from "../../src/apps/page/panel/seed-trail.ts";

/** A button that can be pressed, as far as a trail knows one. */
class Button {
  disabled = false;
  #press = (): void => {};

  addEventListener(_: string, press: () => void): void {
    this.#press = press;
  }

  press(): void {
    if (!this.disabled) this.#press();
  }
}

describe("the trail of seeds", () => {
  let [previous, next] = [new Button(), new Button()];
  let shown = "";
  let trail: SeedTrail;
  const show = (seed: string): void => {
    shown = seed;
    trail.show(seed);
  };

  beforeEach(() => {
    [previous, next] = [new Button(), new Button()];
    const elements = { previous, next } as unknown as ConstructorParameters<typeof SeedTrail>[0];
    trail = new SeedTrail(elements, show);
    show("skye");
  });

  it("leads nowhere at first", () => {
    show("skye");
    expect([previous.disabled, next.disabled]).toEqual([true, true]);
  });

  it("leads back to all seeds, and forth again", () => {
    for (const seed of ["rimu", "moana"]) show(seed);
    expect(next.disabled).toBe(true);
    previous.press();
    expect(shown).toBe("rimu");
    previous.press();
    expect([shown, previous.disabled]).toEqual(["skye", true]);
    next.press();
    next.press();
    expect([shown, next.disabled]).toEqual(["moana", true]);
  });

  it("is another from where another seed is taken", () => {
    show("rimu");
    previous.press();
    show("como");
    expect(next.disabled).toBe(true);
    previous.press();
    expect(shown).toBe("skye");
    next.press();
    expect(shown).toBe("como");
  });

  it("follows undo and redo, which lead along it", () => {
    show("rimu");
    show("skye");
    expect([previous.disabled, next.disabled]).toEqual([true, false]);
    next.press();
    expect(shown).toBe("rimu");
  });
});
