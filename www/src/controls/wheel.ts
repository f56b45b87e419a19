/** Lets the wheel move a slider that has the focus. Over any other slider it scrolls the panel, as everywhere. */

export function stepByWheel(slider: HTMLInputElement, step: (direction: 1 | -1) => void): void {
  slider.addEventListener(
    "wheel",
    (event) => {
      if (document.activeElement !== slider || slider.matches(":disabled") || event.ctrlKey || event.deltaY === 0)
        return;
      event.preventDefault();
      step(event.deltaY < 0 ? 1 : -1);
    },
    { passive: false },
  );
}
