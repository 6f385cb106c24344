/** A text in its languages, and where it stands. `{name}` in it is the place of a value. */
export interface Entry {
  readonly where: string;
  readonly texts: Readonly<Partial<Record<'de' | 'fr' | 'it' | 'en', string>>>;
}

/** Every text of the app and of the courses. */
export function allTexts(): Promise<Entry[]>;

/** The faults of the texts in these files (path in the repository → its text), a line each. */
export function problemsOf(
  files: ReadonlyMap<string, string>,
  same?: Readonly<Record<'fr' | 'it', ReadonlySet<string>>>,
): string[];
