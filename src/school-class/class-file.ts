import { dayNumber, type Day } from '#core/day';
import { isRecord } from '#core/record';
import { readJsonFile, summaryOf } from '#scene/json-file';
import { shown, type SceneProblem, versionProblem } from '#scene/problem';
import { Reader, type Fields } from '#scene/reader';
import { gradeSteps, passPercents, systemIds, usualScale, type Scale } from './grades';
import { classLimits, outcomes, type Pupil, type Result, type SchoolClass, type SetTask } from './school-class';

/** The name of the format in the file of a class. */
export const CLASS_FORMAT = 'parcours-class';

/** The newest version that this app writes and reads: 2 for points set by hand, 1 for all others. */
export const CLASS_VERSION = 2;

/** A class as its file: readable JSON, a line for each pupil, task and result, that ends in a newline. Reading it back gives an equal class. */
export function classToText({ name, scale, pupils, tasks, results }: SchoolClass): string {
  const lines = [
    `"format": ${JSON.stringify(CLASS_FORMAT)}`,
    `"version": ${results.some(({ marked }) => marked !== undefined) ? '2' : '1'}`,
    `"name": ${JSON.stringify(name)}`,
    ...(scale === null ? [] : [`"scale": ${JSON.stringify(scale)}`]),
    listText('pupils', pupils.map(pupilValue)),
    listText('tasks', tasks.map(taskValue)),
    listText('results', results.map(resultValue)),
  ];
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

const listText = (name: string, values: readonly unknown[]): string =>
  values.length === 0 ? `"${name}": []` : `"${name}": [\n    ${values.map((value) => JSON.stringify(value)).join(',\n    ')}\n  ]`; // prettier-ignore

const pupilValue = ({ id, name, also, isListed }: Pupil): unknown => ({
  ...{ id, name },
  ...(also.length > 0 && { also }),
  ...(!isListed && { listed: false }),
});

const taskValue = ({ id, title, points, hasStars, since, due }: SetTask): unknown => ({
  ...{ id, title, points },
  ...(hasStars && { stars: true }),
  since,
  ...(due !== null && { due }),
});

const resultValue = ({ pupil, task, day, outcome, points, marked, stars, work, note }: Result): unknown => ({
  ...{ pupil, task, day, outcome },
  ...(outcome !== 'unread' && { points }),
  ...(marked !== undefined && { marked }),
  ...(stars !== null && { stars }),
  ...(work !== '' && { work }),
  ...(note !== '' && { note }),
});

/** One thing that is wrong with the file of a class. */
export interface ClassProblem extends Omit<SceneProblem, 'code'> {
  readonly code: SceneProblem['code'] | 'not-a-class';
}

/** True if a JSON value claims to be a class, of any version. */
export const isClassFile = (value: unknown): value is Fields => isRecord(value) && value['format'] === CLASS_FORMAT;

/** A class, or everything that is wrong with its file; `problem` is the first one's message and how many follow. */
export type ParsedClass =
  { readonly schoolClass: SchoolClass } | { readonly problem: string; readonly problems: readonly ClassProblem[] };

/** Reads the file of a class. Never throws; a file with a problem opens nothing. */
export function parseClass(text: string): ParsedClass {
  const read = readJsonFile(text, 'class', classLimits.characters);
  return 'problem' in read ? failed([read.problem]) : parseClassValue(read.value);
}

/** Reads a class that is already a JavaScript value. Never throws. */
export function parseClassValue(value: unknown): ParsedClass {
  if (!isClassFile(value)) {
    const message = `This is not the file of a class: "format" must be "${CLASS_FORMAT}".`;
    const given = isRecord(value) ? value['format'] : undefined;
    return failed([{ code: 'not-a-class', path: 'format', value: shown(given), params: {}, message }]);
  }
  const { version } = value;
  if (version !== 1 && version !== CLASS_VERSION) return failed([versionProblem('Class', version, CLASS_VERSION)]);
  const reader = new Reader();
  const fields = reader.fields(value, '', ['format', 'version', 'name', 'scale', 'pupils', 'tasks', 'results']);
  const name = reader.text(fields['name'], 'name', classLimits.nameCharacters);
  const scale = fields['scale'] === undefined ? null : scaleIn(fields['scale'], reader);
  const pupils = listIn(fields, 'pupils', reader, pupilIn);
  const tasks = listIn(fields, 'tasks', reader, taskIn);
  const results = listIn(fields, 'results', reader, resultIn);
  checkIds(reader, pupils, 'pupils');
  checkIds(reader, tasks, 'tasks');
  checkKnown(reader, results, { pupils, tasks });
  return reader.problems.length > 0
    ? failed(reader.problems)
    : { schoolClass: { name, scale, pupils, tasks, results } };
}

const failed = (problems: readonly ClassProblem[]): ParsedClass => ({ problem: summaryOf(problems), problems });

function listIn<T>(
  fields: Fields,
  name: 'pupils' | 'tasks' | 'results',
  reader: Reader,
  read: (value: unknown, path: string, reader: Reader) => T,
): readonly T[] {
  const list = reader.list(fields[name] ?? [], name, classLimits[name]);
  const found: T[] = [];
  for (const [place, one] of list.entries()) {
    if (reader.isFull) break;
    found.push(read(one, `${name}[${String(place)}]`, reader));
  }
  return found;
}

function scaleIn(value: unknown, reader: Reader): Scale {
  const fields = reader.fields(value, 'scale', ['system', 'passPercent', 'step']);
  const system = reader.word(fields['system'], 'scale.system', systemIds, 'ch6');
  const { step } = usualScale(system);
  const given = fields['passPercent'] ?? null;
  const asked = reader.number(fields['step'], 'scale.step', { min: 0.1, max: 1 }, step);
  const known = gradeSteps.find((one) => one === asked);
  if (known === undefined) {
    const steps = gradeSteps.join(', ');
    reader.report('unknown-value', 'scale.step', asked, `${shown(asked)} is unknown. Known: ${steps}.`, {
      known: steps,
    });
  }
  return {
    system,
    passPercent: given === null ? null : reader.whole(given, 'scale.passPercent', passPercents),
    step: known ?? step,
  };
}

function pupilIn(value: unknown, path: string, reader: Reader): Pupil {
  const fields = reader.fields(value, path, ['id', 'name', 'also', 'listed']);
  const names = fields['also'] === undefined ? [] : reader.list(fields['also'], `${path}.also`, classLimits.names);
  return {
    id: idIn(fields['id'], `${path}.id`, reader),
    name: reader.text(fields['name'], `${path}.name`, classLimits.nameCharacters),
    also: names.map((one, place) => reader.text(one, `${path}.also[${String(place)}]`, classLimits.nameCharacters)),
    isListed: reader.flag(fields['listed'], `${path}.listed`, true),
  };
}

function taskIn(value: unknown, path: string, reader: Reader): SetTask {
  const fields = reader.fields(value, path, ['id', 'title', 'points', 'stars', 'since', 'due']);
  return {
    id: idIn(fields['id'], `${path}.id`, reader),
    title: reader.text(fields['title'], `${path}.title`, classLimits.titleCharacters),
    points: reader.number(fields['points'], `${path}.points`, classLimits.points),
    hasStars: reader.flag(fields['stars'], `${path}.stars`, false),
    since: dayIn(fields['since'], `${path}.since`, reader),
    due: fields['due'] === undefined ? null : dayIn(fields['due'], `${path}.due`, reader),
  };
}

function resultIn(value: unknown, path: string, reader: Reader): Result {
  const fields = reader.fields(value, path, [
    ...['pupil', 'task', 'day', 'outcome', 'points', 'marked', 'stars', 'work', 'note'],
  ]);
  const outcome = reader.word(fields['outcome'], `${path}.outcome`, outcomes, 'unread');
  return {
    pupil: idIn(fields['pupil'], `${path}.pupil`, reader),
    task: idIn(fields['task'], `${path}.task`, reader),
    day: dayIn(fields['day'], `${path}.day`, reader),
    outcome,
    points: outcome === 'unread' ? 0 : reader.number(fields['points'], `${path}.points`, classLimits.points),
    ...(fields['marked'] !== undefined && {
      marked: reader.number(fields['marked'], `${path}.marked`, classLimits.points),
    }),
    stars: fields['stars'] === undefined ? null : reader.whole(fields['stars'], `${path}.stars`, classLimits.stars),
    work: reader.text(fields['work'], `${path}.work`, classLimits.idCharacters, ''),
    note: reader.text(fields['note'], `${path}.note`, classLimits.noteCharacters, ''),
  };
}

const idIn = (value: unknown, path: string, reader: Reader): string => {
  const id = reader.text(value, path, classLimits.idCharacters);
  if (value === '') reader.report('wrong-type', path, value, 'must not be empty.', { wanted: 'a text in quotes' });
  return id;
};

function dayIn(value: unknown, path: string, reader: Reader): Day {
  const day = reader.text(value, path, 10);
  if (dayNumber(day) !== null) return day;
  if (typeof value === 'string')
    reader.report('wrong-type', path, value, `${shown(value)} is no day such as "2026-11-30".`, { wanted: 'a day' });
  return '2000-01-01';
}

function checkIds(reader: Reader, list: readonly { readonly id: string }[], name: string): void {
  const ids = new Set<string>();
  for (const [place, { id }] of list.entries()) {
    if (ids.has(id) && id !== '')
      reader.report('duplicate-id', `${name}[${String(place)}].id`, id, `another one has the id ${shown(id)}.`);
    ids.add(id);
  }
}

function checkKnown(
  reader: Reader,
  results: readonly Result[],
  { pupils, tasks }: Pick<SchoolClass, 'pupils' | 'tasks'>,
): void {
  if (reader.problems.length > 0) return;
  const [people, set] = [new Set(pupils.map(({ id }) => id)), new Set(tasks.map(({ id }) => id))];
  for (const [place, { pupil, task }] of results.entries()) {
    const path = `results[${String(place)}]`;
    if (!people.has(pupil))
      reader.report('unknown-id', `${path}.pupil`, pupil, `nobody in the class has the id ${shown(pupil)}.`);
    if (!set.has(task))
      reader.report('unknown-id', `${path}.task`, task, `no task of the class has the id ${shown(task)}.`);
    if (reader.isFull) return;
  }
}
