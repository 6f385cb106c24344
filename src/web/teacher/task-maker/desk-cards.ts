import { mdiClipboardEditOutline } from '@mdi/js';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { useWork } from '../../session/work/model/parts';
import { workName } from '../../session/work/work-name';
import { useTaskMaker } from './use-task-maker';
import words from './words';

export const deskCards: DeskCards = () => {
  const app = useWork();
  const { task, isGiven } = useTaskMaker(app);
  return [
    {
      part: 'prepare',
      order: 10,
      testId: 'menu-task',
      icon: mdiClipboardEditOutline,
      title: () => t(words.title),
      about: () => t(words.card),
      left() {
        const made = task.value;
        if (app.work.work.value.project.task === undefined || isGiven.value || made === null) return null;
        return { title: workName(app), about: t(words.left, { count: made.worlds.length }) };
      },
      open: (desk) => desk.openPage('task'),
    },
  ];
};
