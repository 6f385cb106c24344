import type { BoardType } from '#board/boards/board-type';
import { byLanguage } from '#core/words';
import { freeReference } from '#libraries/reference';
import type { ReferenceContext } from '#reference/context';
import { loadTextsWith, type ReferenceTexts } from '#reference/texts';
import { robotReferences } from '#robots/references';

import type { Language } from '../../kit/i18n';
import type { GuideContent } from './content/content';

/** The help of each language: other languages are not loaded. */
const contents = byLanguage(import.meta.glob<GuideContent>('../words/guide/*.json', { import: 'default' }));

/** The help in one language: its own words, and those of the reference. */
export interface Guide {
  readonly content: GuideContent;
  readonly words: ReferenceTexts;
}

/** Fetches the help of a language. Rejects without a connection. */
export async function loadGuide(language: Language, robot: string | null): Promise<Guide> {
  const libraries = [freeReference, ...robotReferences.filter((it) => it.robot === robot)];
  const [content, words] = await Promise.all([contents[language](), loadTextsWith(language, libraries)]);
  return { content, words };
}

/** Modules of the board that lessons use, after its own. */
const BOARD_MODULES = ['music', 'radio', 'log', 'neopixel', 'random', 'time'] as const;

/** The modules whose commands the help lists: those of the robot in use first, then those of the board. */
export function modulesFor(robot: string | null, board: BoardType): readonly string[] {
  const own = robotReferences.find((it) => it.robot === robot)?.modules ?? [];
  return [...own.map(({ name }) => name), ...board.modules.slice(0, 1), ...BOARD_MODULES];
}

/** The context of the reference that lists their commands. */
export const referenceFor = (
  robot: string | null,
  { api }: BoardType,
  features: ReferenceContext['features'],
): ReferenceContext => ({
  board: api,
  features,
  modules: robotReferences.find((it) => it.robot === robot)?.modules ?? [],
  files: {},
});
