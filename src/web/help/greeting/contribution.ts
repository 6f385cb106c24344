import { mdiChip, mdiPencilRuler, mdiRobotOutline } from '@mdi/js';

import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import { usePage } from '../../kit/parts';
import { useLayout } from '../../session/layout/parts';
import { useRun } from '../../session/run/parts';
import { useVisit } from '../../session/visit/parts';
import { useWork } from '../../session/work/model/parts';
import words from '../words';
import greetingWords from '../words/greeting';
import { chooseStage } from './choose-stage';
import { STAGES, stageOf, type Stage } from './stage';

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
        heading: () => t(words.stages.stages),
        entries() {
          if (host.parts.value !== null) return []; // the host says what is shown
          const now = stageOf(app.settings.current.value, app.layout.kind.value !== 'phone');
          return STAGES.map((stage) => ({
            id: stage,
            testId: `stage-${stage}`,
            icon: icons[stage],
            title: t(greetingWords.stages[stage].name),
            choice: 'radio',
            isChosen: stage === now,
            act: () => void chooseStage(app, stage),
          }));
        },
      },
    ];
  },
};
