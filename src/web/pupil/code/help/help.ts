import type { Extension } from '@codemirror/state';

import { freeReference } from '#libraries/reference';
import type { ReferenceContext } from '#reference/context';
import { robotReferences } from '#robots/references';
import type { Language } from '../../../kit/i18n';
import type { HelpMaker, HelpOptions } from './help-options';
import { argumentHint } from './argument-hint';
import { cards } from './cards';
import { completion, suggestLate } from './completion';
import { givenBrackets } from './given-brackets';
import { helpLook } from './help-look';
import { loadWords } from './words-on';
import { numberFrame } from '../../lab/number-frame';
import { contextOf } from '../../../session/work/hardware/written-for';

/** Loads the words of a language and gives what makes the help of an editor. */
export async function loadHelp(language: Language): Promise<HelpMaker> {
  const words = await loadWords(language, [...robotReferences, freeReference]);
  const make = ({ written, tries }: HelpOptions): Extension => {
    const full = (): ReferenceContext => contextOf(written());
    return [
      completion(full, words),
      givenBrackets,
      argumentHint(full),
      cards(full, words),
      tries === undefined ? [] : numberFrame(tries),
      helpLook,
    ];
  };
  return { make, suggestLate };
}
