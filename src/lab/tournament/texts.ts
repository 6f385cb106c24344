import { csvText } from '#core/csv';
import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import { escaped } from '#check/report/escaped';
import { secondsText } from '#check/report/texts';
import { reportOf, tableOf } from '../report/page';
import { reasonText } from '../say';
import words from '../words';
import type { Tournament } from './play';
import type { Row } from './table';

/** A tournament as one line of JSON, without wall times: equal work gives equal text. */
export function tournamentJson({ mode, names, matches, table }: Tournament): string {
  const named = matches.map(({ a, b, seed, winner, atMs, reason }) => ({
    ...{ a: names[a], b: b === null ? null : names[b] },
    ...{ seed, winner, atMs, reason },
  }));
  return JSON.stringify({ mode, matches: named, table });
}

/** The table for programs, a row for each program in the order of the places; RFC 4180. */
export function tournamentCsv({ table }: Tournament): string {
  const fields = fieldsOf(table);
  return csvText([['name', ...fields], ...table.map((row) => [row.name, ...fields.map((field) => row[field] ?? '')])]);
}

type Field = Exclude<keyof Row, 'name'>;

const fieldsOf = (table: readonly Row[]): readonly Field[] => [
  ...(['points', 'won', 'drawn', 'lost'] as const),
  ...(table.some(({ passed }) => passed !== undefined) ? (['passed'] as const) : []),
];

/** A row of the table in a line. */
export const rowText = ({ name, points, won, drawn, lost }: Row, place: number): string =>
  `${place + 1}. ${name}  ${points}  (${won}/${drawn}/${lost})`;

/** The number of matches in words. */
export const playedText = (of: number, language: Language): string =>
  filledIn(words.tournament[of === 1 ? 'playedOne' : 'played'][language], { of });

/** The report of a tournament as one HTML file: the table, and each match. */
export function tournamentHtml(found: Tournament, course: string, language: Language): string {
  const say = words.tournament;
  const title = filledIn(say.title[language], { name: course });
  const { table, matches, names } = found;
  const fields = fieldsOf(table);
  const columns = [
    { title: say.place[language], isNumber: true },
    { title: say.name[language] },
    ...fields.map((field) => ({ title: say[field][language], isNumber: true })),
  ];
  const rows = table.map((row, place) => [
    String(place + 1),
    escaped(row.name),
    ...fields.map((field) => String(row[field] ?? '')),
  ]);
  const played = matches.map(({ a, b, seed, winner, atMs, reason }) => [
    escaped(names[a] ?? ''),
    escaped(b === null ? '' : (names[b] ?? '')),
    String(seed),
    escaped(winnerText(found, { a, b, winner }, language)),
    atMs === null ? '' : secondsText(atMs),
    reason === null ? '' : escaped(reasonText(reason, language)),
  ]);
  const matchColumns = [
    ...[{ title: 'A' }, { title: 'B' }, { title: say.seed[language], isNumber: true }],
    ...[{ title: say.winner[language] }, { title: words.time[language], isNumber: true }, { title: '' }],
  ];
  return reportOf(
    title,
    language,
    `<h1>${escaped(title)}</h1>
<p class="sum">${escaped(playedText(matches.length, language))}</p>
${tableOf(columns, rows)}
<h2>${escaped(say.matches[language])}</h2>
${tableOf(matchColumns, played)}`,
  );
}

function winnerText(
  { names }: Tournament,
  { a, b, winner }: Pick<Tournament['matches'][number], 'a' | 'b' | 'winner'>,
  language: Language,
): string {
  if (b === null) return words[winner === 'a' ? 'passed' : 'missed'][language];
  return winner === 'draw' ? words.tournament.draw[language] : (names[winner === 'a' ? a : b] ?? '');
}
