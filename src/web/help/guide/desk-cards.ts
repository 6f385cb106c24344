import { mdiHelpCircleOutline } from '@mdi/js';
import { watch } from 'vue';

import type { DeskCards } from '../../kit/features/desk-card';
import { t } from '../../kit/i18n';
import { useWork } from '../../session/work/model/parts';
import { useFirstSteps } from '../parts';
import words from '../words';
import { useGuide } from './use-guide';

/** The way to the help, and each of its entries that the search finds. */
export const deskCards: DeskCards = (search) => {
  const help = useFirstSteps().guide;
  const { guide, query, sections } = useGuide(useWork());
  watch(search, (text) => (query.value = text), { immediate: true, flush: 'sync' });
  return [
    {
      part: 'teach',
      order: 30,
      testId: 'desk-help',
      icon: mdiHelpCircleOutline,
      title: () => t(words.stages.help),
      about: () => t(words.stages.desk),
      found: () =>
        sections.value.flatMap((section) =>
          section.kind === 'commands' || guide.value === null
            ? []
            : section.entries.map(({ id, name }) => ({
                ...{ id, title: guide.value === null ? id : name(guide.value.content), about: section.title },
                open: (desk) => desk.leaveFor(() => help.open(id)),
              })),
        ),
      open: (desk) => desk.leaveFor(() => help.open()),
    },
  ];
};
