import { mdiCheckboxBlankOutline, mdiCheckboxMarked } from '@mdi/js';

import type { MenuEntry } from './menu-entry';

/** An entry's tick, at its end. */
export const tick = (isChosen: boolean): Pick<MenuEntry, 'choice' | 'isChosen' | 'endIcon'> => ({
  ...{ choice: 'checkbox', isChosen },
  endIcon: isChosen ? mdiCheckboxMarked : mdiCheckboxBlankOutline,
});
