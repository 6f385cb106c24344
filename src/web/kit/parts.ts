import type { DialogsModel } from './dialogs';
import type { WithLate } from './state/late-models';
import type { NoticesModel } from './notices';
import { part } from './part';

/** The models that any part of the page may use to notify or ask. */
export interface PageParts extends WithLate {
  readonly notices: NoticesModel;
  readonly dialogs: DialogsModel;
}

export const [providePage, usePage] = part<PageParts>('page');
