import { expect, test } from "vitest";
import { CountryName } from "../../../src/apps/page/country-name.ts";
import { Recipe } from "../../../src/engine/recipe.ts";
import { engine } from "../../whole.ts";

const recipeOf = (link: string): Recipe => new Recipe((text, options) => engine.readLink(text, options), link);
const title = (name: string) => [{ mark: "t", name, isOwn: false }];

test("a country is called by its seed until its names are known, then by its title", () => {
  const country = new CountryName(recipeOf("seed=42"));
  expect(country.text).toBe("42");
  expect(country.learn([])).toBe(false);
  expect(country.learn(title("Zierneks"))).toBe(true);
  expect(country.text).toBe("Zierneks");
  expect(country.learn(title("Zierneks"))).toBe(false);
});

test("another seed or other names make the title unknown again, and nothing else does", () => {
  const recipe = recipeOf("seed=42");
  const country = new CountryName(recipe);
  country.learn(title("Zierneks"));
  recipe.set([["style", "night"]]);
  expect(country.text).toBe("Zierneks");
  recipe.set([["names", "t.Home"]]);
  expect(country.text).toBe("42");
  country.learn(title("Home"));
  expect(country.text).toBe("Home");
  recipe.set([["seed", "43"]]);
  expect(country.text).toBe("43");
});

test("a title that was taken away leaves the seed", () => {
  const country = new CountryName(recipeOf("seed=tay"));
  country.learn(title(""));
  expect(country.text).toBe("tay");
});
