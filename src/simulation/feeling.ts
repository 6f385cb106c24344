import type { InputEvent } from './input';
import { NO_ROBOT, type DeviceSetup } from './run-setup';

/**
 * The inputs with which the boards of a run feel the arena from the start: those on a robot, and of several devices all,
 * because they hear each other. The hand's inputs come after them: what it sets stays.
 */
export function feelingInputs(devices: readonly Pick<DeviceSetup, 'name' | 'robot'>[]): readonly InputEvent[] {
  return devices.flatMap(({ name, robot }, place): InputEvent[] => {
    if (robot === NO_ROBOT && devices.length === 1) return [];
    const felt: InputEvent = { timeUs: 0, action: { type: 'arena-senses', on: true } };
    return [place === 0 ? felt : { ...felt, device: name }];
  });
}
