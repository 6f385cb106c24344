import { watch } from 'vue';

import { t } from '../../kit/i18n';
import type { SetUp } from '../../session/models/session';
import { CROWDED_CHARACTERS, sizeOf } from '../../session/work/storage/history';
import words from './words/notice';

/** Asks once which works may go when they need much room. None goes by itself. */
export const setUp: SetUp = ({ work, notices, router }) => {
  const stop = watch(
    () => work.work.value.previous,
    () => {
      if (sizeOf(work.work.value) < CROWDED_CHARACTERS) return;
      stop();
      notices.show({
        ...{ kind: 'warn', key: 'notice.text', values: { text: t(words.crowded) } },
        action: { key: 'notice.text', values: { text: t(words.title) }, run: () => router.open('works') },
        stays: true,
      });
    },
  );
};
