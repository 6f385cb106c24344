import { projectToText } from '#project/file';
import { seriesToText, taskFileName } from '../series/write-series';
import { aboutData, noAbout } from '../task/about';
import { SHELF_FORMAT, SHELF_VERSION } from './read-shelf';
import { aboutOf, shelfLimits, type ShelfList, type ShelfWork } from './shelf';

/** A list as its file: readable JSON, an entry a line, that ends in a newline. Reading it back gives an equal list. */
export function shelfToText({ title, entries }: ShelfList): string {
  const lines = entries.map(({ name, file, text, about }) =>
    JSON.stringify({ name, file, ...(text !== '' && { text }), ...aboutData(about) }),
  );
  const all = [
    `"format": ${JSON.stringify(SHELF_FORMAT)}`,
    `"version": ${String(SHELF_VERSION)}`,
    ...(title === '' ? [] : [`"title": ${JSON.stringify(title)}`]),
    lines.length === 0 ? '"entries": []' : `"entries": [\n    ${lines.join(',\n    ')}\n  ]`,
  ];
  return `{\n  ${all.join(',\n  ')}\n}\n`;
}

/** The list's file in a folder. */
export const SHELF_FILE = 'shelf.json';

/** A work as its own file. */
export const workToText = (work: ShelfWork): string =>
  work.kind === 'task' ? projectToText(work.project) : seriesToText(work.series);

/** A work with its name and its text, as the page says them. */
export interface NamedWork {
  readonly work: ShelfWork;
  readonly name: string;
  readonly text: string;
}

/** A shelf as a folder for a web server: `shelf.json`, and a file for each work. */
export function shelfToFolder(
  title: string,
  works: readonly NamedWork[],
): readonly { readonly name: string; readonly text: string }[] {
  const files = works.map(({ work, name }, place) => {
    const number = String(place + 1).padStart(2, '0');
    return { name: `${number}-${taskFileName(name)}.json`, text: workToText(work) };
  });
  const entries = works.slice(0, shelfLimits.entries.max).map(({ work, name, text }, place) => ({
    ...{ name: name.slice(0, shelfLimits.nameCharacters), file: files[place]?.name ?? '' },
    ...{ text: text.slice(0, shelfLimits.textCharacters), about: aboutOf(work) ?? noAbout },
  }));
  return [{ name: SHELF_FILE, text: shelfToText({ title, entries }) }, ...files];
}
