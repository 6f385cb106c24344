import { FILE_BYTES } from '#project/project';
import type { Range, Reader } from '#scene/reader';
import type { Carried } from '#project/project';

/** One of the start programs among which pupils choose: empty, with gaps, nearly done. */
export interface TaskLevel {
  /** Its name on the card, in the teacher's words; unlike the others of the task. */
  readonly name: string;
  /** The `main.py` to begin with. */
  readonly text: string;
  /** Its lines that stay as they are, from 1. */
  readonly lines: readonly number[];
}

/** Limits of levels. Chosen: a card has room for three names in a row. */
export const levelLimits = { levels: { min: 1, max: 3 }, nameCharacters: 40 } as const;

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
    const fields = reader.fields(entry, path, ['name', 'text', 'lines']);
    const name = reader.text(fields['name'], `${path}.name`, levelLimits.nameCharacters);
    if (fields['name'] === '') reader.report('missing', `${path}.name`, '', 'must not be empty.');
    const text = reader.text(fields['text'], `${path}.text`, FILE_BYTES);
    return { name, text, lines: linesIn(fields['lines'], `${path}.lines`, reader) };
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
  levels.map(({ name, text, lines }) => ({ name, text, ...(lines.length > 0 && { lines }) }));

/** The place of the level that a pupil has chosen, in a task that was handed out; `null`: none yet. */
export function chosenLevel(task: Carried | undefined): number | null {
  const level = task?.['level'];
  return typeof level === 'number' && Number.isInteger(level) && level >= 0 && level < levelLimits.levels.max
    ? level
    : null;
}

/** The name of the level from which a hand-in says that it comes; `null`: it says none, or the task has no such level. */
export const levelName = (levels: readonly TaskLevel[] | undefined, level: number | undefined): string | null =>
  level === undefined ? null : (levels?.[level]?.name ?? null);
