import { mdiProjectorScreenOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { openProjector } from '../../session/layout/open-projector';
import { useLayout } from '../../session/layout/parts';
import showWords from '../../session/layout/words';
import { pageMenuPart } from '../../session/layout/page-menu-part';
import { useWork } from '../../session/work/model/parts';

export const contribution: Contribution = {
  menu() {
    const app = { ...useWork(), ...useLayout() };
    return [
      pageMenuPart({
        id: 'projector',
        order: 40,
        icon: mdiProjectorScreenOutline,
        title: () => t(showWords.projector.title),
        open: () => void openProjector(app),
      }),
    ];
  },
};
