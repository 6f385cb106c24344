import { describe, expect, it } from 'vitest';
import { deviceWith, runProgram } from './testing/run-program';

const SECOND = 1_000_000;

describe('a program on the micro:bit', () => {
  it('prints, and ends as finished', () => {
    expect(runProgram('print(6 * 7)')).toMatchObject({ console: '42\n', ended: { kind: 'finished' } });
  });

  it('takes 442 ms for the loop that was measured on a real board, within 5 %', () => {
    const { console } = runProgram(`
import utime
def loop():
    number = 1.0
    before = utime.ticks_us()
    for _ in range(13700):
        number = number * 1.001 - 1.001
    print(utime.ticks_us() - before)
loop()`);
    expect(Math.abs(Number(console) / 1000 - 442)).toBeLessThan(442 * 0.05);
  });

  it('runs main.py as __main__ and reads no clock but the simulated one', () => {
    const { console } = runProgram(
      'import time\nearly = time.ticks_us() < 1000\ntime.sleep(2)\nprint(__name__, early, time.ticks_ms())',
    );
    expect(console).toBe('__main__ True 2000\n');
  });

  it('starts at simulated time 0: loading the library costs nothing', () => {
    expect(deviceWith('pass').clock.nowUs).toBe(0);
  });

  it('takes as long to print as the serial line needs: 86.8 µs a character at 115200 baud', () => {
    const { nowUs } = runProgram('print("x" * 999)');
    expect(nowUs).toBeGreaterThan(86_800);
    expect(nowUs).toBeLessThan(87_500);
  });

  it('runs what micropython.schedule queued at the next jump', () => {
    const { console } = runProgram(`
import micropython
done = []
micropython.schedule(done.append, 7)
while not done: pass
print(done)`);
    expect(console).toBe('[7]\n');
  });

  it('lets two boards run side by side without knowing of each other', () => {
    const one = deviceWith('a = 1\nwhile a < 5000: a += 1\nprint("one", a)');
    const two = deviceWith('try: print(a)\nexcept NameError: print("two")');
    one.vm.resume(10_000);
    two.vm.resume(10_000);
    one.vm.resume(SECOND);
    expect([one.console(), two.console()]).toEqual(['one 5000\n', 'two\n']);
  });

  it('draws the same random numbers for the same seed, others for another', () => {
    const program = 'import random\nprint([random.randint(0, 1000000) for _ in range(5)])';
    const [first, again, other] = [1, 1, 2].map((seed) => runProgram(program, { seed }).console);
    expect(again).toBe(first);
    expect(other).not.toBe(first);
  });
});

describe('the end of a program', () => {
  it('names file and line of an error, innermost call last', () => {
    const { ended, console } = runProgram('import helper\n\nhelper.half("x")', {
      files: { 'helper.py': 'def half(x):\n    return x / 2\n' },
    });
    expect(console).toBe(
      'Traceback (most recent call last):\n  File "main.py", line 3, in <module>\n  File "helper.py", line 2, in half\n' +
        "TypeError: can't convert 'int' object to str implicitly\n",
    );
    expect(ended).toMatchObject({ kind: 'exception', exception: { type: 'TypeError', line: 2 } });
  });

  it('shows no frame of the library: the error seems to arise in the call', () => {
    const { console, ended } = runProgram('from microbit import *\n\npin0.write_digital(7)');
    expect(console).toBe(
      'Traceback (most recent call last):\n  File "main.py", line 3, in <module>\nValueError: value must be 0 or 1\n',
    );
    expect(ended?.exception?.line).toBe(3);
  });

  it('hides them in sys.print_exception too', () => {
    const { console } = runProgram(`
import sys
from microbit import pin0
try:
    pin0.write_digital(7)
except ValueError as error:
    sys.print_exception(error)`);
    expect(console).not.toContain('/lib/');
    expect(console).toContain('File "main.py", line 5, in <module>');
  });

  it('imports a file that the program has written', () => {
    const { console } = runProgram("with open('two.py', 'w') as f:\n    f.write('x = 2')\nimport two\nprint(two.x)");
    expect(console).toBe('2\n');
  });

  it('shows the frames of a robot library, as on the device', () => {
    const { console } = runProgram('import robot\nrobot.go()', {
      libraries: { 'robot.py': 'def go():\n    raise OSError(19)\n' },
    });
    expect(console).toContain('File "robot.py", line 2, in go');
    expect(console).toContain('OSError: [Errno 19] ENODEV');
  });

  it('tells the line of a syntax error', () => {
    const { ended } = runProgram('print("a")\nx = 3 4\nprint("b")\n');
    expect(ended?.exception).toMatchObject({ type: 'SyntaxError', message: 'invalid syntax', line: 2 });
  });

  it('shows a sad face for a second on the display, then scrolls line, name and message', () => {
    const { vm, clock, board } = deviceWith('x');
    const lit = () => board.display.pixels.filter((level) => level > 0).length;
    vm.resume(SECOND);
    const endUs = clock.nowUs;
    clock.advanceTo(endUs + SECOND - 10_000);
    expect(lit()).toBe(7);
    clock.advanceTo(endUs + 2 * SECOND);
    expect(board.display.isAnimating).toBe(true);
    clock.advanceTo(endUs + 40 * SECOND);
    expect([board.display.isAnimating, lit()]).toEqual([false, 0]);
  });

  it('is silent for SystemExit', () => {
    expect(runProgram('import sys\nprint(1)\nsys.exit()\nprint(2)')).toMatchObject({
      console: '1\n',
      ended: { kind: 'finished' },
    });
  });

  it('is "panic" after panic(), and nothing runs after it', () => {
    const { console, ended } = runProgram(
      'import microbit\nprint(1)\ntry:\n    microbit.panic(42)\nexcept BaseException:\n    pass\nprint(2)',
    );
    expect(console).toBe('1\n');
    expect(ended?.kind).toBe('panic');
  });

  it('begins anew after reset(), with the files that the program wrote', () => {
    const { console, ended } = runProgram(`
import microbit, os
if 'seen' in os.listdir():
    print('again')
else:
    with open('seen', 'w') as file:
        file.write('x')
    microbit.reset()`);
    expect(console).toBe('again\n');
    expect(ended?.kind).toBe('finished');
  });
});

describe('stopping a program', () => {
  const stopAfter = (program: string, us: number) => {
    const device = deviceWith(program);
    device.vm.resume(us);
    device.vm.interrupt();
    device.vm.resume(us + SECOND);
    return device;
  };

  it('raises KeyboardInterrupt in a loop that does nothing', () => {
    const { vm, console } = stopAfter('while True:\n    pass', SECOND);
    expect(vm.ended?.kind).toBe('stopped');
    expect(console()).toContain('KeyboardInterrupt');
  });

  it('raises it while the program sleeps', () => {
    expect(stopAfter('import microbit\nmicrobit.sleep(100000)', SECOND).vm.ended?.kind).toBe('stopped');
  });

  it('lets the program clean up', () => {
    expect(stopAfter('try:\n    while True: pass\nfinally:\n    print("bye")', SECOND).console()).toContain('bye');
  });

  it('waits for callbacks that sleep, then stops the program', () => {
    const { vm } = stopAfter(
      'from microbit import *\ndef f(): sleep(1500)\nrun_every(f, ms=50)\nwhile True: pass',
      SECOND / 2,
    );
    vm.resume(15 * SECOND); // the calls that wait in the scheduler's queue run first, 1.5 s each
    expect(vm.ended?.kind).toBe('stopped');
  });

  it('leaves a program suspended that catches everything: whoever runs it can drop it', () => {
    const { vm, clock } = stopAfter(
      'while True:\n    try:\n        while True: pass\n    except:\n        pass',
      SECOND,
    );
    expect(vm.ended).toBeNull();
    expect(clock.nowUs).toBe(2 * SECOND);
  });

  it('comes back from endless printing after the time asked for', () => {
    const { vm, clock } = deviceWith('while True:\n    print(1)');
    vm.resume(SECOND);
    expect(clock.nowUs).toBeGreaterThanOrEqual(SECOND);
    expect(clock.nowUs).toBeLessThan(SECOND + 1000);
  });
});

describe('what a program can reach', () => {
  it.each(['js', 'jsffi', 'vfs', 'asyncio', '_hal', '_host'])('finds no module %s', (name) => {
    expect(runProgram(`import ${name}`).ended?.exception?.type).toBe('ImportError');
  });

  it('finds nothing of the host behind what the library uses', () => {
    const { ended } = runProgram('import microbit\nprint(microbit._h.constructor)');
    expect(ended?.exception?.type).toBe('AttributeError');
  });

  it.each(['_h.throw(5)', '_h.i2c_read(16, 1 << 30, 99)', '_h.on_callback(1)', '_h.pin_write()'])(
    'ends at worst itself when it misuses the way to the board: %s',
    (call) => {
      const { ended } = runProgram(`from microbit import _h\n${call}\nwhile True: pass`, { forUs: SECOND });
      expect(ended?.kind ?? 'running').toMatch(/fault|exception|running/);
    },
  );

  it('cannot open a path outside its own files', () => {
    expect(runProgram('open("/etc/passwd")').ended?.exception?.type).toBe('OSError');
  });
});
