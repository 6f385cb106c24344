import { describe, expect, it } from 'vitest';
import { deviceWith, runProgram, type Device } from '../run/testing/run-program';
import { readPosition } from './frames';
import { watchLines, type StopRule } from './line-watch';
import { afterStep, atBreakPoints, atLine, type Step } from './stops';
import { readVariables } from './variables';

const SECOND = 1_000_000;

/** Goes on until the rule stops the program; `null`: it has ended, or ten seconds are over. */
function goOn({ vm, clock }: Device, rule: StopRule): string | null {
  vm.hold.watch = watchLines(() => vm.inspected, rule);
  vm.resume(clock.nowUs + 10 * SECOND);
  const at = readPosition(vm.inspected);
  return vm.hold.isHeld && at ? `${at.file}:${at.line}` : null;
}

const step = (device: Device, kind: Step): string | null =>
  goOn(device, afterStep(kind, readPosition(device.vm.inspected)));

/** The lines to which one step after the other leads. */
function path(program: string, kind: Step, files: Readonly<Record<string, string>> = {}): string {
  const device = deviceWith(program, { files });
  const lines: string[] = [];
  for (let at = step(device, kind); at !== null && lines.length < 60; at = step(device, kind))
    lines.push(at.replace('main.py:', ''));
  return lines.join(' ');
}

const CALLS = `def double(x):
    y = x * 2
    return y
a = 1
b = double(a) + double(a)
c = 3
`;

describe('stepping', () => {
  it('goes from line to line, into what a line calls, and back into the line', () => {
    expect(path(CALLS, 'into')).toBe('1 4 5 2 3 5 2 3 5 6');
  });

  it('goes over what a line calls', () => {
    expect(path(CALLS, 'over')).toBe('1 4 5 6');
  });

  it('goes out to the line that has called, not to the end of the others', () => {
    const device = deviceWith(CALLS);
    expect(goOn(device, atLine({ file: 'main.py', line: 2 }))).toBe('main.py:2');
    expect(step(device, 'out')).toBe('main.py:5');
    expect(step(device, 'into')).toBe('main.py:2');
    expect(step(device, 'over')).toBe('main.py:3');
    expect(step(device, 'over')).toBe('main.py:5');
    expect(step(device, 'over')).toBe('main.py:6');
    expect(step(device, 'over')).toBeNull();
  });

  it('goes round loops', () => {
    expect(path('i = 0\nwhile i < 2:\n    i += 1\nx = 1', 'over')).toBe('1 2 3 2 3 2 4');
    expect(path('n = 0\nwhile n < 2: n += 1', 'over')).toBe('1 2 2 2');
  });

  it('goes through recursion, generators, handlers and files of the pupil', () => {
    expect(path('def f(n):\n    if n > 0:\n        f(n - 1)\nf(2)', 'over')).toBe('1 4');
    expect(path('def f(n):\n    if n > 0:\n        f(n - 1)\nf(1)', 'into')).toBe('1 4 2 3 2 3 4');
    expect(path('def g():\n    yield 1\n    yield 2\nfor x in g():\n    y = x', 'over')).toBe('1 4 5 4 5 4');
    expect(path('try:\n    1 / 0\nexcept ZeroDivisionError:\n    x = 1\nfinally:\n    y = 2', 'over')).toBe(
      '1 2 4 6', // the bytecode does not tell the line of `except`
    );
    expect(path('import helper\nx = helper.f()', 'into', { 'helper.py': 'def f():\n    return 3' })).toBe(
      '1 helper.py:1 1 2 helper.py:2 2',
    );
  });

  it('does not stop in the library, nor over a line in what is called meanwhile', () => {
    const program =
      'from microbit import *\ndef tick():\n    pass\nrun_every(tick, ms=10)\nsleep(35)\nsleep(35)\ndisplay.show(3)';
    expect(path(program, 'over').startsWith('1 2 4 5 6 7')).toBe(true);
  });

  it('stops each time at a break point, and at the n-th hit of a line', () => {
    const program = 'total = 0\nfor i in range(5):\n    total += i\nprint(total)';
    const device = deviceWith(program);
    const rule = atBreakPoints([{ file: 'main.py', line: 3 }]);
    const seen = [0, 1, 2, 3, 4].map(() => {
      expect(goOn(device, rule)).toBe('main.py:3');
      return readVariables(device.vm.inspected).globals.find(({ name }) => name === 'i')?.value.text;
    });
    expect(seen).toEqual(['0', '1', '2', '3', '4']);
    expect(goOn(device, rule)).toBeNull();
    const other = deviceWith(program);
    expect(goOn(other, atLine({ file: 'main.py', line: 3 }, 4))).toBe('main.py:3');
    expect(readVariables(other.vm.inspected).globals.find(({ name }) => name === 'total')?.value.text).toBe('3');
  });

  it('follows a program over a reset of the board', () => {
    const program =
      "import os, microbit\nif 'seen' in os.listdir():\n    x = 1\nelse:\n    open('seen', 'w').close()\n    microbit.reset()";
    expect(path(program, 'over')).toBe('1 2 5 6 1 2 3');
  });

  const PROGRAMS = {
    recursion: 'def fib(n):\n    return n if n < 2 else fib(n - 1) + fib(n - 2)\nprint([fib(n) for n in range(12)])',
    'generators and garbage':
      'import gc\ndef words(n):\n    for i in range(n):\n        yield str(i) * 9\nd = {}\nfor w in words(400):\n    d[w[0]] = [w]\nprint(sorted(d), gc.mem_free())',
    'errors in finally':
      'def f(n):\n    try:\n        return 1 // n\n    finally:\n        if n == 2:\n            raise KeyError(n)\nfor n in range(4):\n    try:\n        print(f(n))\n    except Exception as e:\n        print(repr(e))',
    'callbacks and music':
      'from microbit import *\nimport music\ncount = 0\ndef tick():\n    global count\n    count += 1\nrun_every(tick, ms=7)\nmusic.play(["c4:1", "e4:1"], wait=False)\nfor i in range(20):\n    sleep(9)\n    display.set_pixel(i % 5, 2, 9)\nprint(count, running_time())',
    'printing and random': 'import random, time\nfor i in range(30):\n    print(random.random(), time.ticks_us())',
  };

  it.each(Object.entries(PROGRAMS))('leaves %s as it is: output, time and free memory', (_, program) => {
    const alone = runProgram(program);
    const outcome = ({ vm, clock, console }: Device) => ({
      console: console(),
      nowUs: clock.nowUs,
      heapFree: vm.heapFree(),
      ended: vm.ended,
    });
    const kinds: readonly Step[] = ['into', 'over', 'into', 'out', 'into'];
    const stepped = deviceWith(program);
    for (let turn = 0; !stepped.vm.ended; turn++) {
      step(stepped, kinds[turn % kinds.length] ?? 'into');
      readVariables(stepped.vm.inspected);
    }
    const watched = deviceWith(program);
    while (!watched.vm.ended) goOn(watched, () => false);
    expect(outcome(stepped)).toEqual(alone);
    expect(outcome(watched)).toEqual(alone);
  });
});
