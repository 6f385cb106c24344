/** A section of a book: a page to read. */
export interface Section {
  /** Unique in the book; the same in every language. */
  readonly id: string;
  readonly title: string;
  /** Its text in the small markup of tasks. */
  readonly text: string;
  /** A piece of advice below the text; empty: none. */
  readonly tip: string;
  /** The address of a picture of that place beside the page, 1180 × 700; empty: none. */
  readonly picture: string;
  /** The place in the program that it is about: a page's address without `#`, or `@` and a mode of the arena. Empty: none. */
  readonly show: string;
}

/** A chapter with its sections, of which it has at least one. */
export interface Chapter {
  readonly id: string;
  readonly title: string;
  readonly sections: readonly Section[];
}

/** A book in one language. */
export type Book = readonly Chapter[];
