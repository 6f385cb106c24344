// Grades for Moodle from the result of `parcours check --json`:
//   node grades.mjs result.json worksheet.csv > grades.csv    fills in an assignment's grading worksheet
//   node grades.mjs result.json > grades.csv                  a table for the gradebook's import
// Options: --max 100 (grade for all points; left out: points are grades), --grade and --feedback (headings of the worksheet)
import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';

/** Moodle's headings in English, German, French and Italian. */
const GRADE = ['Grade', 'Bewertung', 'Note', 'Valutazione'];
const FEEDBACK = ['Feedback comments', 'Feedback als Kommentar', 'Feedback par commentaires', 'Commenti'];

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: { max: { type: 'string' }, grade: { type: 'string' }, feedback: { type: 'string' } },
});
const [resultPath, worksheetPath] = positionals;
const { maxPoints, handIns } = JSON.parse(readFileSync(resultPath, 'utf8'));

/** The grade of a hand-in; `null` if it could not be read. */
const gradeOf = ({ points }) =>
  points === null
    ? ''
    : options.max === undefined
      ? points
      : Math.round((points / (maxPoints || 1)) * Number(options.max) * 100) / 100;

/** The text for the pupil: the reasons. Remarks, such as who has the same program, are the teacher's. */
function feedbackOf({ worlds, checks, remarks }) {
  if (worlds.length === 0) return remarks[0] ?? '';
  const reasons = [...worlds, ...checks].map(({ reason }) => reason).filter((reason) => reason !== null);
  return [...new Set(reasons)].join(' ');
}

/** RFC 4180. */
function rowsOf(text) {
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"([^"]*(?:""[^"]*)*)"|([^,\r\n]*))(,|\r?\n|$)/g)) {
    rows.at(-1).push(quoted?.replaceAll('""', '"') ?? plain);
    if (end !== ',') rows.push([]);
  }
  return rows.filter((row) => row.some((cell) => cell !== ''));
}
const cellText = (cell) => (/[",\r\n]/.test(cell) ? `"${String(cell).replaceAll('"', '""')}"` : String(cell));
const textOf = (rows) => rows.map((row) => `${row.map(cellText).join(',')}\n`).join('');

function columnOf(headings, own, known) {
  const column = headings.findIndex((heading) => (own === undefined ? known.includes(heading) : heading === own));
  if (column >= 0) return column;
  console.error(`The worksheet has no column ${own ?? known.join(', ')}. It has: ${headings.join(', ')}.`);
  process.exit(1);
}

/** The worksheet with grades and comments; the rest of it stays as it is. */
function filled([headings, ...rows]) {
  const grade = columnOf(headings, options.grade, GRADE);
  const feedback = columnOf(headings, options.feedback, FEEDBACK);
  // Moodle's number of a participant ends the first cell of a row, and stands in the name of a hand-in. Who has handed in
  // both a file and a text has the better one's grade.
  const byNumber = new Map(
    handIns
      .toSorted((a, b) => (a.points ?? -1) - (b.points ?? -1))
      .map((one) => [/_(\d+)_assignsubmission_/.exec(one.name)?.[1] ?? one.name, one]),
  );
  for (const row of rows) {
    const number = /\d+$/.exec(row[0])?.[0] ?? '';
    const handIn = byNumber.get(number);
    if (handIn === undefined) continue;
    [row[grade], row[feedback]] = [String(gradeOf(handIn)), feedbackOf(handIn)];
    byNumber.delete(number);
  }
  for (const { name } of byNumber.values()) console.error(`Nobody in the worksheet has handed in: ${name}`);
  return [headings, ...rows];
}

const rows =
  worksheetPath === undefined
    ? [['name', 'grade', 'feedback'], ...handIns.map((one) => [one.name, gradeOf(one), feedbackOf(one)])]
    : filled(rowsOf(readFileSync(worksheetPath, 'utf8').replace(/^\ufeff/, '')));
process.stdout.write(textOf(rows));
