import { withStuck } from '#editor/stuck';
import { editProblem } from '#scene/check-edit';

import type { CourseEditorModel } from './state/course-editor-model';
import { wordsFor } from './words/happened-words';

/** Gives the editor what is loaded on first use: the limits of a course, and the announcements for screen readers. */
export function joinEditor(editor: CourseEditorModel): void {
  editor.join({ problemOf: editProblem, whole: withStuck, wordsFor });
}
