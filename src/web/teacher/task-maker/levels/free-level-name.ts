import type { TaskLevel } from '#check/task/levels';

import { t } from '../../../kit/i18n';
import words from './words';

/** A name for a further level: empty, gaps, nearly done; the first that no level has. */
export function freeLevelName(levels: readonly Pick<TaskLevel, 'name'>[]): string {
  const names = [t(words.empty), t(words.gaps), t(words.nearly)];
  return names.find((name) => levels.every((level) => level.name !== name)) ?? String(levels.length + 1);
}
