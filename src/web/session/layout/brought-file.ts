import { shallowRef, type ShallowRef } from 'vue';

import { lateModel, type WithLate } from '../../kit/state/late-models';

/** The text of a file that was opened somewhere on the page, and that the page which it belongs to takes; `null`: none. */
export const broughtFile = lateModel((): ShallowRef<string | null> => shallowRef(null));

/** Leads to the page that a file belongs to, and gives it there. */
export function bringTo(app: WithLate, page: string, text: string): void {
  broughtFile(app).value = text;
  location.hash = page;
}
