/** Gives code a button that copies it, where the browser lets pages copy. */

const COPY = "Copy";
const COPIED = "Copied";
const FAILED = "Not copied: select the text instead";

/** Adds the button to a block of code. */
export function addCopyButton(block: HTMLElement): void {
  const code = block.querySelector("code");
  if (!code || navigator.clipboard === undefined) return;
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = COPY;
  button.addEventListener("click", async () => {
    button.textContent = (await isCopied(code.textContent ?? "")) ? COPIED : FAILED;
  });
  // Until the reader looks elsewhere.
  for (const away of ["blur", "pointerleave"])
    button.addEventListener(away, () => {
      button.textContent = COPY;
    });
  // The name is announced when it changes.
  button.setAttribute("aria-live", "polite");
  (block.querySelector("figcaption") ?? block).append(button);
}

async function isCopied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
