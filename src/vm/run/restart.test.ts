import { describe, expect, it } from 'vitest';
import { createHalBench } from './testing/hal-bench';
import { deviceWith, runProgram } from './testing/run-program';

const SECOND = 1_000_000;

/** Prepended to programs: `first` is true before the reset, false after it. */
const ONCE = `
from microbit import *
import machine, music, os
first = 'seen' not in os.listdir()
if first:
    with open('seen', 'w') as file:
        file.write('x')
`;

describe('a reset', () => {
  it.each(['reset()', 'machine.reset()'])('by %s starts the clock of the board again at 0', (call) => {
    const { console, nowUs } = runProgram(`${ONCE}
if first:
    sleep(3000)
    ${call}
print(running_time() < 20, nowhere if first else 'again')`);
    expect(console).toBe('True again\n');
    expect(nowUs).toBeGreaterThan(3_500_000); // half a second for starting anew
  });

  it('ends timers, music, display and pins of the time before', () => {
    const { console, board } = (() => {
      const device = deviceWith(`${ONCE}
if first:
    run_every(lambda: print('tick'), ms=50)
    music.pitch(440, wait=False)
    display.show(Image.HEART)
    pin1.write_digital(1)
    i2c.init(freq=400000)
    reset()
sleep(500)
print('end')`);
      device.vm.resume(5 * SECOND);
      return device;
    })();
    expect(console()).toBe('end\n');
    expect(board.music.frequencyHz).toBeNull();
    expect(board.display.pixels.every((level) => level === 0)).toBe(true);
    expect(board.pin('pin1').wire.level).toBe(0);
    expect(board.i2c.frequencyHz).toBe(100_000);
  });

  it('forgets what was typed and not read', () => {
    const { vm, console } = deviceWith(`${ONCE}
if first:
    sleep(100)
    reset()
print(uart.any())`);
    vm.resume(1000);
    vm.feed('x');
    vm.resume(5 * SECOND);
    expect(console()).toBe('False\n');
  });

  it('keeps the finger on the button', () => {
    const { vm, board, console } = deviceWith(`${ONCE}
sleep(100)
if first:
    reset()
print(button_a.is_pressed())`);
    board.sensors.set('buttonA', 1);
    vm.resume(5 * SECOND);
    expect(console()).toBe('True\n');
  });
});

describe('a panic', () => {
  const SAD = '0000001010000000111010001';
  const lit = (board: { display: { pixels: Uint8Array } }): string =>
    Array.from(board.display.pixels, (level) => (level ? '1' : '0')).join('');

  it('shows the sad face and three digits for ever, and nothing else answers', () => {
    const { vm, board, clock, console } = deviceWith('from microbit import panic\npanic(7)');
    vm.resume(SECOND);
    expect(vm.ended?.kind).toBe('panic');
    const seen: string[] = [];
    for (let ms = 300; ms < 3000; ms += 660) {
      vm.resume(ms * 1000);
      seen.push(lit(board));
    }
    expect(seen[0]).toBe(SAD);
    expect(seen[4]).toBe(SAD);
    expect(seen[1]).toBe(seen[2]); // the zeros of 007
    expect(seen[3]).not.toBe(seen[2]);
    vm.feed('\r\x03\x04');
    vm.resume(clock.nowUs + SECOND);
    expect(console()).toBe('');
  });

  it('lets time pass afterwards', () => {
    const { vm, clock } = deviceWith('from microbit import panic\npanic()');
    vm.resume(SECOND);
    vm.resume(2 * SECOND);
    expect(clock.nowUs).toBe(2 * SECOND);
  });
});

describe('the end by a callback', () => {
  it('is silent when the callback leaves with sys.exit()', () => {
    const { console, ended } = runProgram(
      'from microbit import *\nimport sys\nrun_every(sys.exit, ms=50)\nwhile True: sleep(10)',
    );
    expect(console).toBe('');
    expect(ended?.kind).toBe('finished');
  });

  it('is an internal error when our own clockwork breaks, and the world goes on', () => {
    const { vm, clock } = deviceWith('while True: pass');
    let rung = 0;
    clock.every(1000, () => {
      if (++rung === 5) throw new Error('a bug of ours');
    });
    vm.resume(SECOND);
    expect(vm.ended).toMatchObject({ kind: 'fault', exception: { type: 'InternalError' } });
    vm.resume(SECOND);
    expect([rung, clock.nowUs]).toEqual([1000, SECOND]);
  });
});

describe('a long transfer', () => {
  it('takes 8.3 s for 8000 bytes at 9600 baud, and can be suspended on the way', () => {
    const { vm, clock, console } = deviceWith(
      "from microbit import *\nuart.init(9600)\nt = running_time()\nuart.write('x' * 8000)\nt = running_time() - t\nuart.init(115200)\nprint(t // 10)",
    );
    vm.resume(SECOND);
    expect(clock.nowUs).toBe(SECOND);
    vm.resume(20 * SECOND);
    expect(console().slice(-4)).toBe('833\n');
  });

  it('takes its time for a long print, and can be suspended on the way', () => {
    const { vm, clock } = deviceWith("print('x' * 20000)\nwhile True: pass");
    vm.resume(SECOND);
    expect(clock.nowUs).toBe(SECOND);
  });
});

describe('files left open', () => {
  it('cost nothing but memory, as on the device: 2000 times open()', () => {
    const { console } = runProgram("for i in range(2000):\n    f = open('main.py')\nprint(len(f.readline()))", {
      forUs: 60 * SECOND,
    });
    expect(console).toBe('22\n');
  });
});

describe('more files than the board has room for', () => {
  it('run, since drivers may be long; who then writes a file learns why it fails', () => {
    const { console } = runProgram("import long\nprint('runs')\nopen('a', 'w')", {
      files: { 'long.py': `x = 1\n${'# a comment\n'.repeat(2500)}` },
    });
    expect(console).toContain('runs\n');
    expect(console).toContain('OSError: [Errno 28] ENOSPC\n');
    expect(console).toContain('The files need 30.2 kB on the board, which has 24.2 kB.');
  });
});

describe('a file with bytecode', () => {
  it('cannot be imported, as on the board, whose firmware loads none', () => {
    const program = 'with open("x.mpy", "wb") as file:\n    file.write(b"M\\x06\\x00\\x1f")\nimport x';
    expect(runProgram(program).ended?.exception).toMatchObject({ type: 'ImportError', message: "no module named 'x'" });
  });
});

describe('an error after an unfinished line', () => {
  it('stands on that line: the firmware prints it as it is (codal_port/main.c, microbit_pyexec_file)', () => {
    expect(runProgram('print("abc", end="")\n1 / 0').console).toContain('abcTraceback (most recent call last):');
  });
});

describe('the way to the board', () => {
  it.each([
    ['from microbit import _h', 'ImportError'],
    ['import microbit\nmicrobit._h', 'AttributeError'],
    ['import micropython\nmicropython._hal', 'AttributeError'],
    ['import sys\nsys._hal', 'AttributeError'],
    ['import radio\nradio._addressof', 'AttributeError'],
    ['import music\nmusic.__dict__', 'AttributeError'],
    ['import microbit\ntype(microbit.display).scroll.__globals__', 'AttributeError'],
    ['import microbit\nmicrobit.display.scroll.__globals__', 'AttributeError'],
    ['import microbit\nmicrobit.sleep.__globals__', 'AttributeError'],
    ["import sys\nsys.modules['_display']", 'KeyError'],
    ["import sys\nsys.modules['_import']", 'KeyError'],
    ['__import__("_hal")', 'ImportError'],
    ['import uctypes', 'ImportError'],
  ])('is not in reach of a program: %j', (program, type) => {
    expect(runProgram(program).ended?.exception?.type).toBe(type);
  });

  it('is not in what dir() lists of the device’s modules, classes and objects', () => {
    const program = 'import microbit, music, micropython, radio\nfor thing in (microbit, music, micropython, radio, microbit.display, microbit.Image, microbit.Image(), microbit.display.show):\n    print([n for n in dir(thing) if n[0] == "_"])'; // prettier-ignore
    expect(new Set(runProgram(program).console.trim().split('\n'))).toEqual(
      new Set(["['__class__', '__name__']", "['__class__']"]),
    );
  });

  it('is not in what help() says of them', () => {
    expect(runProgram('from microbit import *\nhelp(button_a)').console).toBe(
      [
        'object <MicroBitButton> is of type MicroBitButton',
        ...['  was_pressed -- <function>', '  get_presses -- <function>', '  is_pressed -- <function>', ''],
      ].join('\n'),
    );
  });

  it('leaves a program its own names: with an underscore in its modules, and the table of its names', () => {
    const files = { 'mine.py': '_x = 7\ndef f():\n    pass\n' };
    const { console } = runProgram(
      'import mine\nprint(mine._x, mine.__dict__["_x"], mine.f.__globals__ is mine.__dict__)',
      { files },
    );
    expect(console).toBe('7 7 True\n');
  });

  it.each(['_boot', '_sim', '_repl', '_hal', '_host', '_gc'])('has no module %s for programs', (name) => {
    expect(runProgram(`import ${name}`).ended?.exception?.type).toBe('ImportError');
  });

  it('takes no name that only JavaScript’s objects have', () => {
    const program = 'import audio\nfrom microbit import Sound\naudio.play(type(Sound.GIGGLE)("constructor"))\n';
    expect(runProgram(program).console).not.toContain('Internal error');
    const hal = createHalBench();
    expect(hal.interrupted(1000, 'board_role', 'constructor')).toBe(-1);
    expect(hal.interrupted(1000, 'board_text', 'constructor')).toBe('');
    expect(hal.interrupted(1000, 'pin_read', 'map')).toBe(hal.interrupted(1000, 'pin_read', 999));
  });

  it('comes back from every function, whatever it is given; at worst the run ends with an error', () => {
    const hal = createHalBench();
    const nonsense = [null, true, -1, 2 ** 29, -(2 ** 29), 1e300, 'x', '', NaN, Infinity];
    // A recording at an absurd rate takes its time to be put together.
    for (const name of hal.names.filter((each) => !each.startsWith('mic_')))
      for (const value of nonsense) {
        const call = (): unknown => hal.interrupted(1000, name, value, value, value, value);
        try {
          call();
        } catch (error) {
          expect(error).toBeInstanceOf(Error);
        }
      }
    expect(hal.names.length).toBeGreaterThan(60);
  });
});
