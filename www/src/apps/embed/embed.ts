/** The script of embed.html: one river and nothing else, for an iframe on somebody's page. */

import "./embed.css";
import "../widget/define.ts";
import { linkOf } from "../../browser/address.ts";
import { el, find } from "../../browser/dom.ts";
import { aspectOf } from "../widget/attributes.ts";
import { Heights } from "./heights.ts";
import { HostPage } from "./host-page.ts";
import { heightMessage } from "./messages.ts";
import { correctionsNote, failureNote } from "./notes.ts";
import { readQuery } from "./query.ts";

// The text that is shown until this script runs.
find("#missing", HTMLElement).remove();

const root = document.documentElement;
const host = new HostPage(window);
const heights = new Heights((height) => host.tell(heightMessage(height)));
const { recipe, attributes } = readQuery(linkOf(location));
const river = el("river-seed", { ...Object.fromEntries(attributes), recipe });
let aspect = 1;

/** Passes the river's shape to the frame's style sheet, which needs it to fit the whole river in. */
function shape(link: string): void {
  aspect = aspectOf(link);
  root.style.setProperty("--aspect", String(aspect));
}

/**
 * Measures the height that the frame should have: by the river's shape at this width, or by the failure note in its
 * place.
 */
function measure(): void {
  const hasFailed = root.dataset["state"] === "failed";
  heights.changed(hasFailed ? river.getBoundingClientRect().height : window.innerWidth / aspect);
}

river.addEventListener("ready", ({ detail }) => {
  shape(detail.link);
  root.dataset["state"] = "ready";
  if (detail.notices.length > 0) document.body.append(correctionsNote(detail.notices));
  measure();
});

river.addEventListener("error", ({ detail }) => {
  if (root.dataset["state"] === "ready") {
    document.body.append(correctionsNote([detail]));
    return;
  }
  root.dataset["state"] = "failed";
  river.replaceChildren(failureNote(detail));
  measure();
});

/** Sets the theme of the river and of the notes over it. */
function dress(theme: string): void {
  river.setAttribute("theme", theme);
  root.dataset["theme"] = theme;
}

shape(recipe);
dress(river.getAttribute("theme") ?? "auto");
host.onTheme(dress);
new ResizeObserver(measure).observe(root);
new ResizeObserver(measure).observe(river);
document.body.append(el("main", {}, river));
