import { say } from '../page/i18n/say';
import type { PutProblem } from './problem';
import type { PutProgress, PutResult } from './put-files';
import words from './words';

const problems = words.problems;
const states = words.states;

/** The current step, in one sentence. */
export function progressSentence({ stage, file }: PutProgress): string {
  return say(states[stage], { file: file ?? '' });
}

/** The outcome, in one or two sentences. */
export function doneSentence({ machine, isStarted, said, same }: Extract<PutResult, { kind: 'done' }>): string {
  const text = !isStarted ? states.notStarted : isTraceback(said) ? states.failedAtOnce : states.done;
  const sentence = say(text, { machine });
  return same.length === 0 ? sentence : `${sentence} ${say(states.same, { files: same.join(', ') })}`;
}

/** Whether the program failed as soon as it started. */
export const isTraceback = (said: string): boolean => /^Traceback|^\s*File ".*", line \d+|Error\b/m.test(said);

/** What went wrong and what helps. */
export function problemSentence(problem: PutProblem): string {
  switch (problem.kind) {
    case 'frame':
      return say(words.noFrame);
    case 'full':
      return `${say(problems.full, { file: problem.file, bytes: problem.overBytes })} ${
        problem.others.length > 0
          ? say(problems.fullOthers, { files: problem.others.join(', ') })
          : say(problems.fullAlone)
      }`;
    case 'wrong-board':
      return say(problems['wrong-board'], { module: problem.module, machine: problem.machine });
    case 'different':
      return say(problems.different, { file: problem.file });
    default:
      return say(problems[problem.kind]);
  }
}
