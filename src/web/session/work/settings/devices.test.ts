import { describe, expect, it } from 'vitest';

import { microbitV2 } from '#board/boards/microbit-v2';
import { boardWish, deviceName, devices, firmwareOf, isDevice, isRobotChoice } from './devices';
import { defaultSettings, settingsFromText } from './settings';

describe('the devices', () => {
  it('are the micro:bit V2, the Calliope mini 3, and the Calliope mini 1/2, which runs as a mini 3', () => {
    expect(devices.map(({ name, board }) => [name, board])).toEqual([
      ['micro:bit V2', 'microbit-v2'],
      ['Calliope mini 3', 'calliope-mini-3'],
      ['Calliope mini 1/2', 'calliope-mini-3'],
    ]);
    for (const { about } of devices) expect(about).not.toBeNull();
  });

  it('ask for their board; without a choice the program’s imports decide', () => {
    expect(boardWish('calliope-mini-2')).toBe('calliope-mini-3');
    expect(boardWish('auto')).toBe('auto');
    expect(boardWish('something else')).toBe('auto');
  });

  it('are called as they were chosen', () => {
    expect(deviceName('calliope-mini-2', microbitV2)).toBe('Calliope mini 1/2');
    expect(deviceName('auto', microbitV2)).toBe('micro:bit V2');
  });

  it('have the chosen firmware where there is one of that name, else their usual one', () => {
    expect(firmwareOf(microbitV2, 'newest').id).toBe('newest');
    expect(firmwareOf(microbitV2, 'v2.1.2b').id).toBe('v2.1.2');
  });

  it('are kept in the settings; what is unknown counts as automatic', () => {
    const fallback = { ...defaultSettings('de'), welcomed: true };
    const stored = { ...fallback, device: 'calliope-mini-3', robot: 'none', firmware: 'newest', panel: 'radio' };
    expect(settingsFromText(JSON.stringify(stored), fallback)).toEqual(stored);
    const odd = settingsFromText('{"device":"oxocard","robot":"tank","panel":"x"}', fallback);
    expect(odd).toEqual(fallback);
    expect([isDevice('auto'), isDevice('x'), isRobotChoice('none'), isRobotChoice('tank')]).toEqual([true, false, true, false]); // prettier-ignore
  });
});
