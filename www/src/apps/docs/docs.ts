/**
 * The script of the pages of the documentation, which are complete without it: it searches, copies, and fills in the site's address.
 * It shares no module with the page, since that would cut the page's scripts into more files.
 */

import { addCopyButton } from "./copying.ts";
import { Search } from "./search.ts";
import { fillInSite } from "./site.ts";

const box = document.getElementById("search");
if (box) new Search(box);
fillInSite(document, document.body.dataset["root"] ?? "../");
for (const block of document.querySelectorAll<HTMLElement>(".code")) addCopyButton(block);
