/** Makes the dialogs by which a map leaves the page: as a file, as a word to somebody, as a snippet. */

import type { Recipe } from "../../engine/recipe.ts";
import type { CountryName } from "./country-name.ts";
import { elements } from "./elements.ts";
import { type DownloadEvents, Downloads } from "./save/downloads.ts";
import { SaveDialog } from "./save/save-dialog.ts";
import { SendDialog } from "./share/send-dialog.ts";
import { ShareDialog } from "./share/share-dialog.ts";

export function makeDialogs(
  recipe: Recipe,
  country: CountryName,
  events: DownloadEvents & { letters: (link: string) => Promise<string | undefined> },
): void {
  const downloads = new Downloads(recipe, country, events);
  new SaveDialog(elements.saving, recipe, downloads, () => localStorage);
  const sending = new SendDialog(elements.sending, recipe, country, downloads);
  new ShareDialog(elements.sharing, recipe, downloads, sending, events.letters);
}
