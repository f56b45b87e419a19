// Draws the picture of each map that has none yet, in the browser of an author who looks at the page, and keeps it in the media library.

// One at a time: a draft may hold many.
for (const map of document.querySelectorAll("river-seed[data-poster]")) await keep(map);

async function keep(map) {
  try {
    const { poster, media, post, nonce } = map.dataset;
    const { png, seed } = await drawn(map);
    const picture = await packed(png);
    const name = `${poster}.${picture.type.replace("image/", "")}`;
    const headers = {
      "X-WP-Nonce": nonce,
      "Content-Type": picture.type,
      "Content-Disposition": `attachment; filename="${name}"`,
    };
    const address = new URL(media, location.href);
    const facts = { post, river_seed: poster, alt_text: `Rivers grown from “${seed}”` };
    for (const [key, value] of Object.entries(facts)) address.searchParams.set(key, value);
    const answer = await fetch(address, { method: "POST", headers, body: picture });
    if (!answer.ok) throw new Error(`the media library answers ${answer.status}`);
  } catch (error) {
    console.warn(`river-seed: no picture is kept of this map: ${error.message}`);
  }
}

/** Draws a map as readers of a light page see it, whatever this author's page looks like; its picture, and its seed. */
async function drawn(map) {
  const copy = document.createElement("river-seed");
  for (const name of ["seed", "recipe", "edition"])
    if (map.hasAttribute(name)) copy.setAttribute(name, map.getAttribute(name));
  copy.setAttribute("theme", "light");
  copy.style.display = "none";
  document.body.append(copy);
  try {
    const png = await copy.toBlob({ longSide: Number(map.dataset.size) });
    return { png, seed: new URLSearchParams(copy.link).get("seed") };
  } finally {
    copy.remove();
  }
}

/** Makes a WebP of a PNG, an eighth as large, where the browser can. */
async function packed(png) {
  const bitmap = await createImageBitmap(png);
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  canvas.getContext("2d").drawImage(bitmap, 0, 0);
  return await canvas.convertToBlob({ type: "image/webp", quality: 0.8 });
}
