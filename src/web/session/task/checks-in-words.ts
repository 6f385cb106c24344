import { checkText } from '#check/task/check-text';
import { ledDrawing } from '#check/task/led-drawing';
import { draftOf } from '#check/task/read-task';
import type { Check } from '#check/task/task';
import type { Project } from '#project/project';

import { shownLanguage, t } from '../../kit/i18n';
import taskWords from './words';

/** A check of a task, besides the goals of its course, in the language of the page, with its points. */
export interface CheckInWords {
  readonly id: string;
  readonly text: string;
  /** The picture that the display is to show, as SVG; `null`: it is about something else. */
  readonly leds: string | null;
  readonly gives: string;
}

const words = taskWords.checks;

/** The checks of a project's task, as pupils read them. */
export function checksInWords(project: Project): readonly CheckInWords[] {
  const read = draftOf(project);
  return checkTexts('task' in read ? read.task.checks : []);
}

/** The same for the checks of a task that has been read. */
export function checkTexts(all: readonly Check[]): readonly CheckInWords[] {
  return all.flatMap((check) => {
    if (check.type === 'goals') return [];
    const points = check.points === 1 ? t(words.point) : t(words.points, { points: check.points });
    const gives = check.needed ? points : `${points}, ${t(words.optional)}`;
    const leds = check.type === 'display' ? ledDrawing(check.image) : null;
    return [{ id: check.id, text: checkText(check, shownLanguage()), leds, gives }];
  });
}
