import { projectOfRun } from '#intake/project-of-run';
import { isSameCourse } from '#check/task/course-mark';
import { withFiles } from '#project/devices';
import type { Project } from '#project/project';
import { parseTape } from '#tape/file';
import { differences } from '#tape/result';
import type { Tape } from '#tape/tape';
import type { Scene } from '#scene/scene';
import { PHYSICS } from '#simulation/physics-version';
import type { RunSetup } from '#simulation/run-setup';
import { version } from '../../../../package.json';

import { t } from '../../kit/i18n';
import { repeatShown } from '../../session/run/repeat-shown';
import { clockText } from '../../session/run/use-run-text';
import type { Workplace } from '../../session/work/model/parts';
import type { Course } from '#catalogue/course';
import { courseName } from '../../session/work/catalogue/first-course';
import { readyCourses } from '../../session/work/catalogue/ready-courses';

import { hasNothingOwn } from '../../session/work/use-courses';
import { useOpenings } from '../../session/work/use-openings';
import { reasonOf } from './problem-words';
import { showRun, tell, watchLate } from './show-run';
import shareWords from './words';

export { lookAtFeedback } from './look-at-feedback';

const words = shareWords.run;

/** The devices' own clocks may end this much after the first one's, in µs: a program that ends then has ended. */
const END_US = 4000;

/** A recorded run to be opened. */
interface Given {
  readonly text: string;
  /** Its name in messages: that of its file. */
  readonly file: string;
  /** Name of the file without its ending; left out: it came in a link. */
  readonly stem?: string;
  /** The moment that is shown first, in simulated µs. */
  readonly atUs: number;
}

/**
 * Opens the project of a recorded run, then runs it again: if the result is the same, the page looks back at it, else a
 * message says what is wrong, and the project stays open.
 *
 * @returns why nothing was opened; `null`: the project is open, and the rest goes on by itself
 */
export function openRun(app: Workplace, given: Given): string | null {
  const { file, stem } = given;
  const read = parseTape(given.text);
  if ('problem' in read) {
    const fault = t(words[read.fault === 'newer' ? 'newer' : 'damaged'], { file });
    if (read.setup === null || openProject(app, read.setup, stem) !== null) return fault;
    tell(app, 'warn', `${fault} ${t(words.projectIsOpen)}`);
    return null;
  }
  const { tape, changes, changedPrograms } = read;
  const refusal = openProject(app, tape.setup, stem);
  if (refusal !== null) return t(shareWords.problems.file, { file, reason: refusal });
  const [device] = changedPrograms;
  const isAlone = tape.setup.devices.length === 1;
  if (device !== undefined) tell(app, 'warn', t(isAlone ? words.program : words.programOf, { file, device }));
  else if (changes.length > 0) tell(app, 'warn', t(words.setup, { file }));
  else void check(app, given, tape);
  return null;
}

/** @returns why it was not opened */
function openProject(app: Workplace, setup: RunSetup, stem?: string): string | null {
  const read = projectOfRun(setup, stem ?? t(shareWords.shared));
  if ('problems' in read) return reasonOf(read.problems);
  const { project: before, file: openFile } = app.work.work.value;
  const project = inTask(app, { ...read.project, course: courseOf(read.project.scene) });
  const name = courseName(project.scene, project.course);
  useOpenings(app).open(project, name, openFile === undefined && hasNothingOwn(before), stem);
  return null;
}

/** The project in the open task, if that was handed out and allows the program: a run does not know its task. */
function inTask({ work }: Workplace, ofRun: Project): Project {
  const { project: before } = work.work.value;
  const { locks } = work;
  if (locks.task.value === null || !isSameCourse(before.scene, ofRun.scene) || ofRun.devices !== undefined)
    return ofRun;
  const { files, task, handIn } = locks.changed(before, withFiles(before, 0, ofRun.files), false) ?? {};
  if (files === undefined || task === undefined) return ofRun;
  const settings = locks.isLocked('robot') ? before.settings : ofRun.settings;
  return { ...ofRun, files, task, ...(handIn && { handIn }), ...(settings && { settings }) };
}

/** The id of the ready course with the same name and description, or `null`: a run does not know its course. */
function courseOf({ name, description }: Scene): string | null {
  const isCalledSo = ({ scene }: Course): boolean => scene.name === name && scene.description === description;
  return readyCourses.find(isCalledSo)?.id ?? null;
}

/** Repeats the run, and shows it if its result is the recorded one, or if the physics has changed since. */
async function check(app: Workplace, { file, atUs }: Given, tape: Tape): Promise<void> {
  const { setup, result, untilProgramEnds, madeBy, physics } = tape;
  const { action } = app.notices.current.value ?? {};
  // One that does not end where it did is another one already.
  const untilUs = Math.min(tape.untilUs, result.simulatedUs + END_US);
  const ends = { untilUs: tape.untilUs, untilProgramEnds };
  const giveUp = new AbortController();
  const isLate = watchLate(app, () => giveUp.abort());
  try {
    const wish = { setup, untilUs, untilProgramEnds, momentsSinceUs: -1 };
    const repeated = await repeatShown(app, wish, (percent) => t(words.checking, { file, percent }), giveUp);
    if (isLate()) return;
    if (repeated === null) tell(app, 'info', t(words.givenUp, { file }), action);
    else if (differences(result, repeated.result).length === 0) {
      const { simulatedUs: untilUs } = result;
      await showRun(app, repeated, { kept: setup, untilUs, ends, atUs });
      const at = clockText(Math.min(atUs, untilUs), true);
      tell(app, 'ok', t(atUs === 0 ? words.isSame : words.isSameAt, { file, at }), action);
    } else if (physics !== PHYSICS) {
      const untilUs = Math.min(result.simulatedUs, repeated.result.simulatedUs);
      await showRun(app, repeated, { kept: setup, untilUs, ends, atUs });
      tell(app, 'warn', t(physics < PHYSICS ? words.olderPhysics : words.newerPhysics, { file }), action);
    } else {
      const text = madeBy === version ? words.differs : words.differsSince;
      tell(app, 'warn', t(text, { file, madeBy, version }), action);
    }
  } catch {
    if (!isLate()) tell(app, 'warn', t(words.failed, { file }), action);
  } finally {
    isLate.end();
  }
}
