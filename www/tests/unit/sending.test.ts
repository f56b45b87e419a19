import { expect, test } from "vitest";
import { invitation } from "../../src/apps/page/share/invitation.ts";
import { type Message, type Sharer, send, takesPictures } from "../../src/apps/page/share/send.ts";

const MESSAGE: Message = {
  file: new File(["picture"], "ardenmoor-atlas-portrait.png", { type: "image/png" }),
  text: "Ardenmoor, a country grown from its name. What is yours like?",
  url: "https://rivers.example/?seed=Ardenmoor",
};

/** A system whose share sheet does as it is told. */
function sharer(share: (data: ShareData) => Promise<void>, canShare = true): Sharer {
  return { share: (data = {}) => share(data), canShare: () => canShare };
}

const thrower = (error: unknown): Sharer => sharer(() => Promise.reject(error));

test("the share sheet gets the picture, the line and the link, and nothing else", async () => {
  const given: ShareData[] = [];
  expect(
    await send(
      MESSAGE,
      sharer(async (data) => void given.push(data)),
    ),
  ).toBe("sent");
  expect(given).toEqual([{ files: [MESSAGE.file], text: MESSAGE.text, url: MESSAGE.url }]);
});

test.each([
  [new DOMException("closed", "AbortError"), "cancelled"],
  [new DOMException("late", "NotAllowedError"), "late"],
  [new DOMException("no", "DataError"), "refused"],
  [new TypeError("no such files"), "refused"],
] as const)("what the share sheet says is understood: %s", async (error, outcome) => {
  expect(await send(MESSAGE, thrower(error))).toBe(outcome);
});

test("a system is asked whether it takes pictures, and nothing is thrown where it cannot say", () => {
  expect(takesPictures(sharer(async () => {}))).toBe(true);
  expect(takesPictures(sharer(async () => {}, false))).toBe(false);
  expect(takesPictures({})).toBe(false);
  expect(takesPictures({ share: async () => {} })).toBe(false);
  const broken: Sharer = {
    share: async () => {},
    canShare: () => {
      throw new TypeError("no");
    },
  };
  expect(takesPictures(broken)).toBe(false);
});

test("nothing is handed to a share sheet that takes no pictures", async () => {
  expect(await send(MESSAGE, {})).toBe("refused");
  const asked: ShareData[] = [];
  expect(
    await send(
      MESSAGE,
      sharer(async (data) => void asked.push(data), false),
    ),
  ).toBe("refused");
  expect(asked).toEqual([]);
});

test.each([
  ["Ardenmoor", "Ardenmoor", "Ardenmoor, a country grown from its name."],
  ["anna", "anna", "Anna, a country grown from its name."],
  ["New Zealand", " new zealand", "New Zealand, a country grown from its name."],
  ["Ťap", "ťap", "Ťap, a country grown from its name."],
  ["Zierneks", "42", "Zierneks, a country grown from “42”."],
  ["Home", "tay", "Home, a country grown from “tay”."],
  ["tay2", "tay2", "A country grown from “tay2”."],
  ["مرحبا", "مرحبا", "مرحبا, a country grown from its name."],
  ["Zierneks", "", "Zierneks, a country grown from a word."],
  ["", "", "A country grown from a word."],
  ["<b>", "<b>", "A country grown from “<b>”."],
])("the line for %j from %j", (name, seed, line) => {
  expect(invitation(name, seed)).toBe(`${line} What is yours like?`);
});
