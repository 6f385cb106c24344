import { withList, namesIn, namesTwice } from '#school-class/class-list';
import { usualScale, type Scale } from '#school-class/grades';
import { mergeClasses } from '#school-class/merge';
import { rowsOf, type Row } from '#school-class/progress';
import { classReport } from '#school-class/report/html';
import { gradeText, hasPoints, SIGNS, stateText, summaryText, twiceText } from '#school-class/report/say';
import { classTable } from '#school-class/report/table';
import { classLimits, type SchoolClass } from '#school-class/school-class';
import { outputProblem, writeProblem } from '../outputs';
import { readLimited } from '../read-files';
import { reasonOf } from '../reason-of';
import { printable, type Terminal } from '../terminal';
import { writeOutput } from '../write-output';
import { addHandIns } from './add-hand-ins';
import type { ClassOptions } from './class-arguments';
import { readClass, readOrNewClass, writeClass, type Done } from './class-file';

/** Carries out `parcours class`. @returns the exit code: 0 done, 2 bad usage or a file that cannot be read or written */
export async function changeClass(options: ClassOptions, terminal: Terminal): Promise<0 | 2> {
  const done = await doneBy(options, terminal);
  const problem = 'problem' in done ? done.problem : options.act === 'report' ? null : writeClass(options.file, done.schoolClass); // prettier-ignore
  if (problem !== null || 'problem' in done) {
    terminal.message(`parcours: ${problem ?? ''}`);
    return 2;
  }
  if (options.json) terminal.line(jsonOf(done.schoolClass, options));
  else if (!options.quiet) for (const text of done.said) terminal.line(printable(text));
  return 0;
}

async function doneBy(options: ClassOptions, terminal: Terminal): Promise<Done> {
  const { act, file } = options;
  const unwritable = act === 'report' ? null : writeProblem({ option: `class ${act}`, path: file });
  if (unwritable !== null) return { problem: unwritable };
  const given = act === 'add' || act === 'set' ? readOrNewClass(file) : readClass(file);
  if ('problem' in given) return given;
  if (act === 'add') return addHandIns(given, options, terminal);
  if (act === 'set') return changed(given, options);
  return act === 'merge' ? merged(given, options) : reported(given, options);
}

function changed(given: SchoolClass, options: ClassOptions): Done {
  const { name, names, scale, pass, due, lang } = options;
  const list = names === null ? null : readLimited(names, classLimits.characters);
  if (list !== null && 'problem' in list) return list;
  const listed = list === null ? [] : namesIn(list.text);
  if (list !== null && listed.length === 0) return { problem: `${names ?? ''}: there are no names in it. One a line, or a table.` }; // prettier-ignore
  if (name !== null && name.length > classLimits.nameCharacters)
    return { problem: `--name: ${String(name.length)} characters are too many; the limit is ${String(classLimits.nameCharacters)}.` }; // prettier-ignore
  const strange = due.find(([id]) => !given.tasks.some((task) => task.id === id));
  if (strange !== undefined)
    return { problem: `--due: there is no task "${strange[0]}" in the class. There are ${given.tasks.map(({ id }) => id).join(', ') || 'none'}.` }; // prettier-ignore
  const chosen = scale === null ? given.scale : usualScale(scale);
  if (pass !== null && chosen === null) return { problem: '--pass: say which grades, too: --scale ch6' };
  const schoolClass: SchoolClass = {
    ...(list === null ? given : withList(given, listed)),
    name: name ?? given.name,
    tasks: given.tasks.map((task) => ({ ...task, due: due.findLast(([id]) => id === task.id)?.[1] ?? task.due })),
    scale: chosen && (pass === null ? chosen : { ...chosen, passPercent: pass === 'even' ? null : pass }),
  };
  const twice = namesTwice(listed);
  const texts = twice.length > 0 ? [twiceText(twice, lang)] : [];
  return { schoolClass, said: [summaryText(schoolClass, options.lang), ...texts] };
}

function merged(given: SchoolClass, options: ClassOptions): Done {
  let schoolClass = given;
  for (const path of options.others) {
    const other = readClass(path);
    if ('problem' in other) return other;
    schoolClass = mergeClasses(schoolClass, other);
  }
  return { schoolClass, said: [summaryText(schoolClass, options.lang)] };
}

function reported(schoolClass: SchoolClass, options: ClassOptions): Done {
  const { report, csv, form, day, lang, file } = options;
  const outputs = [
    { option: '--report', path: report },
    { option: '--csv', path: csv },
  ];
  const unwritable = outputProblem(outputs, [file], 'report');
  if (unwritable !== null) return { problem: unwritable };
  const rows = rowsOf(schoolClass, day);
  const files = [
    [report, () => classReport(schoolClass, day, lang)],
    [csv, () => classTable(schoolClass, rows, lang, form)],
  ] as const;
  for (const [path, textOf] of files) {
    if (path === null) continue;
    try {
      writeOutput(path, textOf());
    } catch (error) {
      return { problem: `${path}: ${reasonOf(error)}` };
    }
  }
  return {
    schoolClass,
    said: [summaryText(schoolClass, options.lang), ...rows.map((row) => lineOf(row, schoolClass.scale, options))],
  };
}

/** A row as a line of text: `Ada Meier  ✓ 4  ◐ 3  – fehlt  7/12  4.5`. */
function lineOf({ pupil, cells, points, most, grade }: Row, scale: Scale | null, { lang }: ClassOptions): string {
  const figures = cells.map((cell) => `${SIGNS[cell.state]} ${hasPoints(cell) ? String(cell.points) : stateText(cell, lang)}`); // prettier-ignore
  const last = scale === null ? [] : [gradeText(grade, scale, lang)];
  return [pupil.name, ...figures, `${String(points)}/${String(most)}`, ...last].join('  ');
}

/** The class as one line for other programs. */
function jsonOf(schoolClass: SchoolClass, { day }: ClassOptions): string {
  const { name, tasks } = schoolClass;
  return JSON.stringify({
    name,
    tasks: tasks.map(({ id, title, points, since, due }) => ({ id, title, points, since, due })),
    pupils: rowsOf(schoolClass, day).map(({ pupil, cells, points, most, grade }) => ({
      ...{ name: pupil.name, listed: pupil.isListed, points, most, grade },
      tasks: cells.map((cell, place) => ({
        ...{ id: tasks[place]?.id, state: cell.state },
        points: cell.result === null || cell.state === 'unread' ? null : cell.points,
        ...{ stars: cell.stars, tries: cell.tries },
      })),
    })),
  });
}
