import { FILE_BYTES } from '#project/project';
import type { Range, Reader } from '#scene/reader';
import { sceneLimits } from '#scene/scene';
import { levelLimits } from './chosen-level';

/** One of the start programs among which pupils choose: empty, with gaps, nearly done. */
export interface TaskLevel {
  /** Its name on the card, in the teacher's words; unlike the others of the task. */
  readonly name: string;
  /** The `main.py` to begin with. */
  readonly text: string;
  /** Its lines that stay as they are, from 1. */
  readonly lines: readonly number[];
  /** Number of the card's hints that its pupils may ask for, from the first on; left out: all. */
  readonly hints?: number;
}

/** Reads the levels of a task; `undefined`: it has none. @param linesIn reads numbers of lines */
export function readLevels(
  value: unknown,
  reader: Reader,
  linesIn: (value: unknown, path: string, reader: Reader) => readonly number[],
): readonly TaskLevel[] | undefined {
  if (value === undefined) return undefined;
  const list = reader.list(value, 'task.levels', levelLimits.levels satisfies Range);
  const levels = list.map((entry, place): TaskLevel => {
    const path = `task.levels[${String(place)}]`;
    const fields = reader.fields(entry, path, ['name', 'text', 'lines', 'hints']);
    const name = reader.text(fields['name'], `${path}.name`, levelLimits.nameCharacters);
    if (fields['name'] === '') reader.report('missing', `${path}.name`, '', 'must not be empty.');
    const text = reader.text(fields['text'], `${path}.text`, FILE_BYTES);
    const lines = linesIn(fields['lines'], `${path}.lines`, reader);
    if (fields['hints'] === undefined) return { name, text, lines };
    const hints = reader.whole(fields['hints'], `${path}.hints`, { min: 0, max: sceneLimits.hints });
    return { name, text, lines, hints };
  });
  for (const [place, { name }] of levels.entries()) {
    if (levels.findIndex((other) => other.name === name) === place) continue;
    const what = `another level is called ${JSON.stringify(name)}.`;
    reader.report('duplicate-id', `task.levels[${String(place)}].name`, name, what);
  }
  return levels.length === 0 ? undefined : levels;
}

/** The levels for a file. */
export const levelsData = (levels: readonly TaskLevel[]): readonly object[] =>
  levels.map(({ lines, ...level }) => ({ ...level, ...(lines.length > 0 && { lines }) }));

/** The name of the level from which a hand-in says that it comes; `null`: it says none, or the task has no such level. */
export const levelName = (levels: readonly TaskLevel[] | undefined, level: number | undefined): string | null =>
  level === undefined ? null : (levels?.[level]?.name ?? null);
