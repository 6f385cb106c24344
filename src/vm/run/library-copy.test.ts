import { describe, expect, it } from 'vitest';
import { boardTypes } from '#board/boards/index';
import { Clock } from '#core/clock';
import { expectSame, made, type Made, type Texts } from './testing/made-session';

const PROGRAM = `
import mine, music, radio, random, log, os
from microbit import *
seen = []
run_every(lambda: seen.append(running_time()), ms=70)
radio.on()
for n in range(20):
    display.show(n % 10, wait=False)
    music.pitch(200 + n, 20)
    log.add(n=n)
    try:
        [n] * random.randrange(40) + mine.numbers[100]
    except (IndexError, TypeError) as error:
        print(n, type(error), os.listdir())
print(seen)
{}["nothing"]
`;

const files: Texts = { 'main.py': PROGRAM, 'mine.py': 'numbers = [1, 2]\n', 'music.txt': 'x' };
const kinds = boardTypes.flatMap((type) => type.firmwares.map((ofBoard) => ({ type, ofBoard, name: type.id, version: ofBoard.id }))); // prettier-ignore

describe.each(kinds)('a copy of the loaded library of $name $version', ({ type, ofBoard }) => {
  const pair = (given: Texts): readonly [copied: Made, loaded: Made] => {
    made(type, ofBoard, given, false); // of this one the copy is made
    return [made(type, ofBoard, given, false), made(type, ofBoard, given, true)];
  };

  it.each([
    ['main.py alone', { 'main.py': '' }],
    ['no file', {}],
    ["a pupil's own modules, one with a name of the device's", { 'main.py': '', 'music.py': '', 'ä.py': '', data: '' }],
  ])('leaves memory and variables as if it had been loaded: %s', (_, given) => {
    const [copied, loaded] = pair(given);
    expectSame(copied, loaded);
    expect([copied.clock.nowUs, copied.clock.alarms]).toEqual([0, loaded.clock.alarms]);
  });

  it('leads to the same output, time and memory in a program that uses the library', () => {
    const [copied, loaded] = pair(files);
    for (const one of [copied, loaded])
      for (let ms = 100; ms <= 3000; ms += 100) if (one.clock.nowUs < ms * 1000) one.session.run(ms * 1000);
    expect(copied.printed()).toContain('KeyError');
    expect(copied.printed()).toBe(loaded.printed());
    expect(copied.clock.nowUs).toBe(loaded.clock.nowUs);
    expect(copied.board.display.pixels).toEqual(loaded.board.display.pixels);
    expectSame(copied, loaded);
  });

  it('knows the same scopes for a debugger', () => {
    const [copied, loaded] = pair({ 'main.py': '' });
    const scopesIn = ({ session: { inspected } }: Made) =>
      [...inspected.scopes.codes].map((code) => [code, inspected.scopeOf(code)]);
    expect(scopesIn(copied)).not.toEqual([]);
    expect(scopesIn(copied)).toEqual(scopesIn(loaded));
  });

  it('can stand for the loading because that only asks, for things that board and files decide', () => {
    const { calls } = made(type, ofBoard, files, true);
    const asked = [
      'names',
      'board_module',
      'board_has',
      'board_pin',
      'board_text',
      'board_micropython',
      'board_role',
      'pin_modes',
    ];
    const constant = ['image_unpack', 'gesture_names', 'reserve_bytes', 'file_name'];
    const told = ['on_callback', 'image_type', 'booted'];
    expect(calls.length).toBeGreaterThan(100);
    expect(new Set(calls)).toEqual(new Set([...asked, ...constant, ...told]));
  });
});

describe('copies of the loaded library', () => {
  it('are kept for each board and each list of files apart', () => {
    const [microbit, calliope] = boardTypes;
    if (microbit === undefined || calliope === undefined) throw new Error('There are two boards.');
    const all = [
      [microbit, { 'main.py': '' }],
      [calliope, { 'main.py': '' }],
      [microbit, { 'radio.py': '', 'main.py': '' }],
      [microbit, { 'main.py': '', 'radio.py': '' }],
    ] as const;
    for (let round = 0; round < 2; round++)
      for (const [type, given] of all)
        expectSame(made(type, type.firmwares[0], given, false), made(type, type.firmwares[0], given, true));
  });

  it('are the same whatever the clock of the run that they were made of waited for', () => {
    const [type] = boardTypes;
    if (type === undefined) throw new Error('There is no board.');
    const given = { 'main.py': '', 'clock.py': '' };
    const busy = new Clock();
    busy.at(90_000, () => undefined);
    made(type, type.firmwares[0], given, false, busy);
    expectSame(made(type, type.firmwares[0], given, false), made(type, type.firmwares[0], given, true));
  });

  it('are made anew when there were many others', () => {
    const [type] = boardTypes;
    if (type === undefined) throw new Error('There is no board.');
    for (let n = 0; n < 20; n++) made(type, type.firmwares[0], { [`m${n}.py`]: '' }, false);
    for (const n of [0, 19])
      expectSame(
        made(type, type.firmwares[0], { [`m${n}.py`]: '' }, false),
        made(type, type.firmwares[0], { [`m${n}.py`]: '' }, true),
      );
  });
});
