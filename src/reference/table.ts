import type { BoardApi, Feature } from '#core/board-api';
import type { Entry, Limit, Limits, Names, ReferenceModule } from './types';

/** A function: how it is called, `(x: int) -> int`. */
export const fn = (...calls: readonly string[]): Entry => entry({ kind: 'function', calls });

/** A constant or an object of a type that other names have too. */
export const value = (type: string): Entry => entry({ kind: 'value', type });

/** Several values of one type. */
export const values = <K extends string>(type: string, names: readonly K[]): Readonly<Record<K, Entry>> =>
  Object.fromEntries(names.map((name) => [name, value(type)])) as Record<K, Entry>;

/** An object of its own kind: `display`. */
export const object = (members: Names): Entry => entry({ kind: 'object', members });

/** A type: how it is called (empty when programs cannot make one), its names, its bases. */
export const type = (calls: readonly string[], members: Names, ...bases: readonly string[]): Entry =>
  entry({ kind: 'type', calls, members, bases });

/** An exception type. */
export const exception = (base: string, members: Names = {}): Entry =>
  entry({ kind: 'exception', calls: ['(*values)'], bases: [base], members });

/** A module under another module's name: `microbit.audio`. */
export const moduleNamed = (name: string): Entry => entry({ kind: 'module', type: name, text: name });

/** A word of the language. */
export const keyword = (): Entry => entry({ kind: 'keyword' });

/** A name that only newer firmwares have. */
export const newer = (feature: Feature, it: Entry): Entry => ({ ...it, feature });

/** Names of one board alone. */
export const onlyOn = (board: BoardApi, names: Names): Names =>
  Object.fromEntries(Object.entries(names).map(([name, it]) => [name, { ...it, boards: [board] }]));

/** A name that type hints of other editors know and the firmware does not. */
export const absent = (it: Entry): Entry => ({ ...it, absent: true });

/** A name whose words stand under another one. */
export const withWordsOf = (text: string, it: Entry): Entry => ({ ...it, text });

/** A function with the values that make sense for its parameters. */
export const within = (limits: Limits, it: Entry): Entry => ({ ...it, limits });

/** The range of a parameter, with both ends. */
export const range = (least: number, most: number): Limit => ({ least, most });

/** A module. */
export const module = (name: string, names: Names, aliases: readonly string[] = []): ReferenceModule => ({
  name,
  aliases,
  names,
});

function entry(parts: Partial<Entry> & Pick<Entry, 'kind'>): Entry {
  return { calls: [], type: null, members: {}, bases: [], ...parts };
}
