import { shallowRef, type ShallowRef } from 'vue';

import { lateModel } from '../../kit/state/late-models';
import type { RunParts } from '../../session/run/parts';
import type { SoundPlayer } from '../../session/run/sound/sound-player';
import { CountDown } from './count-down';
import { readTimer, writeTimer } from './kept-timer';
import { ring } from './ring';

/** The timer of a page, and whether its end is heard. */
export interface ProjectorTimer {
  readonly countDown: CountDown;
  readonly hasSound: Readonly<ShallowRef<boolean>>;
  /** Switched on, it is heard at once: so nobody is surprised in front of a class. */
  switchSound(on: boolean): void;
}

/** The timer of this page, made when the projector view is opened for the first time; it goes on while that is left. */
export const timerOf = lateModel(({ sound }: Pick<RunParts, 'sound'>) => createTimer(sound));

function createTimer(sound: SoundPlayer): ProjectorTimer {
  const kept = readTimer();
  const hasSound = shallowRef(kept.hasSound);
  let { timer } = kept;
  const keep = (): void => writeTimer({ timer, hasSound: hasSound.value });
  const countDown = new CountDown(
    {
      now: () => Date.now(),
      after(ms, act) {
        const id = setTimeout(act, ms);
        return () => clearTimeout(id);
      },
    },
    timer,
    (now) => {
      timer = now;
      keep();
    },
    () => {
      if (hasSound.value) void ring(sound);
    },
  );
  return {
    countDown,
    hasSound,
    switchSound(on) {
      hasSound.value = on;
      keep();
      if (on) void ring(sound, 1);
    },
  };
}
