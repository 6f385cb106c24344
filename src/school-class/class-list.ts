import { unseenShown } from '#core/unseen';
import { findPupil, freePupilId, wordsOfName } from './names';
import { classLimits, type Pupil, type SchoolClass } from './school-class';

/** Headings of columns in the languages of the page, in small letters without marks. */
const HEADINGS: Readonly<Record<'first' | 'last' | 'whole', readonly string[]>> = {
  first: ['vorname', 'rufname', 'prenom', 'nome', 'first name', 'given name', 'firstname', 'forename'],
  last: ['nachname', 'familienname', 'nom', 'nom de famille', 'cognome', 'last name', 'surname', 'family name', 'lastname'], // prettier-ignore
  whole: ['name', 'schuler', 'schulerin', 'schuler*in', 'eleve', 'allievo', 'alunno', 'studente', 'pupil', 'student', 'full name', 'vollstandiger name', 'nom complet', 'nome completo'], // prettier-ignore
};

const plainly = (text: string): string => text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase().trim();

/** The names in a table that was pasted, or in a file of one: with headings or without, first or last name first. */
export function namesIn(text: string): readonly string[] {
  const rows = text
    .replace(/^\ufeff/, '')
    .split(/\r\n?|\n/)
    .filter((line) => line.trim() !== '')
    .map(cellsOf);
  const head = columnsOf(rows[0] ?? []);
  const names = (head === null ? rows : rows.slice(1)).map((cells) => nameIn(cells, head));
  return names.filter((name) => wordsOfName(name).length > 0).map((name) => unseenShown(name).slice(0, classLimits.nameCharacters)); // prettier-ignore
}

/** The cells of a row, parted by tabs, else by semicolons or commas outside of quotes. */
function cellsOf(line: string): readonly string[] {
  const sign = ['\t', ';', ','].find((one) => line.replace(/"[^"]*"/g, '').includes(one));
  if (sign === undefined) return [bare(line)];
  const cells: string[] = [''];
  let isQuoted = false;
  for (const letter of line) {
    if (letter === '"') isQuoted = !isQuoted;
    if (letter === sign && !isQuoted) cells.push('');
    else cells.push((cells.pop() ?? '') + letter);
  }
  return cells.map(bare);
}

/** Without the quotes around it and the number before it. */
const bare = (cell: string): string =>
  cell
    .trim()
    .replace(/^"([^]*)"$/, '$1')
    .replaceAll('""', '"')
    .replace(/^\d+[.)]?\s+/, '')
    .trim();

/** Columns of first and last name by their headings; `null`: the row is none of headings. */
function columnsOf(cells: readonly string[]): readonly number[] | null {
  const at = (kind: keyof typeof HEADINGS): number => cells.findIndex((cell) => HEADINGS[kind].includes(plainly(cell)));
  const [first, last, whole] = [at('first'), at('last'), at('whole')];
  if (first >= 0 && last >= 0) return [first, last];
  // Beside "Vorname" the other name may be called just "Name", and "Nome" alone is the whole one.
  if (first >= 0 && whole >= 0) return [first, whole];
  const only = [whole, first, last].find((place) => place >= 0);
  return only === undefined ? null : [only];
}

function nameIn(cells: readonly string[], columns: readonly number[] | null): string {
  if (columns !== null) return columns.map((place) => cells[place] ?? '').join(' ').trim(); // prettier-ignore
  const texts = cells.filter((cell) => /^[^\d@]*\p{L}[^\d@]*$/u.test(cell)).slice(0, 2);
  // Lists without headings have the last name first; a single column is as it stands, "Meier, Ada" is two.
  return texts.toReversed().join(' ');
}

/** Names that stand in a list more than once: those pupils need something that tells them apart. */
export const namesTwice = (names: readonly string[]): readonly string[] => [
  ...new Set(names.filter((name, place) => names.indexOf(name) !== place)),
];

/**
 * A class with the names of its list, in that order. Who is in it already stays the same pupil, also under another spelling;
 * who is not on the list comes behind it.
 */
export function withList(given: SchoolClass, names: readonly string[]): SchoolClass {
  const listed: Pupil[] = [];
  for (const name of names.slice(0, classLimits.pupils.max)) {
    const same = given.pupils.find((pupil) => pupil.name === name && !listed.some(({ id }) => id === pupil.id));
    listed.push(same ?? { id: freePupilId([...given.pupils, ...listed], name), name, also: [], isListed: true });
  }
  const pupils = listed.map((pupil) => ({ ...pupil, isListed: true }));
  const others = given.pupils.filter(({ id }) => !pupils.some((pupil) => pupil.id === id));
  const found = others.map((one) => ({ one, pupil: findPupil(pupils, one.name) }));
  const left = found.flatMap(({ one, pupil }) => (pupil === null ? [{ ...one, isListed: false }] : []));
  let joined: SchoolClass = { ...given, pupils: [...pupils, ...left] };
  for (const { one, pupil } of found) if (pupil !== null) joined = withOneFor(joined, one, pupil.id);
  return joined;
}

/** A class in which a pupil is known by the names of somebody else, too, and has their results: the two are one. */
function withOneFor(given: SchoolClass, other: Pupil, id: string): SchoolClass {
  const known = (pupil: Pupil): Pupil => ({
    ...pupil,
    also: [...new Set([...pupil.also, ...other.also, other.name])].filter((name) => name !== pupil.name),
  });
  return {
    ...given,
    pupils: given.pupils.flatMap((pupil) => (pupil.id === other.id ? [] : pupil.id === id ? [known(pupil)] : [pupil])),
    results: given.results.map((result) => (result.pupil === other.id ? { ...result, pupil: id } : result)),
  };
}

/** A class in which two pupils are one: the first has the names and results of the second. */
export function withPupilsJoined(given: SchoolClass, id: string, otherId: string): SchoolClass {
  const other = given.pupils.find((pupil) => pupil.id === otherId);
  return other === undefined || id === otherId ? given : withOneFor(given, other, id);
}

/** A class without a pupil and what they handed in. */
export const withoutPupil = (given: SchoolClass, id: string): SchoolClass => ({
  ...given,
  pupils: given.pupils.filter((pupil) => pupil.id !== id),
  results: given.results.filter(({ pupil }) => pupil !== id),
});

/** A class without a task and its results. */
export const withoutTask = (given: SchoolClass, id: string): SchoolClass => ({
  ...given,
  tasks: given.tasks.filter((task) => task.id !== id),
  results: given.results.filter(({ task }) => task !== id),
});
