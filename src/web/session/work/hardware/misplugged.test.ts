import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { hardwareOf } from './hardware';
import { defaultSettings, type Settings } from '../settings/settings';
import { mispluggedNotice, robotInError, robotOffer } from './misplugged';

const project = (text: string) => ({ scene: defaultScene(), files: [{ name: 'main.py', text }], course: null });
const settings = (parts: Partial<Settings> = {}): Settings => ({ ...defaultSettings('de'), ...parts });
const drive = project('from mbrobot import *\nforward()');

const at = (work: typeof drive, now: Settings, isKept = false) => ({ project: work, settings: now, isKept });

/** The notice, and the settings after its button was pressed. */
function mended(work: typeof drive, before: Settings) {
  let after = before;
  const notice = mispluggedNotice(at(work, before), (wish) => (after = { ...after, ...wish }));
  notice?.action?.run();
  return { notice, after, left: mispluggedNotice(at(work, after), () => undefined) };
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
    expect(mispluggedNotice(at(drive, settings()), () => undefined)).toBeNull();
    expect(mispluggedNotice(at(drive, settings({ robot: 'none' })), () => undefined)).toBeNull();
  });

  it('says that the task sets the robot where it does, and has no button', () => {
    const kept = at(drive, settings({ robot: 'callibot' }), true);
    expect(mispluggedNotice(kept, () => undefined)).toEqual({
      kind: 'warn',
      key: 'arena.otherRobotKept',
      values: expect.objectContaining({ meant: 'Maqueen Lite', robot: 'Calli:bot' }),
    });
  });

  it('is none for a file that has the name of a driver by chance: it may drive the robot that is chosen', () => {
    const own = { ...drive, files: [...project('import maqueen').files, { name: 'maqueen.py', text: '' }] };
    expect(mispluggedNotice(at(own, settings({ robot: 'callibot' })), () => undefined)).toBeNull();
    expect(robotInError(at(own, settings({ robot: 'callibot' }))).fault?.key).toBe('error.otherRobot');
  });
});

describe('what an error knows of the robot', () => {
  it('is why it cannot answer, or that none is chosen though the program needs one', () => {
    expect(robotInError(at(drive, settings({ robot: 'callibot' })))).toMatchObject({
      robot: 'Calli:bot',
      fault: { key: 'error.otherRobot', values: { meant: 'Maqueen Lite', robot: 'Calli:bot' } },
    });
    expect(robotInError(at(drive, settings({ robot: 'none' })))).toMatchObject({
      robot: null,
      fault: { key: 'error.lacksRobot', values: { meant: 'Maqueen Lite' } },
    });
    expect(robotInError(at(project('i2c.scan()'), settings({ robot: 'callibot' })))).toEqual({
      robot: 'Calli:bot',
      fault: null,
    });
  });

  it('is the way out within the task where a task sets the robot, or that it has none', () => {
    expect(robotInError(at(drive, settings({ robot: 'callibot' }), true)).fault).toMatchObject({
      key: 'error.otherRobotKept',
      values: { meant: 'Maqueen Lite', robot: 'Calli:bot', own: 'callibot' },
    });
    expect(robotInError(at(drive, settings({ robot: 'none' }), true)).fault?.key).toBe('error.lacksRobotKept');
  });

  it('has a button that takes the robot, also where none is chosen, but not within a task that sets it', () => {
    const taken: Partial<Settings>[] = [];
    const offer = (isKept: boolean) =>
      robotOffer(at(drive, settings({ robot: 'none' }), isKept), (wish) => void taken.push(wish));
    offer(false)?.run();
    expect(taken).toEqual([{ robot: 'auto', device: 'auto' }]);
    expect(offer(true)).toBeNull();
  });
});
