/** The elements that index.html gives the page to fill. */

import { find } from "./dom.ts";

export const parts = {
  sheet: find("#sheet", HTMLElement),
  frame: find("#frame", HTMLElement),
  canvas: find("#canvas", HTMLCanvasElement),
  facade: find("#facade", HTMLElement),
  failure: find("#failure", HTMLElement),
  notices: find("#notices", HTMLElement),
  title: find("#title", HTMLElement),
  caption: find("#caption", HTMLElement),
  announcement: find("#announcement", HTMLElement),
  seedForm: find("#seed-form", HTMLFormElement),
  seed: find("#seed", HTMLInputElement),
  dice: find("#dice", HTMLButtonElement),
  download: find("#download", HTMLButtonElement),
  copy: find("#copy", HTMLButtonElement),
  reset: find("#reset", HTMLButtonElement),
  shared: find("#shared", HTMLElement),
  seedHelp: find("#seed-help", HTMLElement),
  transport: {
    play: find("#play", HTMLButtonElement),
    restart: find("#restart", HTMLButtonElement),
    speed: find("#speed", HTMLInputElement),
    speedShown: find("#speed-shown", HTMLElement),
  },
  presets: find("#presets", HTMLElement),
  controls: find("#controls", HTMLElement),
};
