import type { Texts } from '#core/languages';
import type { FileProblem } from '#intake/document';
import type { LinkProblem } from '#project/link/link';
import type { ProgramLinkProblem } from '#project/webtigerpython/program-link';

import { t } from '../../kit/i18n';
import shareWords from './words';

const words = shareWords.problems;

const byCode: Readonly<Record<FileProblem['code'], Texts>> = {
  'too-long': words.tooLong,
  'not-json': words.notJson,
  'not-a-scene': words.notOurs,
  'not-a-project': words.notOurs,
  'is-a-class': words.isAClass,
  'not-a-level': words.notALevel,
  'not-a-series': shareWords.series.notASeries,
  'not-beside': shareWords.series.fileBeside,
  'unknown-version': words.unknownVersion,
  'newer-version': words.newerFile,
  missing: words.missing,
  'wrong-type': words.wrongType,
  'not-whole': words.wrongType,
  'not-one-line': words.wrongType,
  'out-of-range': words.outOfRange,
  'too-many': words.tooMany,
  'unknown-property': words.unknown,
  'unknown-value': words.wrongType,
  'unknown-id': words.unknown,
  damaged: words.damagedPart,
  'links-too-large': words.linksTooLarge,
  'duplicate-id': words.duplicate,
  'wall-without-length': words.noLength,
  'ball-not-round': words.notRound,
  'said-twice': words.saidTwice,
  'polygon-crossing': words.crossing,
  'polygon-too-small': words.tooSmall,
  'group-of-one': words.groupOfOne,
  'robot-outside': words.wrongType,
  'robot-inside': words.wrongType,
  'unknown-robot': words.wrongType,
  'unknown-board': words.wrongType,
  'no-main': words.noMain,
  'file-name': words.fileName,
  'file-too-large': words.tooLong,
  'device-name': words.deviceName,
  'too-many-devices': words.tooManyDevices,
  'same-as': words.sameAs,
};

/** The fault of a file in words: the first problem, and the number of further ones. */
export function reasonOf(problems: readonly FileProblem[]): string {
  const [first] = problems;
  if (first === undefined) return '';
  const { code, path, value, params } = first;
  const reason = t(byCode[code], { ...params, path: path === '' ? 'JSON' : path, value });
  return problems.length === 1 ? reason : t(words.more, { reason, count: problems.length - 1 });
}

/** Why a link opens nothing, in words. */
export function linkReason(problem: LinkProblem | ProgramLinkProblem): string {
  const { code } = problem;
  switch (code) {
    case 'damaged':
      return t(words.damagedLink);
    case 'newer-version':
      return t(words.newerLink);
    case 'too-large':
    case 'too-long':
      return t(words.hugeLink);
    case 'unknown-form':
      return t(words.unknownForm);
    case 'unknown-course':
      return t(words.unknownCourse, problem.params);
    case 'invalid':
      return t(words.invalidLink, { reason: reasonOf(problem.problems) });
    default:
      return code satisfies never;
  }
}
