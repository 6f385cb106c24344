import type { Texts } from '#core/languages';
import { adviceFor, type Failure } from './advice';
import type { AtTable } from './at-table';
import { adviceTexts } from './say';
import type { Source } from './syntax-advice';

/** The programs of a board by their names. */
type Files = Readonly<Record<string, string>>;

/**
 * Explains the error that ended a program and what helps, as the page's console does; `null`: no explanation.
 *
 * @param table what is plugged in
 */
export const adviceOfRun = (failure: Failure, files: Files, table: AtTable | null = null): Texts | null =>
  adviceTexts(adviceFor(failure, sourceOf(failure, files), table));

/** The line that an error names: the last one of its traceback that is in one of the pupil's files. */
function sourceOf({ traceback = '' }: Failure, files: Files): Source | null {
  const places = [...traceback.matchAll(/^ *File "([^"]*)", line (\d+)/gm)];
  const place = places.findLast(([, name = '']) => Object.hasOwn(files, name));
  const text = files[place?.[1] ?? ''];
  return place === undefined || text === undefined ? null : { text, line: Number(place[2]) };
}
