import type { Extension } from '@codemirror/state';

import { freeReference } from '#libraries/reference';
import type { ReferenceContext } from '#reference/context';
import type { RobotReference } from '#reference/types';
import { robotReferences } from '#robots/references';
import type { Language } from '../../i18n';
import type { HelpMaker, HelpOptions } from './help-options';
import { argumentHint } from './argument-hint';
import { cards } from './cards';
import { completion, suggestLate } from './completion';
import { givenBrackets } from './given-brackets';
import { helpLook } from './help-look';
import { loadWords } from './words';

/** Loads the words of a language and gives what makes the help of an editor. */
export async function loadHelp(language: Language): Promise<HelpMaker> {
  const words = await loadWords(language, [...robotReferences, freeReference]);
  const make = ({ context }: HelpOptions): Extension => {
    const full = (): ReferenceContext => {
      const { robot, ...rest } = context();
      return { ...rest, modules: modulesFor(robot) };
    };
    return [completion(full, words), givenBrackets, argumentHint(full), cards(full, words), helpLook];
  };
  return { make, suggestLate };
}

/** All libraries, those of the chosen robot first: where two have the same name, its own counts. */
function modulesFor(robot: string | null): RobotReference['modules'] {
  const isChosen = (it: RobotReference): boolean => it.robot === robot;
  const others = robotReferences.filter((it) => !isChosen(it));
  return [...robotReferences.filter(isChosen), ...others, freeReference].flatMap(({ modules }) => modules);
}
