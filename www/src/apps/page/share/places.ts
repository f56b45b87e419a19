/** The places where a country is shared, and what is said about the one thing that is given for each. */

export type Place = "message" | "blog" | "notebook" | "readme" | "print";

export const PLACES: readonly (readonly [place: Place, words: { name: string; help: string }])[] = [
  ["message", { name: "Message", help: "A link to this very country, for a message, a post or a bookmark." }],
  [
    "blog",
    {
      name: "Blog",
      help:
        "Shows the map in your post, light or dark as your page is. In WordPress it goes into a Custom HTML block, in Ghost " +
        "into an HTML card, in Hugo into a shortcode. Save the picture beside your post: it is there until the map appears, " +
        "and where it cannot.",
    },
  ],
  [
    "notebook",
    {
      name: "Notebook",
      help: "The address of the map alone, for Notion (/embed), Obsidian and others that embed a page.",
    },
  ],
  [
    "readme",
    {
      name: "README",
      help: "Markdown: a still picture that leads here, for a README or a forum. Save the picture beside your text.",
    },
  ],
  ["print", { name: "Print", help: "The map alone on a sheet, by your browser’s print view." }],
];
