import { describe, expect, it } from 'vitest';
import { robotTypes } from '#robots/index';
import { findBuild, robotLibraries } from '#simulation/robot-libraries';
import { filesForDevice } from './device-files';
import { allLibraries, robotOwnLibraries } from './libraries';

const named = (main: string, more: Readonly<Record<string, string>> = {}) =>
  [['main.py', main] as const, ...Object.entries(more)].map(([name, text]) => ({ name, text }));
const namesFor = (main: string, robot: string | null, more: Readonly<Record<string, string>> = {}) =>
  filesForDevice(named(main, more), robot).files.map(({ name }) => name);

describe('what a program needs on a real board', () => {
  it('is the program alone when it imports nothing that we bring', () => {
    expect(filesForDevice(named('from microbit import *\nimport music'), null)).toEqual({
      files: [{ name: 'main.py', text: 'from microbit import *\nimport music', isOwn: true }],
      modules: [['microbit']],
    });
  });

  it('is the library of the robot as well, and main.py comes last', () => {
    expect(namesFor('from mbrobot import *', 'maqueen-lite')).toEqual(['mbrobot.py', 'main.py']);
    expect(namesFor('import way', 'maqueen-lite', { 'way.py': 'import mbled' })).toEqual(['mbled.py', 'way.py', 'main.py']); // prettier-ignore
  });

  it("leaves out a library that the pupil has a file of one's own for", () => {
    expect(namesFor('import mbrobot', 'maqueen-lite', { 'mbrobot.py': '' })).toEqual(['mbrobot.py', 'main.py']);
  });

  it('follows libraries that import others: of several robots only that of this one', () => {
    expect(namesFor('from simrobot import *', 'maqueen-plus-v2')).toEqual(['simrobot.py', 'mbrobot_plusV2.py', 'main.py']); // prettier-ignore
    expect(namesFor('from simrobot import *', 'maqueen-lite')).toEqual(['simrobot.py', 'mbrobot.py', 'main.py']);
  });

  it('brings the older name of the module along for a Calliope mini, which its firmware lacks', () => {
    const { files, modules } = filesForDevice(named('import callibot'), 'callibot');
    expect(files.map(({ name }) => name)).toEqual(['callibot.py', 'cbalarm.py', 'calliope_mini.py', 'main.py']);
    expect(modules).toEqual([['calliopemini', 'calliope_mini']]);
  });
});

describe('the libraries that are offered', () => {
  it.each([null, ...robotTypes.map(({ id }) => id)])('are those of a run: %s', (robot) => {
    expect(allLibraries(robot)).toEqual(robotLibraries(robot));
    if (robot !== null) expect(robotOwnLibraries(robot)).toEqual(findBuild(robot)?.libraries);
  });
});
