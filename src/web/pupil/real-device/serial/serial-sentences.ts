import { t } from '../../../kit/i18n';
import type { PutProblem } from './problem';
import type { PutProgress, PutResult } from './put-files';
import words from './words';

const problems = words.problems;
const states = words.states;

/** The current step, in one sentence. */
export function progressSentence({ stage, file }: PutProgress): string {
  return t(states[stage], { file: file ?? '' });
}

/** The outcome, in one or two sentences. */
export function doneSentence({ machine, isStarted, said, same }: Extract<PutResult, { kind: 'done' }>): string {
  const text = !isStarted ? states.notStarted : isTraceback(said) ? states.failedAtOnce : states.done;
  const sentence = t(text, { machine });
  return same.length === 0 ? sentence : `${sentence} ${t(states.same, { files: same.join(', ') })}`;
}

/** True if the program failed as soon as it started. */
export const isTraceback = (said: string): boolean => /^Traceback|^\s*File ".*", line \d+|Error\b/m.test(said);

/** The problem and its remedy. */
export function problemSentence(problem: PutProblem): string {
  switch (problem.kind) {
    case 'frame':
      return t(words.noFrame);
    case 'full':
      return `${t(problems.full, { file: problem.file, bytes: problem.overBytes })} ${
        problem.others.length > 0 ? t(problems.fullOthers, { files: problem.others.join(', ') }) : t(problems.fullAlone)
      }`;
    case 'wrong-board':
      return t(problems['wrong-board'], { module: problem.module, machine: problem.machine });
    case 'different':
      return t(problems.different, { file: problem.file });
    default:
      return t(problems[problem.kind]);
  }
}
