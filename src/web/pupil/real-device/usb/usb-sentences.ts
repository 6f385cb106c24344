import { t } from '../../../kit/i18n';
import { boardNames } from '../board/boards';
import type { UsbProblem } from './usb-problem';
import words from './words';

const problems = words.problems;

/** A problem and the way out of it, a sentence or two each. */
export function usbSentences(problem: UsbProblem): { readonly what: string; readonly way: string } {
  switch (problem.kind) {
    case 'unplugged':
      return both(problems[problem.isTouched ? 'broken-off' : 'unplugged']);
    case 'other-board':
      return both(problems['other-board'], { found: boardNames[problem.found] });
    case 'too-large':
      return both(problems['too-large'], { bytes: problem.missingBytes, files: problem.large.join(', ') });
    case 'name':
      return both(problems.name, { name: problem.name });
    default:
      return both(problems[problem.kind]);
  }
}

type Sentences = (typeof problems)['line'];

const both = ({ what, way }: Sentences, values: Readonly<Record<string, string | number>> = {}) => ({
  what: t(what, values),
  way: t(way, values),
});
