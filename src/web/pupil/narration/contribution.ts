import { mdiAccountVoice, mdiMusicNoteOutline } from '@mdi/js';

import { tick } from '../../kit/controls/tick';
import type { Contribution } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import showWords from '../../session/layout/words';
import { useWork } from '../../session/work/model/parts';

/** The telling of the drive, and its tones while it is on. */
export const contribution: Contribution = {
  menu() {
    const { settings } = useWork();
    const entry = (name: 'tell' | 'tones', id: string, icon: string) => ({
      ...{ id, testId: id, icon, title: t(showWords[name].title) },
      ...tick(settings.current.value[name]),
      act: () => settings.change({ [name]: !settings.current.value[name] }),
    });
    return [
      {
        group: 'hints',
        order: 60,
        entries: () => [
          entry('tell', 'tell-switch', mdiAccountVoice),
          ...(settings.current.value.tell ? [entry('tones', 'tones-switch', mdiMusicNoteOutline)] : []),
        ],
      },
    ];
  },
};
