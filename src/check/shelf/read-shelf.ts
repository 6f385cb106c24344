/** Reads the list of a shelf, `parcours-shelf` version 1; `schemas/shelf.schema.json` describes it. */
import { readJsonFile, summaryOf } from '#scene/json-file';
import { shown, versionProblem, type SceneProblem } from '#scene/problem';
import { Reader } from '#scene/reader';
import { formatOf } from '#project/file';
import { ABOUT_FIELDS, aboutIn } from '../task/about';
import { shelfLimits, type ShelfEntry, type ShelfList } from './shelf';

/** The name of the format in a file. */
export const SHELF_FORMAT = 'parcours-shelf';

/** The version that this app writes, and the newest that it reads. A file of each version is stored in `kept/`. */
export const SHELF_VERSION = 1;

/** True if a text seems to be the list of a shelf. */
export const looksLikeShelf = (text: string): boolean => /^\ufeff?\s*\{[^{[]*"parcours-shelf"/.test(text);

/** A list, or what is wrong with the file: the first thing, and how many follow. `isShelf`: it is a list, of some version. */
export type ReadShelf = { readonly list: ShelfList } | { readonly problem: string; readonly isShelf: boolean };

/** Reads the list of a shelf. Never throws. */
export function parseShelf(text: string): ReadShelf {
  const read = readJsonFile(text, 'shelf', shelfLimits.characters);
  if ('problem' in read) return refused([read.problem], false);
  const { value } = read;
  if (formatOf(value) !== SHELF_FORMAT) {
    const message = `This is not the list of a shelf: "format" must be "${SHELF_FORMAT}".`;
    return refused([{ code: 'wrong-type', path: 'format', value: shown(formatOf(value)), params: {}, message }], false);
  }
  const reader = new Reader();
  const { version, title, entries } = reader.fields(value, '', ['format', 'version', 'title', 'entries']);
  if (version !== SHELF_VERSION) return refused([versionProblem('Shelf', version, SHELF_VERSION)], true);
  const list = {
    title: reader.text(title, 'title', shelfLimits.titleCharacters, ''),
    entries: reader
      .list(entries, 'entries', shelfLimits.entries)
      .map((entry, place) => entryIn(entry, `entries[${String(place)}]`, reader)),
  };
  return reader.problems.length > 0 ? refused(reader.problems, true) : { list };
}

const refused = (problems: readonly SceneProblem[], isShelf: boolean): ReadShelf => ({
  problem: summaryOf(problems),
  isShelf,
});

function entryIn(value: unknown, path: string, reader: Reader): ShelfEntry {
  const fields = reader.fields(value, path, ['name', 'file', 'text', ...ABOUT_FIELDS]);
  const file = reader.text(fields['file'], `${path}.file`, shelfLimits.fileCharacters);
  if (fields['file'] === '') reader.report('missing', `${path}.file`, '', 'must not be empty.');
  return {
    name: reader.text(fields['name'], `${path}.name`, shelfLimits.nameCharacters, '') || file,
    file,
    text: reader.text(fields['text'], `${path}.text`, shelfLimits.textCharacters, ''),
    about: aboutIn(fields, `${path}.`, reader),
  };
}
