import { mdiChip, mdiPencilRuler, mdiRobotOutline } from '@mdi/js';

import type { Contribution } from '../../../kit/features/feature';
import { t } from '../../../kit/i18n';
import { usePage } from '../../../kit/parts';
import { useLayout } from '../parts';
import { useRun } from '../../run/parts';
import { useVisit } from '../../visit/parts';
import { useWork } from '../../work/model/parts';
import { chooseStage } from './choose-stage';
import { STAGES, stageOf, type Stage } from './stage';
import words from './words';

const icons: Readonly<Record<Stage, string>> = { board: mdiChip, robot: mdiRobotOutline, all: mdiPencilRuler };

/** The choice of a stage in the main menu. */
export const contribution: Contribution = {
  menu() {
    const app = { ...usePage(), ...useRun(), ...useWork(), ...useLayout() };
    const { host } = useVisit();
    return [
      {
        group: 'stages',
        order: 0,
        heading: () => t(words.heading),
        entries() {
          if (host.parts.value !== null) return []; // the host says what is shown
          const now = stageOf(app.settings.current.value, app.layout.kind.value !== 'phone');
          return STAGES.map((stage) => ({
            id: stage,
            testId: `stage-${stage}`,
            icon: icons[stage],
            title: t(words[stage].name),
            choice: 'radio',
            isChosen: stage === now,
            act: () => void chooseStage(app, stage),
          }));
        },
      },
    ];
  },
};
