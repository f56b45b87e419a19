/** Which controls have nothing to do in a recipe, and why: the one place where that is decided. */

type Values = ReadonlyMap<string, string>;

interface Rule {
  readonly keys: readonly string[];
  /** Whether the keys do nothing in this recipe. */
  readonly when: (values: Values) => boolean;
  /** Why, said in place of the help. */
  readonly reason: string;
}

const is =
  (key: string, ...texts: string[]) =>
  (values: Values): boolean =>
    texts.includes(values.get(key) ?? "");

/** The land that the core shapes: a drawn land of which nothing is drawn is the whole rectangle. */
function shape(values: Values): string {
  const land = values.get("land") ?? "";
  return land === "drawn" && values.get("outline") === "" ? "rectangle" : land;
}

const on =
  (...lands: string[]) =>
  (values: Values): boolean =>
    lands.includes(shape(values));

/** All that meandering goes by, but its model. */
const MEANDERS = [
  "meander-rounds",
  "meander-strength",
  "meander-mix",
  "gentle",
  "great",
  "flat",
  "neck",
  "buffer",
  "taper",
];

/** Bends grow in proportion to widths, so that of rivers that meander the skeleton shows widths, too. */
const meanders = (values: Values): boolean => !is("meander", "none")(values) && !is("meander-rounds", "0")(values);

/** Of several rules for a key the first that holds gives the reason. */
const RULES: readonly Rule[] = [
  { keys: ["sea", "rough"], when: on("rectangle"), reason: "The whole rectangle is land: it has no coast." },
  { keys: ["sea", "sides"], when: on("drawn"), reason: "The drawing says where the sea is." },
  { keys: ["sides"], when: on("island", "archipelago"), reason: "This land has the sea all round." },
  { keys: ["sides"], when: on("basin"), reason: "Rivers run to the lake in the middle." },
  { keys: ["mouths", "apart"], when: is("growth", "brownian"), reason: "A Brownian tree finds its own mouths." },
  { keys: ["apart"], when: on("rectangle"), reason: "The whole rectangle is land: it has no coast." },
  { keys: ["sensitivity"], when: is("growth", "colonize"), reason: "Only a Brownian tree has it." },
  {
    keys: ["attractors", "scatter", "reach", "kill", "step"],
    when: is("growth", "brownian"),
    reason: "A Brownian tree has no attractors.",
  },
  {
    keys: ["momentum", "curl", "stretch"],
    when: is("growth", "brownian"),
    reason: "A Brownian tree bends as its particles wander.",
  },
  { keys: ["stretch"], when: is("curl", "0"), reason: "Only rivers with curl have stretches." },
  { keys: MEANDERS, when: is("meander", "none"), reason: "Rivers do not meander here." },
  { keys: MEANDERS.slice(1), when: is("meander-rounds", "0"), reason: "Without a round no river meanders." },
  { keys: ["meander-mix"], when: is("meander", "flow"), reason: "Only bends that grow outward have it." },
  { keys: ["meander-mix"], when: is("meander-strength", "0"), reason: "Bends without strength do not move." },
  { keys: ["flat"], when: is("great", "0"), reason: "No great rivers, none that is flat." },
  {
    keys: ["meander-strength", "meander-mix", "neck", "buffer", "taper"],
    when: (values) => is("great", "0")(values) && is("gentle", "0")(values),
    reason: "No river meanders, great or gently.",
  },
  {
    keys: ["width", "vary"],
    when: (values) => is("style", "skeleton")(values) && !meanders(values),
    reason: "The skeleton is one pixel wide everywhere.",
  },
];

/** Why a key does nothing in a recipe; nothing if it does something. */
export function idleReason(key: string, values: Values): string | undefined {
  return RULES.find(({ keys, when }) => keys.includes(key) && when(values))?.reason;
}
