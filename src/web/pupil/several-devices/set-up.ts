import { watch } from 'vue';

import { latePart } from '../../kit/late-part';
import type { SetUp } from '../../session/models/session';

/** Asks for the kind of a device, whoever wishes for one more. */
export const setUp: SetUp = (session) => {
  watch(session.work.deviceWishes, () => {
    import('./ask-device')
      .then(({ askForDevice }) => askForDevice(session))
      .catch(() => session.notices.show(latePart));
  });
};
