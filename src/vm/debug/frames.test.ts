import { describe, expect, it } from 'vitest';
import { deviceWith, type ProgramOptions } from '../run/testing/run-program';
import { readFrames, readPosition } from './frames';

/** The stack of a program half a second after its start, as text, innermost first. */
function stackOf(program: string, options: ProgramOptions = {}): readonly string[] {
  const { vm } = deviceWith(`from microbit import *\n${program}`, options);
  vm.resume(500_000);
  return readFrames(vm.inspected).map(({ code, line }) => `${code.file}:${line} ${code.name}`);
}

describe('the position in a program', () => {
  it('is the line that waits, however long it sleeps in the library', () => {
    const { vm } = deviceWith('from microbit import *\nsleep(100)\nsleep(1000)');
    vm.resume(50_000);
    expect(readPosition(vm.inspected)).toEqual({ file: 'main.py', line: 2, depth: 0 });
    vm.resume(500_000);
    expect(readPosition(vm.inspected)).toEqual({ file: 'main.py', line: 3, depth: 0 });
  });

  it('is known in a loop without a pause, too', () => {
    expect(stackOf('n = 0\nwhile True: n += 1')).toEqual(['main.py:3 <module>']);
  });

  it('has the calls that led there', () => {
    expect(stackOf('def f(n):\n    if n == 0:\n        sleep(1000)\n    f(n - 1)\nf(2)')).toEqual([
      'main.py:4 f',
      'main.py:5 f',
      'main.py:5 f',
      'main.py:6 <module>',
    ]);
  });

  it.each([
    ['a generator', 'def g():\n    yield 1\n    sleep(1000)\n    yield 2\nfor x in g():\n    pass', 'main.py:4 g'],
    ['a lambda', 'f = (\n    lambda: sleep(1000))\nf()', 'main.py:3 <lambda>'],
    ['a list comprehension', 'x = [\n    sleep(1000) for i in (1, 2)]', 'main.py:3 <listcomp>'],
    ['a class body', 'class A:\n    x = 1\n    sleep(1000)', 'main.py:4 A'],
    ['a method', 'class A:\n    def run(self):\n        sleep(1000)\nA().run()', 'main.py:4 run'],
    ['an exception handler', 'try:\n    1 / 0\nexcept ZeroDivisionError:\n    sleep(1000)', 'main.py:5 <module>'],
    ['a finally', 'try:\n    x = 1\nfinally:\n    sleep(1000)', 'main.py:5 <module>'],
    [
      'a with',
      'class A:\n    def __enter__(self):\n        pass\n    def __exit__(self, *a):\n        sleep(1000)\nwith A():\n    x = 1',
      'main.py:6 __exit__',
    ],
    ['a call over several lines', 'sleep(\n    500 +\n    500)', 'main.py:2 <module>'],
    ['line 2000', `${'\n'.repeat(1998)}sleep(1000)`, 'main.py:2000 <module>'],
    [
      'a callback',
      'def tick():\n    sleep(1000)\nrun_every(tick, ms=100)\nwhile True:\n    sleep(10)',
      'main.py:3 tick',
    ],
  ])('is right in %s', (_, program, expected) => {
    expect(stackOf(program)[0]).toBe(expected);
  });

  it('shows the program beneath a callback, and no function of the library between', () => {
    expect(stackOf('def tick():\n    sleep(1000)\nrun_every(tick, ms=100)\nwhile True:\n    sleep(10)')).toEqual([
      'main.py:3 tick',
      'main.py:6 <module>',
    ]);
  });

  it('is right after many errors that were caught in deep calls', () => {
    const program =
      'def f(n):\n    if n == 0:\n        raise ValueError\n    f(n - 1)\nfor i in range(50):\n    try:\n        f(20)\n    except ValueError:\n        pass\nsleep(1000)';
    expect(stackOf(program)).toEqual(['main.py:11 <module>']);
  });

  it("is right in a file of the pupil's while it is imported; a driver that is one can be stepped into, ours not", () => {
    const helper = 'from microbit import sleep\ndef go():\n    sleep(1000)\n';
    const libraries = { 'robot.py': helper };
    expect(stackOf('import robot\nrobot.go()', { libraries })).toEqual(['main.py:3 <module>']);
    expect(stackOf('import robot\nrobot.go()', { libraries, files: { 'robot.py': helper } })).toEqual([
      'robot.py:3 go',
      'main.py:3 <module>',
    ]);
    expect(stackOf('import other', { files: { 'other.py': `${helper}go()` } })).toEqual([
      'other.py:3 go',
      'other.py:4 <module>',
      'main.py:2 <module>',
    ]);
  });

  it('is nowhere before the program and after its end', () => {
    const { vm } = deviceWith('x = 1');
    expect(readPosition(vm.inspected)).toBeNull();
    vm.resume(1_000_000);
    expect(readPosition(vm.inspected)).toBeNull();
  });

  it('is right after reset()', () => {
    const { vm } = deviceWith(
      "import os, microbit\nif 'seen' in os.listdir():\n    while True: pass\nopen('seen', 'w').close()\nmicrobit.reset()",
    );
    vm.resume(2_000_000);
    expect(readPosition(vm.inspected)).toEqual({ file: 'main.py', line: 3, depth: 0 });
  });
});
