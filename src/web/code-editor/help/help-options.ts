import type { Extension } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';

import type { ReferenceContext } from '#reference/context';
import type { Language } from '../../i18n';

/** What the help needs to know; the functions are asked again every time. */
export interface HelpOptions {
  readonly language: Language;
  /** Board, firmware, libraries and other files of the project, for the file that is shown. */
  readonly context: () => Omit<ReferenceContext, 'modules'> & { readonly robot: string | null };
}

/** The help of one language, once it is loaded. */
export interface HelpMaker {
  readonly make: (options: HelpOptions) => Extension;
  /** Suggests something for what was typed while it was loading. */
  readonly suggestLate: (view: EditorView) => void;
}
