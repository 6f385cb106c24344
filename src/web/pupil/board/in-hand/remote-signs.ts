import {
  mdiArrowDown,
  mdiArrowUp,
  mdiFastForward,
  mdiPlayPause,
  mdiPower,
  mdiRewind,
  mdiVolumeMinus,
  mdiVolumePlus,
} from '@mdi/js';

import type { RemoteKey } from '#devices/nec-remote';

/** The signs on the keys of the remote control that are pictures. */
export const remoteIcons: Partial<Record<RemoteKey, string>> = {
  ...{ power: mdiPower, volumeUp: mdiVolumePlus, volumeDown: mdiVolumeMinus },
  ...{ left: mdiRewind, play: mdiPlayPause, right: mdiFastForward, down: mdiArrowDown, up: mdiArrowUp },
};

const letters: Partial<Record<RemoteKey, string>> = { func: 'FUNC', eq: 'EQ', repeat: 'REPT' };

/** The letters or the digit on a key that has no picture. */
export const remoteLetters = (key: RemoteKey): string => letters[key] ?? key;
