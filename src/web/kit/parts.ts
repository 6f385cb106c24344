import type { DialogsModel } from './dialogs';
import type { WithLate } from './state/late-models';
import type { NoticesModel } from './notices';
import { part } from './part';

/** What any part of the page may say or ask. */
export interface PageParts extends WithLate {
  readonly notices: NoticesModel;
  readonly dialogs: DialogsModel;
}

export const [providePage, usePage] = part<PageParts>('page');
