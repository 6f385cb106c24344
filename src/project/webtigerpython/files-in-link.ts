/**
 * The files of a WebTigerPython program in its forms: the list `[{ "name": "main.py", "data": "…" }]` of its links and
 * messages, and the `fs` of its pages with several files. The form of `fs` is described nowhere. We recognise a list
 * like the one above, a dictionary of names and texts, and either of them below `files`; the text of a file may be
 * called `data`, `content`, `text` or `code`, its name also `path`.
 */
import { isRecord } from '#core/record';

import { MAIN, type SourceFile } from '../project';

/** The possible field names of a file's text and name. */
const TEXT_NAMES = ['data', 'content', 'text', 'code'] as const;
const NAME_NAMES = ['name', 'path'] as const;

/** The files of a list of `{ name, data }`, main.py first; `null` if it is not such a list, or empty. */
export function filesOfList(value: unknown): readonly SourceFile[] | null {
  return Array.isArray(value) ? checked(value.map((entry) => fileOf(entry, ['name'], ['data']))) : null;
}

/** The program in a plain text: the text of main.py, or a list of files as JSON. */
export function filesOfText(text: string): readonly SourceFile[] {
  return (text.startsWith('[') ? filesOfList(valueOf(text)) : null) ?? [fileWith(MAIN, text)];
}

function valueOf(json: string): unknown {
  try {
    return JSON.parse(json);
  } catch {
    return null;
  }
}

/** The files of any recognised form, main.py first; `null` for anything else. */
export function filesOfTree(value: unknown): readonly SourceFile[] | null {
  if (Array.isArray(value)) return checked(value.map((entry) => fileOf(entry, NAME_NAMES, TEXT_NAMES)));
  if (!isRecord(value)) return null;
  const inside = value['files'];
  if (typeof inside === 'object' && inside !== null) return filesOfTree(Array.isArray(inside) ? inside : { ...inside });
  return checked(
    Object.entries(value).map(([name, entry]) =>
      typeof entry === 'string' ? fileWith(name, entry) : fileOf({ name, ...asRecord(entry) }, ['name'], TEXT_NAMES),
    ),
  );
}

function fileOf(entry: unknown, names: readonly string[], texts: readonly string[]): SourceFile | null {
  if (!isRecord(entry)) return null;
  const name = names.map((one) => entry[one]).find((one) => typeof one === 'string');
  const text = texts.map((one) => entry[one]).find((one) => typeof one === 'string');
  return typeof name === 'string' && typeof text === 'string' ? fileWith(name, text) : null;
}

/** Our files have only `\n` and no folders: the root is left out. */
const fileWith = (name: string, text: string): SourceFile => ({
  name: name.replace(/^(\.?\/)+/, ''),
  text: text.replaceAll('\r\n', '\n'),
});

function checked(files: readonly (SourceFile | null)[]): readonly SourceFile[] | null {
  const known = files.filter((file) => file !== null);
  return known.length === 0 || known.length < files.length ? null : withMainFirst(known);
}

/** The program is main.py; without a file of that name, the first file is the program. */
function withMainFirst(files: readonly SourceFile[]): readonly SourceFile[] {
  const main = files.find(({ name }) => name === MAIN) ?? files[0];
  const others = files.filter((file) => file !== main);
  return main === undefined ? files : [{ name: MAIN, text: main.text }, ...others];
}

const asRecord = (value: unknown): Readonly<Record<string, unknown>> => (isRecord(value) ? value : {});
