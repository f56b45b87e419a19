/** Listens for pictures that are chosen, dropped onto the map, or pasted. */

export interface ImageDropElements {
  import: HTMLButtonElement;
  picture: HTMLInputElement;
  stage: HTMLElement;
}

export function listenForImages(elements: ImageDropElements, found: (file: File) => void): void {
  const { import: button, picture, stage } = elements;
  const foundIn = (data: DataTransfer | null): void => {
    const file = pictureAmong(data);
    if (file) found(file);
  };
  button.addEventListener("click", () => picture.click());
  picture.addEventListener("change", () => {
    const [file] = picture.files ?? [];
    if (file) found(file);
    // So that the same file can be chosen again.
    picture.value = "";
  });
  stage.addEventListener("dragover", (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  });
  stage.addEventListener("drop", (event) => {
    event.preventDefault();
    foundIn(event.dataTransfer);
  });
  document.addEventListener("paste", (event) => foundIn(event.clipboardData));
}

/**
 * Returns the first picture among dropped or pasted files, or else the first file, so that it is refused with a
 * message.
 */
function pictureAmong(data: DataTransfer | null): File | undefined {
  const files = [...(data?.files ?? [])];
  return files.find(({ type }) => type.startsWith("image/")) ?? files[0];
}
