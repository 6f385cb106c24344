import type { Extension } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';

import type { Language } from '../../../kit/i18n';
import type { NumberTries } from '../../lab/number-frame';
import type { Written } from '../../../session/work/hardware/written-for';

/** The data that the help needs; the function is called again every time. */
export interface HelpOptions {
  readonly language: Language;
  /** The file that is shown, and what it is written for. */
  readonly written: () => Written;
  /** Left out: numbers are not tried out here. */
  readonly tries?: NumberTries;
}

/** The help of one language, once it is loaded. */
export interface HelpMaker {
  readonly make: (options: HelpOptions) => Extension;
  /** Suggests something for what was typed while it was loading. */
  readonly suggestLate: (view: EditorView) => void;
}
