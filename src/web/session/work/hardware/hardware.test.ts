import { describe, expect, it } from 'vitest';

import { findRobot } from '#robots/index';
import { defaultScene, type Scene } from '#scene/scene';
import { hardwareOf, settingsFor, startOptions, withCourseOptions, withOption, withOptions } from './hardware';
import { defaultSettings, type Settings } from '../settings/settings';

const lite = findRobot('maqueen-lite')!;
const callibot = findRobot('callibot')!;
const settings = (parts: Partial<Settings> = {}): Settings => ({ ...defaultSettings('de'), ...parts });
const empty = defaultScene();
/** A course in which the Maqueen Lite carries a claw. */
const withClaw: Scene = { ...empty, robot: { ...empty.robot, type: lite.id, options: { S1: 'claw' } } };
const program = (text: string, scene = empty) => ({ scene, files: [{ name: 'main.py', text }] });
const drive = program('from mbrobot import *');

describe('the hardware of the next run', () => {
  it('carries what the course says, and what was changed by hand wins', () => {
    const course = program('from mbrobot import *', withClaw);
    expect(hardwareOf(course, settings())?.options).toMatchObject({ S1: 'claw', S2: 'none' });
    const changed = settings({ robotOptions: { [lite.id]: { S1: 'none', S2: 'claw' } } });
    expect(hardwareOf(course, changed)?.options).toMatchObject({ S1: 'none', S2: 'claw' });
  });

  it('knows nothing of what was changed about another robot', () => {
    const changed = settings({ robotOptions: { [callibot.id]: { S1: 'claw' } } });
    expect(hardwareOf(drive, changed)?.options).toEqual(startOptions(lite, empty));
  });

  it('has a board that follows the robot while nobody chose one', () => {
    expect(hardwareOf(program(''), settings({ robot: callibot.id }))?.board.id).toBe('calliope-mini-3');
    expect(hardwareOf(program('from callibot import *'), settings())?.robot).toBe(callibot);
  });

  it('is unknown where the course names a robot that there is not', () => {
    const scene = { ...empty, robot: { ...empty.robot, type: 'tank' } };
    expect(hardwareOf(program('', scene), settings())).toBeNull();
  });
});

describe('a changed option', () => {
  it('is kept by the robot, and no longer once it is as in the course again', () => {
    const once = withOption(settings(), lite, withClaw, ['S1', 'none']);
    expect(once.robotOptions).toEqual({ [lite.id]: { S1: 'none' } });
    const twice = withOption(settings(once), lite, withClaw, ['S2', 'claw']);
    expect(twice.robotOptions).toEqual({ [lite.id]: { S1: 'none', S2: 'claw' } });
    expect(withOption(settings(twice), lite, withClaw, ['S1', 'claw']).robotOptions).toEqual({
      [lite.id]: { S2: 'claw' },
    });
    expect(withOption(settings(once), lite, withClaw, ['S1', 'claw']).robotOptions).toEqual({});
  });

  it('gives way where a course that is opened sets the same one; others stay', () => {
    const changed = settings({ robotOptions: { [lite.id]: { S1: 'none', echo: 'long-pulse' }, [callibot.id]: { S1: 'claw' } } }); // prettier-ignore
    expect(withCourseOptions(changed, lite, withClaw).robotOptions).toEqual({
      [lite.id]: { echo: 'long-pulse' },
      [callibot.id]: { S1: 'claw' },
    });
    expect(withOptions(changed, lite, []).robotOptions).toEqual({ [callibot.id]: { S1: 'claw' } });
  });
});

describe('a program that came with a robot', () => {
  const withCallibot = program('from callibot import *');

  it('changes nothing where it runs as it is', () => {
    expect(settingsFor(callibot, withCallibot, settings())).toEqual({ robot: 'auto', device: 'auto' });
    const byHand = settings({ robot: callibot.id, device: 'calliope-mini-2' });
    expect(settingsFor(callibot, withCallibot, byHand)).toEqual({ robot: callibot.id, device: 'calliope-mini-2' });
  });

  it('leaves the choice to itself where another robot or board was chosen by hand', () => {
    expect(settingsFor(callibot, withCallibot, settings({ robot: lite.id }))).toEqual({
      robot: 'auto',
      device: 'auto',
    });
    const board = settings({ device: 'microbit-v2' });
    expect(settingsFor(callibot, withCallibot, board)).toEqual({ robot: 'auto', device: 'auto' });
    expect(settingsFor(callibot, withCallibot, settings({ robot: 'none' }))).toEqual({ robot: 'auto', device: 'auto' });
  });

  it('names its robot, and if need be the board, where the course would choose another', () => {
    const inLite = program('from callibot import *', withClaw);
    expect(settingsFor(callibot, inLite, settings())).toEqual({ robot: callibot.id, device: 'auto' });
    const inMicrobit = program('from callibot import *', { ...withClaw, board: 'microbit-v2' });
    expect(settingsFor(callibot, inMicrobit, settings())).toEqual({ robot: callibot.id, device: 'calliope-mini-3' });
  });
});
