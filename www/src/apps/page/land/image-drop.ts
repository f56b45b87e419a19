/** The ways in which a picture comes to the page: chosen, dropped onto the map, or pasted. */

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
    // The same file may be chosen again, after a change.
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

/** The first picture among what was dropped or pasted; if there is none, any file there is, to be refused by name. */
function pictureAmong(data: DataTransfer | null): File | undefined {
  const files = [...(data?.files ?? [])];
  return files.find(({ type }) => type.startsWith("image/")) ?? files[0];
}
