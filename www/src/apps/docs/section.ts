/** A part of a page that the search finds: what stands under one heading. */
export interface Section {
  /** Its address, relative to the folder of the pages. */
  readonly address: string;
  /** The title of its page. */
  readonly page: string;
  readonly heading: string;
  readonly text: string;
  /** The code in it. */
  readonly code: string;
}
