import type { VisitParts } from '../../visit/parts';
import type { CourseEditorParts } from '../state/parts';
import { createOwnParts, type OwnParts } from './own-parts';

const known = new WeakMap<object, OwnParts>();

/** The own parts of a page, the same each time the shelf is opened. A page that keeps no work keeps none of them either. */
export function ownPartsOf({ editor, host }: Pick<CourseEditorParts, 'editor'> & VisitParts): OwnParts {
  const parts = known.get(editor) ?? createOwnParts(storeOf(host.wish.keepsWork));
  known.set(editor, parts);
  return parts;
}

function storeOf(keepsWork: boolean): Storage | null {
  try {
    return keepsWork ? localStorage : null;
  } catch {
    return null; // the browser forbids it
  }
}
