import { mdiFolderStarOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import { pageMenuPart } from '../../session/layout/page-menu-part';
import words from './words';

export const contribution: Contribution = {
  menu() {
    const { router } = useLayout();
    return [
      pageMenuPart({
        id: 'works',
        order: -10, // before the galleries
        icon: mdiFolderStarOutline,
        title: () => t(words.title),
        open: () => router.open('works'),
      }),
    ];
  },
};
