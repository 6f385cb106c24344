import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { hardwareOf } from './hardware';
import { defaultSettings, type Settings } from '../settings/settings';
import { mispluggedNotice, robotInError } from './misplugged';

const project = (text: string) => ({ scene: defaultScene(), files: [{ name: 'main.py', text }], course: null });
const settings = (parts: Partial<Settings> = {}): Settings => ({ ...defaultSettings('de'), ...parts });
const drive = project('from mbrobot import *\nforward()');

/** The notice, and the settings after its button was pressed. */
function mended(work: typeof drive, before: Settings) {
  let after = before;
  const notice = mispluggedNotice(work, before, (wish) => (after = { ...after, ...wish }));
  notice?.action.run();
  return { notice, after, left: mispluggedNotice(work, after, () => undefined) };
}

describe('the notice about what does not fit', () => {
  it('says that the program is for the Maqueen Lite while the Calli:bot is chosen; its button takes the Lite', () => {
    const { notice, after, left } = mended(drive, settings({ robot: 'callibot' }));
    expect(notice).toMatchObject({
      key: 'arena.otherRobot',
      values: { meant: 'Maqueen Lite', robot: 'Calli:bot' },
      action: { key: 'arena.takeRobot', values: { meant: 'Maqueen Lite' } },
    });
    expect(after.robot).toBe('auto');
    expect(hardwareOf(drive, after)).toMatchObject({ robot: { id: 'maqueen-lite' }, board: { id: 'microbit-v2' } });
    expect(left).toBeNull();
  });

  it('says it too where the board fits: a Plus V2 for a program of the Lite', () => {
    const { notice, left } = mended(drive, settings({ robot: 'maqueen-plus-v2' }));
    expect(notice?.key).toBe('arena.otherRobot');
    expect(left).toBeNull();
  });

  it('puts robot and board right at one press, whatever was plugged in', () => {
    const { after, left } = mended(drive, settings({ robot: 'callibot', device: 'calliope-mini-3' }));
    expect(left).toBeNull();
    expect(hardwareOf(drive, after)).toMatchObject({ robot: { id: 'maqueen-lite' }, board: { id: 'microbit-v2' } });
  });

  it('speaks of the board where only that is wrong', () => {
    const { notice, left } = mended(drive, settings({ device: 'calliope-mini-3' }));
    expect(notice?.key).toBe('arena.misplugged');
    expect(left).toBeNull();
  });

  it('is none where robot, board and program fit, and none without a robot', () => {
    expect(mispluggedNotice(drive, settings(), () => undefined)).toBeNull();
    expect(mispluggedNotice(drive, settings({ robot: 'none' }), () => undefined)).toBeNull();
  });
});

describe('what an error knows of the robot', () => {
  it('is why it cannot answer, or that none is chosen though the program needs one', () => {
    expect(robotInError(drive, settings({ robot: 'callibot' }))).toEqual({
      robot: 'Calli:bot',
      fault: { key: 'error.otherRobot', values: { meant: 'Maqueen Lite', robot: 'Calli:bot' } },
    });
    expect(robotInError(drive, settings({ robot: 'none' }))).toEqual({
      robot: null,
      fault: { key: 'error.noRobot', values: {} },
    });
    expect(robotInError(project('i2c.scan()'), settings({ robot: 'callibot' }))).toEqual({
      robot: 'Calli:bot',
      fault: null,
    });
  });
});
