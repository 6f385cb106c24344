import { computed, type ComputedRef } from 'vue';

import { countedPoints, type Counted } from '#check/report/class-result';
import { isUnread } from '#check/report/texts';
import { mostPoints, type ClassTask } from '#check/task/task';
import { gradeOf } from '#school-class/grades';
import { gradeText } from '#school-class/report/say';

import { shownLanguage } from '../../../kit/i18n';
import type { WithLate } from '../../../kit/state/late-models';
import { classBookOf } from '../../class-book/use-class-book';

/** Grades by the scale of a class. */
export interface ClassGrades {
  /** The name of the class. */
  readonly name: string;
  /** The grade for the points of a hand-in that count; `null`: nothing of it could be read. */
  readonly of: (handIn: Counted) => number | null;
  /** The same in words; empty: none. */
  readonly text: (handIn: Counted) => string;
}

/**
 * The grades for a task by the scale of the class that was chosen on the page of classes since it was opened, or of the only
 * one; `null`: it has no scale, or of several none was chosen.
 */
export const gradesOf = (app: WithLate, task: () => ClassTask): ComputedRef<ClassGrades | null> =>
  computed(() => {
    const { name, scale = null } = classBookOf(app).certain.value?.schoolClass ?? { name: '' };
    if (scale === null) return null;
    const of = (one: Counted): number | null =>
      isUnread(one.result) ? null : gradeOf(scale, countedPoints(one), mostPoints(task()));
    const text = (one: Counted): string => {
      const grade = of(one);
      return grade === null ? '' : gradeText(grade, scale, shownLanguage());
    };
    return { name, of, text };
  });
