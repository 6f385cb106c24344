import { mdiProjectorScreenOutline } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { openProjector } from '../../session/layout/open-projector';
import { useLayout } from '../../session/layout/parts';
import showWords from '../../session/layout/words';
import { useWork } from '../../session/work/model/parts';

export const deskCards: DeskCards = () => {
  const app = { ...useWork(), ...useLayout() };
  return [
    {
      part: 'teach',
      order: 10,
      testId: 'menu-projector',
      icon: mdiProjectorScreenOutline,
      title: () => t(showWords.projector.title),
      about: () => t(showWords.projector.about),
      open: (desk) => desk.leaveFor(() => void openProjector(app)),
    },
  ];
};
