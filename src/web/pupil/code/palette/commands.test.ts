import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { boardTypes } from '#board/boards/index';
import { freeReference } from '#libraries/reference';
import { robotReferences } from '#robots/references';
import { robotTypes } from '#robots/index';
import { defaultScene } from '#scene/scene';
import type { Hardware } from '#simulation/hardware';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { LANGUAGES } from '../../../kit/i18n/texts';
import { loadWords } from '../help/words-on';
import { contextOf, type Written } from '../../../session/work/hardware/written-for';
import { aboutIn } from './about';
import { bringNames } from './bring-names';
import { codeShown, commandsFor, type PaletteCommand } from './commands';
import paletteWords from './words';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** Each robot on its board, and each board alone. */
const devices = [...robotTypes, null].flatMap((robot) =>
  boardTypes
    .filter(({ id }) => robot === null || id === robot.board)
    .map((board) => {
      const hardware = { board, firmware: board.firmwares[0], robot, options: {} } as Hardware;
      return { name: robot?.id ?? board.id, hardware, written: { hardware, files: [], file: 'main.py' } };
    }),
);

const commandsOf = ({ hardware }: Written): readonly PaletteCommand[] =>
  commandsFor(hardware?.robot?.id ?? null).flatMap(({ commands }) => commands);

/** A program that uses a command, with what the pupil would have written before. */
function programOf(command: PaletteCommand, written: Written): string {
  const { code, imports } = bringNames(command, '', written);
  const lines = codeShown(code).replaceAll('…', 'pass').split('\n');
  return [...imports, 'number = 6', 'for round in range(2):', ...lines.map((line) => `    ${line}`), 'print("end")'].join('\n'); // prettier-ignore
}

describe.each(devices)('the palette for $name', ({ hardware, written }) => {
  it.each(commandsOf(written).map((command) => [command.id, command] as const))(
    'has %s, which runs',
    async (_, command) => {
      const setup = {
        scene: defaultScene(),
        files: { 'main.py': programOf(command, written) },
        robot: hardware.robot?.id ?? 'none',
        board: hardware.board.id,
        seed: 1,
        reality: 0,
        keepTrace: false,
      };
      const simulation = await Simulation.create(soloRun(setup), firmware);
      simulation.advanceTo(300_000);
      expect(simulation.ended?.exception ?? null).toBeNull();
    },
  );

  it('has no command whose names the board and the robot do not have', () => {
    for (const command of commandsOf(written)) {
      const { imports } = bringNames(command, '', written);
      // Every name comes from somewhere: of a module that is imported for it.
      if (command.needs.length > 0) expect(imports, command.id).not.toEqual([]);
    }
  });

  it('has words of the reference, or its own, on every command, in every language', async () => {
    for (const language of LANGUAGES) {
      const words = await loadWords(language, [...robotReferences, freeReference]);
      for (const command of commandsOf(written)) {
        const { imports } = bringNames(command, '', written);
        const own = (paletteWords.about as Partial<Record<string, Record<string, string>>>)[command.id];
        const about = own?.[language] ?? aboutIn(command, imports, contextOf(written), words);
        expect(about, `${command.id}, ${language}`).not.toBe('');
        expect(own === undefined, command.id).toBe(command.said !== null);
      }
    }
  });
});

describe('the palette of a robot', () => {
  const idsFor = (robot: string, group: string): readonly string[] =>
    commandsFor(robot)
      .find(({ id }) => id === group)
      ?.commands.map(({ id }) => id) ?? [];

  it.each(robotTypes)('has the ways to drive of the $name', ({ id }) => {
    expect(idsFor(id, 'drive').length).toBeGreaterThanOrEqual(5);
  });

  it.each([
    ['maqueen-lite', ['distance', 'near', 'leftDark', 'rightDark', 'shaken']],
    ['maqueen-plus-v2', ['distance', 'near', 'leftDark', 'rightDark', 'middleDark', 'shaken']],
    ['callibot', ['distance', 'near', 'leftDark', 'rightDark', 'bumper', 'shaken']],
  ])('has for the %s only the sensors of its library', (robot, sensors) => {
    expect(idsFor(robot, 'sensors')).toEqual(sensors);
  });

  it.each([
    ['maqueen-lite', ['fillRGB', 'clearRGB', 'beep', 'setAlarm', 'melody']],
    ['maqueen-plus-v1', ['beep', 'setAlarm', 'melody']],
    ['callibot', ['setAlarm', 'melody']],
    ['motionkit-2', ['fillRGB', 'melody']],
  ])('has for the %s, beside its lamps, only the lights and sounds of its library', (robot, lights) => {
    expect(idsFor(robot, 'light')).toEqual(['setLED', 'setLEDLeft', 'setLEDRight', ...lights]);
  });

  it.each([
    ['motionkit-2', ['if irLeftValue() == 0:\n    …', 'rgbLED(255, 0, 0)']],
    ['cutebot', ['if has_left_track():\n    …', 'distance = get_sonar_distance()', 'set_motors_speed(50, 30)']],
    [
      'bitbot-xl',
      ['if getLine(0) == 1:\n    …', 'fill(255, 0, 0)', 'sleep(500)', 'while getDistance() > 20:\n    sleep(20)'],
    ],
  ])('writes a command with the names that the library of the %s has', (robot, expected) => {
    const codes = commandsFor(robot).flatMap(({ commands }) => commands.map(({ code }) => codeShown(code)));
    expect(codes).toEqual(expect.arrayContaining(expected));
  });
});

describe('the palette, for libraries with other names, or whose left() turns to the right', () => {
  it.each([
    ['maqueen-lite', 'left()'],
    ['bitbot-xl', 'right()'],
    ['cutebot', 'turn_left()'],
  ])('turns %s to the left with %s', (robot, code) => {
    const commands = commandsFor(robot).flatMap((group) => group.commands);
    expect(commands.find(({ id }) => id === 'left')?.code).toBe(code);
  });
});

describe('a command as the palette shows it', () => {
  it('has its values, and … where other lines belong', () => {
    expect(codeShown('fillRGB(${1:255}, ${2:0}, ${3:0})')).toBe('fillRGB(255, 0, 0)');
    expect(codeShown('while True:\n\t${}')).toBe('while True:\n    …');
  });
});
