import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { deviceWith, type Device } from '../run/testing/run-program';
import { readPosition } from './frames';
import { watchLines } from './line-watch';
import { atBreakPoints, type BreakPoint } from './stops';

type Files = Readonly<Record<string, string>>;

const UNTIL_US = 1_700_000;
/** No more is compared of one program. */
const MOST_STOPS = 300;

/** The stops of a program, with its undisturbed end. */
interface Stops {
  readonly stops: readonly string[];
  readonly output: string;
  readonly free: number;
}

/** @param findsAll by looking at every bytecode, as stepping does */
function stopsOf(device: Device, points: readonly BreakPoint[], findsAll: boolean): Stops {
  const { vm, clock } = device;
  const rule = atBreakPoints(points);
  const stops: string[] = [];
  vm.hold.watch = watchLines(() => vm.inspected, findsAll ? (event) => rule(event) : rule);
  while (clock.nowUs < UNTIL_US && vm.ended === null && stops.length < MOST_STOPS) {
    vm.resume(Math.min(clock.nowUs + 4000, UNTIL_US));
    const at = readPosition(vm.inspected);
    if (vm.hold.isHeld) stops.push(`${at?.file ?? ''}:${at?.line ?? 0}@${at?.depth ?? 0} ${clock.nowUs}`);
  }
  vm.hold.watch = null;
  vm.resume(UNTIL_US);
  return { stops, output: device.console(), free: vm.heapFree() };
}

const inMain = (lines: readonly number[]): readonly BreakPoint[] => lines.map((line) => ({ file: 'main.py', line }));

/** All lines of all files. */
const everyLine = (files: Files): readonly BreakPoint[] =>
  Object.entries(files).flatMap(([file, text]) => text.split('\n').map((_, index) => ({ file, line: index + 1 })));

const deviceOf = ({ 'main.py': main = '', ...files }: Files): Device => deviceWith(main, { files });

const undisturbed = new Map<Files, Omit<Stops, 'stops'> & { readonly endUs: number }>();

/** The outcome of a program that is not debugged. */
function undisturbedOf(files: Files) {
  const known = undisturbed.get(files);
  if (known !== undefined) return known;
  const device = deviceOf(files);
  while (device.vm.ended === null && device.clock.nowUs < UNTIL_US) device.vm.resume(device.clock.nowUs + 1000);
  const endUs = device.clock.nowUs;
  device.vm.resume(UNTIL_US);
  const found = { output: device.console(), free: device.vm.heapFree(), endUs };
  undisturbed.set(files, found);
  return found;
}

/** Expects the stops that looking at every bytecode finds, and the output and free memory of the undisturbed run. */
function expectSame(files: Files, points: readonly BreakPoint[]): readonly string[] {
  const found = stopsOf(deviceOf(files), points, false);
  const wanted = stopsOf(deviceOf(files), points, true);
  const undisturbed = undisturbedOf(files);
  const what = JSON.stringify(points);
  expect(found.stops, what).toEqual(wanted.stops);
  expect([found.output, found.free], what).toEqual([undisturbed.output, undisturbed.free]);
  return found.stops;
}

const PROGRAMS: Readonly<Record<string, Files>> = {
  recursion: {
    'main.py':
      'def f(n):\n    if n > 0:\n        return f(n - 1) + 1\n    return 0\nfor i in range(3):\n    f(i)\nprint(f(4))',
  },
  'loops in one line': {
    'main.py':
      'i = 0\nwhile i < 5: i += 1\nfor k in range(3): i += k\nwhile True:\n    i += 1\n    if i > 12: break\nwhile i: i -= 1\nprint(i)',
  },
  'a loop as the first line of a function': {
    'main.py':
      'def f():\n    while True:\n        yield 1\ndef g(n):\n    for i in range(n): pass\nx = f()\nfor i in range(3): next(x)\ng(2)\ng(2)',
  },
  generators: {
    'main.py':
      'def g(n):\n    for i in range(n):\n        x = yield i\n        print(x)\nfor a in g(2):\n    print(a)\nprint(sum(g(3)), list(g(2)))\nh = g(3)\nprint(next(h))\nprint(h.send(7))\nh.close()\nprint([v for v in g(1)])',
  },
  'generators that delegate, and are thrown into': {
    'main.py':
      'def g():\n    try:\n        yield 1\n        yield 2\n    except ValueError:\n        yield 3\n    finally:\n        print("f")\ndef h():\n    yield from g()\n    a = yield from g()\n    yield a\nfor x in h():\n    print(x)\nk = g()\nnext(k)\nprint(k.throw(ValueError))\nprint(sum(h() if False else [1]))\nm = h()\nnext(m)\nm.close()',
  },
  'exceptions in finally': {
    'main.py':
      'def f(n):\n    try:\n        try:\n            return 10 // n\n        finally:\n            n = [][n]\n    except IndexError as e:\n        print(e)\n    finally: print("last")\nfor i in range(2):\n    try:\n        f(i)\n    except Exception as e: print(repr(e))\nfor i in range(3):\n    try:\n        if i == 1: continue\n        if i == 2: break\n    finally:\n        print(i)\ntry: print(1)\nfinally: print(2)',
  },
  'exceptions in loops': {
    'main.py':
      'def bad(n):\n    if n < 2: raise ValueError(n)\n    return [n]\nk = 0\nwhile k < 3:\n    try:\n        k += 1\n        for x in bad(k): print(x)\n        [][k]\n    except (ValueError, IndexError):\n        print(k)\nfor i in range(3):\n    try:\n        k += 0\n        [][i]\n    except IndexError: k -= 1\nfor i in range(4):\n    try:\n        k += 1\n        if i < 2: continue\n        if i > 2: break\n    finally: k += 2\n    k += 3',
  },
  'with and classes': {
    'main.py':
      'class C:\n    n = 0\n    def __init__(self, k):\n        self.k = k\n    def __enter__(self):\n        C.n += 1\n        return self\n    def __exit__(self, a, b, c):\n        return a is not None\n    def __add__(self, other):\n        return C(self.k + other.k)\n    @property\n    def twice(self):\n        return 2 * self.k\nwith C(1) as c:\n    x = (c +\n        C(2) +\n        C(3))\n    print(x.twice, [C(i).twice for i in range(3)])\n    1 / 0\nwith C(2): print(C.n)\nprint(sorted([3, 1, 2], key=lambda v:\n    -v))',
  },
  'modules and closures': {
    'main.py':
      'import helper\ndef outer():\n    n = 0\n    def inner():\n        nonlocal n\n        n += 1\n        return n\n    return inner\nf = outer()\nprint(f(), f())\ndef late():\n    import later\n    return later.g(2)\nprint(helper.double(3), late(), late())\nexec("x = 1\\nx = 2\\nprint(x)")',
    'helper.py': 'def double(x):\n    y = x * 2\n    return y\nk = [double(i) for i in range(2)]',
    'later.py': 'def g(n):\n    while n > 0:\n        n -= 1\n    return n\nprint("later")',
  },
  'callbacks and music': {
    'main.py':
      'from microbit import *\nimport music\nn = 0\ndef tick():\n    global n\n    n += 1\n    print(n)\nrun_every(tick, ms=25)\nmusic.play(["c4:1", "d", "e"], wait=False)\nfor i in range(4):\n    sleep(20)\n    for k in range(60): pass\nprint("end")\nwhile running_time() < 300: pass',
  },
  'a board that is reset': {
    'main.py':
      'import machine\nn = 0\ntry:\n    n = len(open("f").read())\nexcept OSError:\n    pass\nfor i in range(n + 2):\n    print(i)\nwith open("f", "w") as f:\n    f.write("x" * (n + 1))\nif n < 2:\n    machine.reset()',
  },
  'memory that is used again': {
    'main.py':
      'import gc\ndef make(n):\n    exec("def f():\\n    return %d" % n, globals())\n    return f()\nfor i in range(40):\n    s = [j for j in range(30)]\n    make(i)\n    gc.collect()\nprint(gc.mem_free())',
  },
};

describe('stops at a few lines', { timeout: 60_000 }, () => {
  it.each(Object.keys(PROGRAMS))('are those of looking at every bytecode: %s', (name) => {
    const files = PROGRAMS[name]!;
    const all = everyLine(files);
    const stops = new Set(all.flatMap((point) => expectSame(files, [point])).map((stop) => stop.split('@')[0]));
    expect(stops.size).toBeGreaterThan(all.length / 3);
    expectSame(files, all);
    const rng = createRng(name.length);
    for (let round = 0; round < 4; round++)
      expectSame(
        files,
        all.filter(() => rng.unit() < 0.3),
      );
  });

  it('are the same in random programs', () => {
    const programs = readFileSync('src/vm/debug/testing/cpython-traces.jsonl', 'utf8').trimEnd().split('\n');
    const rng = createRng(5);
    let stops = 0;
    for (const [index, line] of programs.entries()) {
      const { program } = JSON.parse(line) as { program: string };
      const lines = program.split('\n').map((_, place) => place + 1);
      if (index % 4 === 0)
        stops += expectSame({ 'main.py': program }, inMain(lines.filter(() => rng.unit() < 0.25))).length;
    }
    expect(stops).toBeGreaterThan(1000);
  });

  it.each(Object.keys(PROGRAMS))('also when they are set while the program runs: %s', (name) => {
    const files = PROGRAMS[name]!;
    const all = everyLine(files);
    const rng = createRng(name.length);
    const { endUs } = undisturbedOf(files);
    let stops = 0;
    for (let round = 0; round < 12; round++) {
      const points = all.filter(() => rng.unit() < 0.4);
      const fromUs = rng.u32() % endUs;
      const [found, wanted] = [false, true].map((findsAll) => {
        const device = deviceOf(files);
        device.vm.resume(fromUs);
        return stopsOf(device, points, findsAll);
      });
      expect(found, JSON.stringify({ points, fromUs })).toEqual(wanted);
      stops += found?.stops.length ?? 0;
    }
    expect(stops).toBeGreaterThan(0);
  });
});
