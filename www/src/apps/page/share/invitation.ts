/** The line that goes with a country: to whoever it is sent, and to whoever comes by its link. */

const QUESTION = "What is yours like?";

/** Returns the line for a country of this name, grown from this seed. */
export function invitation(name: string, seed: string): string {
  return `${said(name, seed)} ${QUESTION}`;
}

function said(name: string, seed: string): string {
  const [country, word] = [capitalised(name.trim()), seed.trim()];
  if (word === "") return country === "" ? "A country grown from a word." : `${country}, a country grown from a word.`;
  if (folded(country) === folded(word))
    return isName(word) ? `${country}, a country grown from its name.` : `A country grown from “${word}”.`;
  return `${country}, a country grown from “${word}”.`;
}

/** Returns whether a word can be a name: it has letters, and nothing but what stands between those of a name. */
function isName(word: string): boolean {
  return /^\p{L}[\p{L}\p{M}'’ -]*$/u.test(word);
}

function folded(text: string): string {
  return text.normalize("NFC").toLowerCase();
}

/** Returns a name with a capital, as titles have it, though people type small letters. */
function capitalised(name: string): string {
  const [first = "", ...rest] = name;
  return first.toUpperCase() + rest.join("");
}
