/** What a reader has answered in all, kept on the reader's own device and nowhere else. */

export interface Tally {
  asked: number;
  right: number;
}

const KEPT = "riverseed study";

/** Nothing, where nothing may be kept or what was is not ours. */
export function tallyIn(storage: () => Storage): Tally {
  try {
    const { asked, right } = JSON.parse(storage().getItem(KEPT) ?? "") as Tally;
    if (Number.isSafeInteger(asked) && Number.isSafeInteger(right) && right >= 0 && right <= asked)
      return { asked, right };
  } catch {
    // As good as none.
  }
  return { asked: 0, right: 0 };
}

export function keepTally(tally: Tally, storage: () => Storage): void {
  try {
    storage().setItem(KEPT, JSON.stringify(tally));
  } catch {
    // It counts from nothing the next time.
  }
}
