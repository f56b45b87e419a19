// Read before the page is first painted, so that the picture's place has the river's shape from the start, and nothing
// moves when the river comes. A plain script, since modules come later. It only guesses: the engine reads the link.
{
  const { hash, search } = location;
  const text = new URLSearchParams(hash.includes("=") ? hash.slice(1) : search).get("aspect")?.trim();
  const aspect = text ? Number(text) : Number.NaN;
  const shape = Math.min(4, Math.max(0.25, aspect));
  if (Number.isFinite(aspect)) document.documentElement.style.setProperty("--aspect", String(shape));
}
