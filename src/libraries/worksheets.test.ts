import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { robotBuilds } from '#robots/builds';
import { putOnFloor } from '#robots/testing/floor';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** The lines with which worksheets for TigerJython set up its simulation, as its present libraries print them. */
const LINES = [
  ['RobotContext.setStartPosition(250, 490)', 'RobotContext.setStartPosition(250,490)'],
  ['RobotContext.setStartDirection(-90)', 'RobotContext.setStartDirection(-90)'],
  ['RobotContext.useBackground("sprites/border.gif")', 'RobotContext.useBackground(sprites/border.gif)'],
  ['RobotContext.useObstacle("sprites/bg.gif", 250, 250)', 'RobotContext.useObstacle(sprites/bg.gif,250,250)'],
  ['RobotContext.enableTrace(True)', 'RobotContext.enableTrace(True)'],
  ['RobotContext.enableRotCenter(True)', 'RobotContext.enableRotCenter(True)'],
  ['setBeamAreaColor("green")', 'setBeamAreaColor(green)'],
  ['eraseBeamArea()', 'eraseBeamArea()'],
] as const;

describe.each([
  ['maqueen-lite', 'mbrobot'],
  ['maqueen-plus-v2', 'mbrobot_plusV2'],
  ['maqueen-plus-v1', 'mbrobot_plus'],
])('a worksheet for the %s', (robot, module) => {
  it(`runs with the lines of TigerJython in it: ${module} prints what they ask for, and the robot drives`, () => {
    const build = robotBuilds.find(({ type }) => type.id === robot)!;
    const { run, chassis } = putOnFloor(build);
    const program = [`from ${module} import *`, ...LINES.map(([line]) => line), 'forward()', 'delay(1000)', 'stop()'];
    const { lines, exception } = run(firmware, program.join('\n'), 2500);
    expect([exception, lines]).toEqual([null, LINES.map(([, printed]) => printed)]);
    expect(chassis.pathMm()).toBeGreaterThan(80);
  });
});
