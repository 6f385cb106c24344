import { readdirSync } from 'node:fs';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { Board } from '#board/board';
import { boardTypes, findBoard } from '#board/boards/index';
import { Clock } from '#core/clock';
import { LANGUAGES, type Texts } from '#core/languages';
import { addedTo } from '#core/stop';
import { NecRemote } from '#devices/nec-remote';
import type { World } from '#world/world';
import { robotBuilds } from './builds';
import { fetchDrawing } from './drawings';
import { findRobot, robotTypes } from './index';
import { robotSheets } from './sheets';
import { putOnFloor } from './testing/floor';

const LONGEST_FILE_NAME = 120; // the board's file system
/** After this time every chip answers at its address. */
const CHIPS_START_MS = 3000;
const LARGEST_DRAWING_BYTES = 24_000; // about 6 kB compressed: drawings are part of the page before Run

/** Every language is there, without a German letter that Switzerland does not use. */
function expectTexts(texts: Texts): void {
  for (const language of LANGUAGES) expect(texts[language], language).toMatch(/\S/);
  expect(texts.de).not.toContain('ß');
}

/** Readings with a pull-up and with a pull-down on each wire: where both are right, nothing drives. */
function levels(board: Board): Record<string, readonly number[]> {
  const seen = ([name, wire]: readonly [string, ReturnType<Board['wire']>]) => {
    const reader = wire.connect('reader');
    const both = (['up', 'down'] as const).map((pull) => {
      reader.pull(pull);
      return wire.level;
    });
    reader.detach();
    return [name, both] as const;
  };
  return Object.fromEntries([...board.wires].map(seen));
}

describe('the list of robots', () => {
  it('has every folder in src/robots, once', () => {
    const folders = readdirSync('src/robots', { withFileTypes: true })
      .filter((entry) => entry.isDirectory() && !['testing', 'words'].includes(entry.name))
      .map(({ name }) => name)
      .sort();
    expect(robotTypes.map(({ id }) => id).sort()).toEqual(folders);
    expect(robotBuilds.map(({ type }) => type.id).sort()).toEqual(folders);
    expect(robotSheets.map(({ robot }) => robot).sort()).toEqual(folders);
  });

  it('offers them by their places, each of which is taken once', () => {
    const places = robotTypes.map(({ place }) => place);
    expect(places).toEqual([...new Set(places)].sort((a, b) => a - b));
  });

  it('finds a robot by its id and gives null for a stranger', () => {
    for (const type of robotTypes) expect(findRobot(type.id)).toBe(type);
    expect(findRobot('toaster')).toBeNull();
  });
});

describe.each(robotTypes.map((type) => [type.name, type] as const))('%s, its body', (_, type) => {
  it('plugs into a board that exists', () => {
    expect(boardTypes.map((board) => board.id)).toContain(type.board);
  });

  it('has an outline of convex parts with 3 to 12 corners, counter-clockwise', () => {
    expect(type.body.outlineMm.length).toBeGreaterThan(0);
    for (const part of type.body.outlineMm) {
      expect(part.length).toBeGreaterThanOrEqual(3);
      expect(part.length).toBeLessThanOrEqual(12);
      for (let i = 0; i < part.length; i++) {
        const [a, b, c] = [part[i]!, part[(i + 1) % part.length]!, part[(i + 2) % part.length]!];
        expect((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)).toBeGreaterThan(0);
      }
    }
  });

  it('is as wide to the left as to the right, with its axle through the origin', () => {
    const ys = type.body.outlineMm.flat().map((corner) => corner.y);
    expect(Math.max(...ys)).toBe(-Math.min(...ys));
    const [left, right] = type.body.wheels;
    expect([left.atMm.x, right.atMm.x]).toEqual([0, 0]);
    expect(left.atMm.y).toBe(-right.atMm.y);
    expect(left.atMm.y).toBeGreaterThan(0);
  });

  it('has a centre of mass inside its outline and a mass of 50 g to 1 kg', () => {
    const xs = type.body.outlineMm.flat().map((corner) => corner.x);
    expect(type.body.centreOfMassMm.x).toBeGreaterThan(Math.min(...xs));
    expect(type.body.centreOfMassMm.x).toBeLessThan(Math.max(...xs));
    expect(type.body.massG).toBeGreaterThan(50);
    expect(type.body.massG).toBeLessThan(1000);
  });

  it('has options with titles in every language and at least two choices, every id once', () => {
    expect(new Set(type.options.map(({ id }) => id)).size).toBe(type.options.length);
    for (const { id, title, about, onlyWith, choices } of type.options) {
      const other = type.options.find((option) => option.id === onlyWith?.option);
      for (const choice of onlyWith?.choices ?? []) expect(other?.choices.map((one) => one.id)).toContain(choice);
      expect(id).toMatch(/^\w[\w-]*$/);
      expectTexts(title);
      if (about) expectTexts(about);
      expect(choices.length, id).toBeGreaterThanOrEqual(2);
      expect(new Set(choices.map((choice) => choice.id)).size).toBe(choices.length);
      for (const choice of choices) expectTexts(choice.title);
    }
  });
});

describe.each(robotTypes.map((type) => [type.name, type] as const))('%s, its drawing', (_, { id, body }) => {
  let drawing = '';
  beforeAll(async () => {
    drawing = await fetchDrawing(id);
  });

  it('is in millimetres, around the whole body, and its wheels carry names', () => {
    expect(drawing).toContain('<svg xmlns="http://www.w3.org/2000/svg"');
    for (const id of ['body', 'wheel-left', 'wheel-right']) expect(drawing).toContain(`id="${id}"`);
    const [x, y, width, height] = /viewBox="([^"]+)"/.exec(drawing)?.[1]?.split(' ').map(Number) ?? [];
    for (const corner of body.outlineMm.flat()) {
      expect(-corner.y).toBeGreaterThanOrEqual(x!);
      expect(-corner.y).toBeLessThanOrEqual(x! + width!);
      expect(-corner.x).toBeGreaterThanOrEqual(y!);
      expect(-corner.x).toBeLessThanOrEqual(y! + height!);
    }
  });

  it('needs nothing from outside and stays small', () => {
    expect(drawing).not.toMatch(/<(image|script|foreignObject|text)\b|href="(?!#)|url\((?!#)/);
    expect(drawing.length).toBeLessThan(LARGEST_DRAWING_BYTES);
  });

  it('gives every id to one element only', () => {
    const ids = [...drawing.matchAll(/ id="([^"]+)"/g)].map((match) => match[1]);
    expect(ids).toEqual([...new Set(ids)]);
  });
});

describe.each(robotBuilds.map((build) => [build.type.name, build] as const))('%s, its libraries', (_, build) => {
  it('can run on the real robot: no f-strings, no tabs, only the device’s modules and its own', () => {
    const board = findBoard(build.type.board);
    const own = Object.keys(build.libraries).map((file) => file.replace('.py', ''));
    const known = ['machine', 'neopixel', 'music', 'utime', 'gc', ...(board?.modules ?? []), ...own];
    for (const [file, source] of Object.entries(build.libraries)) {
      expect(file).toMatch(/^[a-z]\w*\.py$/i);
      expect(source).not.toMatch(/\bf["']|\t/);
      const imported = [...source.matchAll(/^\s*(?:from|import) (\w+)/gm)].map((match) => match[1]);
      expect(known).toEqual(expect.arrayContaining(imported));
    }
  });

  it('contain every module that hints at this robot', () => {
    expect(build.type.modules.length).toBeGreaterThan(0);
    for (const module of build.type.modules) expect(Object.keys(build.libraries)).toContain(`${module}.py`);
  });
});

describe.each(robotBuilds.map((build) => [build.type.name, build] as const))('%s on a board', (_, build) => {
  it('tells its state as plain data, and its drawing has a place for each thing in it', async () => {
    const state = putOnFloor(build).robot.state();
    expect(structuredClone(state)).toEqual(state);
    const drawing = await fetchDrawing(build.type.id);
    for (const { name } of state.lineSensors) expect(drawing).toContain(`id="line-${name}"`);
    for (let i = 0; i < state.rgb.length; i++) expect(drawing).toContain(`id="rgb-${i}"`);
    for (const side of ['left', 'right'].slice(0, state.lamps.length)) expect(drawing).toContain(`id="lamp-${side}"`);
  });

  it('stands still and shines nowhere before a program says so', () => {
    const { robot, chassis, passMs } = putOnFloor(build);
    passMs(500);
    const { leds, rgb, lamps, duty } = robot.state();
    expect([leds, duty, chassis.pathMm()]).toEqual([{ left: 0, right: 0 }, { left: 0, right: 0 }, 0]);
    for (const color of [...rgb, ...lamps]) expect(color).toEqual([0, 0, 0]);
  });

  it.each(build.type.options.flatMap(({ id, choices }) => choices.map((choice) => [id, choice.id] as const)))(
    'works with the option %s = %s',
    (id, choice) => {
      const { robot, passMs } = putOnFloor(build, { options: { [id]: choice } });
      passMs(100);
      expect(structuredClone(robot.state())).toEqual(robot.state());
      robot.detach();
    },
  );

  it('hears no change of the floor any more when it is taken away', () => {
    const heard = new Set<object>();
    const prepare = (world: World): void => {
      vi.spyOn(world, 'beforePaint').mockImplementation((act) => addedTo(heard, act));
    };
    const { robot, passMs } = putOnFloor(build, { prepare });
    passMs(100);
    robot.detach();
    expect(heard.size).toBe(0);
  });

  it('says rightly whether it hears a remote control', () => {
    const listen = vi.spyOn(NecRemote.prototype, 'onBurst');
    putOnFloor(build).robot.detach();
    expect(listen.mock.calls.length > 0).toBe(build.type.hearsRemote !== false);
    listen.mockRestore();
  });

  it('leaves wires and bus as it found them', () => {
    const { board, clock, robot, passMs } = putOnFloor(build);
    passMs(CHIPS_START_MS);
    robot.detach();
    const bare = new Board(board.type, new Clock());
    bare.clock.advanceTo(clock.nowUs);
    expect(levels(board)).toEqual(levels(bare));
    expect([...Array(128).keys()].filter((address) => board.i2c.answers(address))).toEqual([]);
  });
});

describe.each(robotSheets.map((sheet) => [findRobot(sheet.robot)!.name, sheet] as const))(
  '%s, its sheet',
  (_, sheet) => {
    const build = robotBuilds.find(({ type }) => type.id === sheet.robot)!;

    it('says what the robot is, what is plugged where and what answers on the bus', () => {
      expectTexts(sheet.about);
      expect(sheet.wiring.length).toBeGreaterThan(0);
      for (const { part, at, note } of sheet.wiring) {
        expectTexts(part);
        expect(at).not.toBe('');
        if (note) expectTexts(note);
      }
      for (const { title, rows } of sheet.registers) {
        expectTexts(title);
        expect(rows.length).toBeGreaterThan(0);
        for (const { meaning } of rows) expectTexts(meaning);
      }
    });

    it('has a register table for each address that answers on the bus, and for no other', () => {
      const { board, passMs } = putOnFloor(build);
      passMs(CHIPS_START_MS);
      const answering = [...Array(128).keys()].filter((address) => board.i2c.answers(address));
      const shown = sheet.registers.flatMap(({ address, lastAddress = address }) =>
        Array.from({ length: lastAddress - address + 1 }, (_, i) => address + i),
      );
      expect(shown.sort((a, b) => a - b)).toEqual(answering);
    });

    it('has examples with a title and a program in every language, each file once', () => {
      expect(sheet.examples.length).toBeGreaterThan(0);
      for (const { file, title, source } of sheet.examples) {
        expect(file).toMatch(/\.py$/);
        expect(file.length).toBeLessThanOrEqual(LONGEST_FILE_NAME);
        expectTexts(title);
        expectTexts(source);
      }
      const files = sheet.examples.map(({ file }) => file);
      expect(files).toEqual([...new Set(files)]);
    });
  },
);
