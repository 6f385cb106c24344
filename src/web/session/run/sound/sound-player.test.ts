// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import type { SoundEvent } from '#board/sound/sound-event';
import { SoundPlayer } from './sound-player';

vi.mock('./sound-mixer', () => ({
  SoundMixer: class {
    readonly endS = 0;
    readonly play = (event: SoundEvent): void => void heard.push(event);
    readonly stop = (): void => undefined;
    readonly reset = (): void => undefined;
  },
}));

const heard: SoundEvent[] = [];
let made = 0;
const activation = { hasBeenActive: false };
const tone = { type: 'tone', hz: 440, timeUs: 0 } as unknown as SoundEvent;

beforeEach(() => {
  made = 0;
  heard.length = 0;
  activation.hasBeenActive = false;
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  vi.stubGlobal(
    'AudioContext',
    class {
      state = 'running';
      currentTime = 0;
      constructor() {
        made += 1;
      }
      suspend = () => Promise.resolve();
      resume = () => Promise.resolve();
      close = () => Promise.resolve();
    },
  );
  Object.defineProperty(navigator, 'userActivation', { configurable: true, value: activation });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe('the sound of a run that is opened from a link', () => {
  it('asks for no sound system before the first tap, says that it is blocked, and is heard from the tap on', async () => {
    const player = new SoundPlayer();
    player.setSpeed(1);
    player.wake();
    player.take([tone]);
    await vi.dynamicImportSettled();
    vi.advanceTimersByTime(1000);
    expect([made, player.isBlocked.value, heard]).toEqual([0, true, []]);
    activation.hasBeenActive = true;
    player.wake();
    player.take([tone]);
    expect([made, heard]).toEqual([1, [tone]]);
    player.dispose();
  });
});
