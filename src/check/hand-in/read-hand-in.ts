import { summaryOf } from '#scene/json-file';
import { Reader } from '#scene/reader';
import { defaultScene } from '#scene/scene';
import type { Carried, Project, SourceFile } from '#project/project';
import { chosenLevel } from '../task/chosen-level';
import { locksOf } from '../task/read-task';
import { noLocks, taskLimits } from '../task/task';
import { HAND_IN_VERSION, handInLimits, saidRemarks, type HandIn, type Said } from './hand-in';

/** The hand-in of a project that a pupil has saved or sent, or the reason why it has none. Never throws. */
export function handInOf(
  project: Project,
): { readonly handIn: HandIn } | { readonly problem: string; readonly isNewer: boolean } {
  const { handIn: data, task, ...plain } = project;
  const mark = task?.['handedOut'] === true ? task['course'] : undefined;
  const level = chosenLevel(task);
  const marked = { ...(typeof mark === 'string' && { mark }), ...(level !== null && { level }) };
  if (data === undefined) return { handIn: { project: plain, hasCourse: true, said: null, ...marked } };
  const { version } = data;
  if (version !== HAND_IN_VERSION) {
    const isNewer = typeof version === 'number' && version > HAND_IN_VERSION;
    const way = isNewer ? 'Update Parcours.' : 'It is damaged.';
    return { problem: `handIn: version ${JSON.stringify(version) ?? 'nothing'} is unknown. ${way}`, isNewer };
  }
  const reader = new Reader();
  const said = saidIn(data, reader);
  if (reader.problems.length > 0) return { problem: summaryOf(reader.problems), isNewer: false };
  const locks = task?.['handedOut'] === true ? locksOf(task) : noLocks;
  return { handIn: { project: plain, hasCourse: true, said, locks, ...marked } };
}

/** A program alone, handed in. */
export const handInOfFiles = (files: readonly SourceFile[]): HandIn => ({
  project: { files, scene: defaultScene(), course: null },
  hasCourse: false,
  said: null,
});

function saidIn(data: Carried, reader: Reader): Said {
  // The series of a task, the begin of an exam and a teacher's feedback are for the pupil's page; they have no part in the check.
  const { task, alias, verdict, tries, hash, remarks } = reader.fields(data, 'handIn', [
    ...['version', 'task', 'alias', 'verdict', 'tries', 'hash', 'remarks', 'series', 'begunMs', 'feedback'],
  ]);
  const listed =
    remarks === undefined ? [] : reader.list(remarks, 'handIn.remarks', { min: 0, max: saidRemarks.length });
  return {
    task: reader.text(task, 'handIn.task', taskLimits.idCharacters, ''),
    alias: reader.text(alias, 'handIn.alias', handInLimits.aliasCharacters, ''),
    verdict: reader.word(verdict, 'handIn.verdict', ['open', 'passed', 'failed', 'helped'], 'open'),
    tries: reader.whole(tries, 'handIn.tries', handInLimits.tries, 0),
    hash: reader.text(hash, 'handIn.hash', handInLimits.hashCharacters, ''),
    remarks: listed.map((one, index) => reader.word(one, `handIn.remarks[${String(index)}]`, saidRemarks, 'course')),
  };
}
