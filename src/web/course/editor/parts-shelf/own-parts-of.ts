import { lateModel } from '../../../kit/state/late-models';
import type { VisitParts } from '../../../session/visit/parts';
import { createOwnParts } from './own-parts';

/** The own parts of a page, the same each time the shelf is opened. A page that keeps no work keeps none of them either. */
export const ownPartsOf = lateModel(({ host }: VisitParts) => createOwnParts(storeOf(host.wish.keepsWork)));

function storeOf(keepsWork: boolean): Storage | null {
  try {
    return keepsWork ? localStorage : null;
  } catch {
    return null; // the browser forbids it
  }
}
