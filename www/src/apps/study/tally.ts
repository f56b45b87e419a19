/** The visitor's total score, which is kept on the visitor's device and nowhere else. */

export interface Tally {
  asked: number;
  right: number;
}

const KEPT = "riverseed study";

/** Reads the tally. It is zero if storage is not allowed or contains something else. */
export function tallyIn(storage: () => Storage): Tally {
  try {
    const { asked, right } = JSON.parse(storage().getItem(KEPT) ?? "") as Tally;
    if (Number.isSafeInteger(asked) && Number.isSafeInteger(right) && right >= 0 && right <= asked)
      return { asked, right };
  } catch {
    // The same as no tally.
  }
  return { asked: 0, right: 0 };
}

export function keepTally(tally: Tally, storage: () => Storage): void {
  try {
    storage().setItem(KEPT, JSON.stringify(tally));
  } catch {
    // The next visit starts from zero.
  }
}
