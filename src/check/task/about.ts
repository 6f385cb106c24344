import { LANGUAGES, type Language } from '#core/languages';
import { isSame } from '#core/same';
import type { Range, Reader } from '#scene/reader';

/** Details of a task or a series for teachers: how it is found on a shelf, and who may use it how. */
export interface TaskAbout {
  /** For which pupils, in the teacher's words; empty: not said. */
  readonly level: string;
  readonly topic: string;
  /** How long it takes in class; `null`: not said. */
  readonly minutes: number | null;
  /** The language of its texts; empty: not said. */
  readonly language: Language | '';
  readonly author: string;
  readonly licence: Licence | '';
}

/** Licences for school material, by their SPDX ids. */
export const licences = ['CC-BY-4.0', 'CC-BY-SA-4.0', 'CC-BY-NC-SA-4.0', 'CC0-1.0'] as const;
export type Licence = (typeof licences)[number];

/** A licence as it is written: CC BY-SA 4.0, CC0 1.0. */
export const licenceName = (licence: Licence): string => licence.replace(/^CC-/, 'CC ').replace(/-([\d.]+)$/, ' $1');

/** Author and licence as they stand below a work; empty: none are said. */
export const creditOf = ({ author, licence }: Pick<TaskAbout, 'author' | 'licence'>): string =>
  [author, licence === '' ? '' : licenceName(licence)].filter((said) => said !== '').join(', ');

/** Nothing is said. */
export const noAbout: TaskAbout = { level: '', topic: '', minutes: null, language: '', author: '', licence: '' };

/** Limits of what is said. Chosen: a line on a card each; a term of weeks. */
export const aboutLimits = {
  levelCharacters: 60,
  topicCharacters: 80,
  authorCharacters: 120,
  minutes: { min: 1, max: 10_000 } satisfies Range,
} as const;

/** The names of its fields in a file. */
export const ABOUT_FIELDS = ['level', 'topic', 'minutes', 'language', 'author', 'licence'] as const;

/** Reads the fields of an object that holds them, perhaps among others. @param path the object's place, with its dot */
export function aboutIn(fields: Readonly<Record<string, unknown>>, path: string, reader: Reader): TaskAbout {
  const { minutes } = fields;
  const text = (name: 'level' | 'topic' | 'author'): string =>
    reader.text(fields[name], path + name, aboutLimits[`${name}Characters`], '');
  return {
    level: text('level'),
    topic: text('topic'),
    minutes: minutes === undefined ? null : reader.whole(minutes, `${path}minutes`, aboutLimits.minutes),
    language: reader.word(fields['language'], `${path}language`, ['', ...LANGUAGES], ''),
    author: text('author'),
    licence: reader.word(fields['licence'], `${path}licence`, ['', ...licences], ''),
  };
}

/** The `about` of a task or a series in a file; `undefined`: nothing is said. */
export function readAbout(value: unknown, path: string, reader: Reader): TaskAbout | undefined {
  if (value === undefined) return undefined;
  const about = aboutIn(reader.fields(value, path, ABOUT_FIELDS), `${path}.`, reader);
  return isSame(about, noAbout) ? undefined : about;
}

/** The details for a file; what is not said is left out. */
export const aboutData = (about: TaskAbout): object =>
  Object.fromEntries(Object.entries(about).filter(([, value]) => value !== '' && value !== null));
