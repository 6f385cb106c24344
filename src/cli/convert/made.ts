import type { SourceFile } from '#project/project';

/** Work in another form, with sentences on what that form could not hold. */
export interface Made {
  readonly text: string;
  /** Files for a folder; left out: the text is one file. */
  readonly files?: readonly SourceFile[];
  readonly notes: readonly string[];
}
