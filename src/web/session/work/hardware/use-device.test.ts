// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { findRobot } from '#robots/index';

import { createPage } from '../../../app/testing/page';
import { useDevice } from './use-device';

const LITE = 'maqueen-lite';

/** A page whose host holds a robot with a claw on S1, and a pupil who has stored another robot. */
function pageOfHost() {
  const page = createPage();
  const { settings } = page;
  settings.change({ robot: 'callibot', robotOptions: { callibot: { S1: 'claw' } } });
  settings.hold({ robot: LITE, robotOptions: { [LITE]: { S1: 'claw' } }, device: 'microbit-v2', seed: 3 });
  return { settings, device: useDevice(page) };
}

describe('a pupil who changes the robot in the page of a host', () => {
  beforeEach(() => vi.stubGlobal('navigator', { languages: ['de'] }));
  afterEach(() => vi.unstubAllGlobals());

  it('stores the one option that is chosen; the others are the host’s and hold', () => {
    const { settings, device } = pageOfHost();
    device.chooseOption('S2', 'claw');
    expect(settings.current.value.robotOptions).toEqual({ [LITE]: { S1: 'claw', S2: 'claw' } });
    expect(settings.own.value.robotOptions).toEqual({ callibot: { S1: 'claw' }, [LITE]: { S2: 'claw' } });
    expect(settings.own.value).toMatchObject({ robot: 'callibot', device: 'auto', seed: 1 });
  });

  it('takes the changes back for this robot, and keeps those of the others', () => {
    const { settings, device } = pageOfHost();
    device.chooseOption('S2', 'claw');
    device.resetOptions();
    expect(settings.current.value.robotOptions).toEqual({});
    expect(settings.own.value.robotOptions).toEqual({ callibot: { S1: 'claw' } });
  });

  it('plugs a board into a gamepad in what holds and in the own choice, and out again', () => {
    const { settings, device } = pageOfHost();
    device.chooseInHand('gamepad');
    expect(settings.current.value.robotOptions).toEqual({ [LITE]: { S1: 'claw' }, none: { inHand: 'gamepad' } });
    expect(settings.own.value.robotOptions).toEqual({ callibot: { S1: 'claw' }, none: { inHand: 'gamepad' } });
    device.chooseInHand(null);
    expect(settings.current.value.robotOptions).toEqual({ [LITE]: { S1: 'claw' } });
    expect(settings.own.value.robotOptions).toEqual({ callibot: { S1: 'claw' } });
  });

  it('opens a program with its robot without storing what the host has chosen', () => {
    const { settings, device } = pageOfHost();
    device.bringRobot(findRobot(LITE)!, { S2: 'claw' });
    expect(settings.current.value).toMatchObject({ robot: LITE, device: 'microbit-v2' });
    expect(settings.own.value).toMatchObject({ robot: 'callibot', device: 'auto' });
    expect(settings.own.value.robotOptions).toEqual({ callibot: { S1: 'claw' }, [LITE]: { S2: 'claw' } });
  });
});
