/** The level that a pupil has chosen. Apart from `levels.ts`: the page asks before it reads a task. */
import { isRecord } from '#core/record';
import type { Carried } from '#project/project';

/** Limits of levels. Chosen: a card has room for three names in a row. */
export const levelLimits = { levels: { min: 1, max: 3 }, nameCharacters: 40 } as const;

/** The place of the level that a pupil has chosen, in a task that was handed out; `null`: none yet. */
export function chosenLevel(task: Carried | undefined): number | null {
  const level = task?.['level'];
  return typeof level === 'number' && Number.isInteger(level) && level >= 0 && level < levelLimits.levels.max
    ? level
    : null;
}

/** Number of the card's hints that the chosen level of a pupil's task allows; `Infinity`: all. */
export function hintsAllowed(task: Carried | undefined): number {
  const [levels, place] = [task?.['levels'], chosenLevel(task)];
  const level: unknown = place === null || !Array.isArray(levels) ? undefined : levels[place];
  const hints = isRecord(level) ? level['hints'] : undefined;
  return typeof hints === 'number' ? hints : Infinity;
}
