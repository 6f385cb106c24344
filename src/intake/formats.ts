import { FILE_BYTES, projectLimits } from '#project/project';

/** How a file is read, by the ending of its name. */
export type Format =
  'program' | 'hex' | 'json' | 'zip' | 'page' | 'table' | 'text' | 'mail' | 'note' | 'sheet' | 'picture' | 'other';

/** Every ending that is known; a file with any other is `other`. */
const endings: Readonly<Record<Exclude<Format, 'other'>, readonly string[]>> = {
  program: ['py'],
  hex: ['hex'],
  json: ['json'],
  zip: ['zip'],
  page: ['htm', 'html'],
  table: ['csv'],
  text: ['txt'],
  mail: ['eml'],
  note: ['md', 'url'],
  sheet: ['tsv', 'xls', 'xlsx', 'ods'],
  picture: ['png', 'jpg', 'jpeg', 'svg'],
};

/** Texts in which links to hand-ins may stand. */
const LINKED: readonly Format[] = ['page', 'table', 'text', 'mail', 'note'];

/** Programs, and what holds some. */
const WORKS: readonly Format[] = ['program', 'hex', 'json', 'zip'];

/** The formats of a device's readings, also after a detour through a spreadsheet. */
const LOGS: readonly Format[] = ['page', 'table', 'text', 'sheet'];

const formats: ReadonlyMap<string, Format> = new Map(
  (Object.keys(endings) as (keyof typeof endings)[]).flatMap((format) =>
    endings[format].map((ending) => [ending, format] as const),
  ),
);

/** How a file of this name is read. */
export function formatOf(name: string): Format {
  const plain = plainName(name);
  const dot = plain.lastIndexOf('.');
  return (dot < 0 ? undefined : formats.get(plain.slice(dot + 1).toLowerCase())) ?? 'other';
}

/** `main.py` for main.py.txt: Windows hides the ending that its Notepad adds. */
export const plainName = (name: string): string => name.replace(/(\.(?:py|hex|json))\.txt$/i, '$1');

/** True if links are looked for in a file of this name. */
export const isTextWithLinks = (name: string): boolean => LINKED.includes(formatOf(name));

/** True if a file of this name may be somebody's work. */
export const isWork = (name: string): boolean => WORKS.includes(formatOf(name));

/** True if a file of this name may hold a device's readings. */
export const mayBeLog = (name: string): boolean => LOGS.includes(formatOf(name));

/** The part of a path after the last `/`. */
export const lastOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

/** `anna` for anna.py, anna.json, x/anna.parcours.json and anna.run.json. */
export const stemOf = (path: string): string => {
  const name = plainName(lastOf(path));
  return name.replace(/(\.parcours|\.run)?\.[^.]*$/, '') || name;
};

/** The largest things that are read, in bytes: the same for every door. */
export const limits = {
  program: FILE_BYTES,
  /** One for both micro:bits has 2 MB. Chosen: MakeCode's may have pictures and sounds in it. */
  hex: 8 * 1024 * 1024,
  /** Chosen: a project with a picture as floor has a few MB. */
  json: 16 * 1024 * 1024,
  /** A text with links. */
  links: 20_000_000,
  /** A micro:bit's page of readings has 0.13 MB; its table from a spreadsheet twice as much at most. Chosen: a weak tablet reads it in two or three seconds. */
  log: 1024 * 1024,
  /** Chosen: a tablet's browser holds it beside the workers. */
  zip: 200_000_000,
  /** Chosen: fits in a computer's memory beside the runs. */
  zipOnCommandLine: 500_000_000,
  /** All that is unpacked of a class, by the directory of its zip. Chosen: a hundred kilobytes for each of ten thousand hand-ins. */
  classInZip: 1_000_000_000,
  /** All that is unpacked of the zip of a series, by its directory. Chosen: a hundred tasks, some with a picture. */
  tasksInZip: 64 * 1024 * 1024,
  /** All that may be unpacked of one hand-in. Chosen: more than the largest project. */
  handIn: 4 * projectLimits.textCharacters,
  /** Files beside a program that are none themselves, in sum. Chosen: the real board holds a hundredth of it. */
  besideProgram: 4_000_000,
} as const;

/** The largest file of this name that is read, in bytes. */
export function mostBytes(name: string): number {
  const format = formatOf(name);
  if (format === 'program' || format === 'hex' || format === 'zip') return limits[format];
  return LINKED.includes(format) ? limits.links : LOGS.includes(format) ? limits.log : limits.json;
}

/** Bytes in whole MB for a message, rounded up. */
export const inMB = (bytes: number): number => Math.ceil(bytes / 1024 / 1024);
