import { isSame } from '#core/same';

import type { Language } from '../../../kit/i18n/texts';
import { numberText } from '../../../kit/i18n/number-text';
import type { WorkModel } from '../model/work-model';
import { filesByDevice, programsOf, type OwnProgram } from './own-programs';

/** One of the pupil's own programs of a course. */
export type OwnChoice = readonly [kind: 'best' | 'last', own: OwnProgram];

/** The pupil's own programs for the course that is open, but for the one that is open. */
export function otherPrograms(work: Pick<WorkModel, 'programs' | 'work'>): readonly OwnChoice[] {
  const { project } = work.work.value;
  if (project.course === null) return [];
  const { best, last } = programsOf(work, project.course);
  const all = [best && (['best', best] as const), last && (['last', last] as const)].filter((one) => one !== undefined);
  const seen = [filesByDevice(project)];
  return all.filter(([, { files }]) => {
    const isNew = !seen.some((other) => isSame(files, other));
    seen.push(files);
    return isNew;
  });
}

/** A program's stars and its time; empty: none. */
export const wonWith = ({ stars, timeMs }: OwnProgram, language: Language): string =>
  stars === undefined || timeMs === undefined
    ? ''
    : `${'★'.repeat(stars)} · ${numberText(Math.round(timeMs / 100) / 10, language)} s`;
