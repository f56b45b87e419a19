/**
 * The script of the pages of the documentation, which are complete without it: it searches and copies.
 * It shares no module with the page, since that would cut the page's scripts into more files.
 */

import { addCopyButton } from "./copying.ts";
import { Search } from "./search.ts";

const box = document.getElementById("search");
if (box) new Search(box);
for (const block of document.querySelectorAll<HTMLElement>(".code")) addCopyButton(block);
