import type { CourseDocument } from '#intake/document';

import type { WithLate } from '../../kit/state/late-models';
import type { WorkParts } from '../../session/work/model/parts';
import { elsewhereOf } from './parts';

/** Tells of a course that has just been opened, if it is a world of WebTigerPython. */
export function tellOfCourse(
  app: Pick<WorkParts, 'work'> & WithLate,
  { isFromWebTigerPython, scene, notes }: CourseDocument,
  isLink: boolean,
): void {
  if (isFromWebTigerPython) elsewhereOf(app).brought.tell({ files: [], scene, isLink, notes, rewritten: [] });
}
