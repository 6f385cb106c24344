import { editProblem } from '#scene/check-edit';

import type { CourseEditorModel } from './state/course-editor-model';
import { wordsFor } from './words/happened-words';

/** Gives the editor what comes with its first use: the limits of a course, and words for what happens. */
export function joinEditor(editor: CourseEditorModel): void {
  editor.join({ problemOf: editProblem, wordsFor });
}
