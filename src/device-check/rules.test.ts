import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { play } from '#vm/library/testing/play';
import { checkForDevice } from './check-for-device';
import type { Device } from './finding';
import { rules, type RuleId } from './rule-table';

const V212: Device = { features: [], micropython: [1, 18, 0] };
const found = (program: string, device = V212): string[] =>
  checkForDevice({ 'main.py': program }, device).map(({ rule, name }) => (name === '' ? rule : `${rule} ${name}`));

/** Programs that run here and are marked, and programs that look like them and are not. */
interface Case {
  readonly marked: readonly string[];
  readonly fine: readonly string[];
}

const own = (method: string): string => `class A:\n    def ${method}(self, *a):\n        return 1\n`;

const cases: Readonly<Record<RuleId, Case>> = {
  'f-string': {
    marked: ['x = 3\nprint(f"{x}")', 'print(rf"a" "b")', "x = 1\nprint(f'''a\n{x!r:>5}''')"],
    fine: ['f = 3\nprint("{}".format(f))', 'print("f\\"{x}\\"")', '# f"{x}"\nprint(r"f")', 'x = 1\nprint("%d" % x)'],
  },
  'text-method': {
    marked: [
      'print("a\\nb".splitlines())',
      'def f(t):\n    return t.partition(",")\nprint(f("a,b"))',
      'text = "a-b"\ntext.rpartition("-")',
      'name = "Eva"\nname = name + "!"\nprint(name.upper().center(9))',
      'for word in "a b".split(" "):\n    print(word.center(5))',
    ],
    fine: [
      `${own('splitlines')}A().splitlines()`,
      `${own('center')}a = A()\na.center(3)`,
      'class B:\n    def __init__(self):\n        self.center = max\nb = B()\nb.center(3, 4)',
      'from microbit import *\nfrom servo import Servo\ns = Servo(pin0)\ns.center()\ns.partition(3)',
      'import strange\nstrange.partition(3)',
      'center = 3\nprint("{:^5}".format(center), "a".split("\\n"))',
      'def f(servo):\n    servo.center(90)',
    ],
  },
  'bytes-hex': {
    marked: ['print(b"ab".hex())', 'import machine\nprint(machine.unique_id().hex())', 'b = bytearray(2)\nb.hex()'],
    fine: [`${own('hex')}A().hex()`, 'print(hex(255))', 'from color import Color\nc = Color(1)\nc.hex()'],
  },
  'bytes-fromhex': {
    marked: ['print(bytes.fromhex("aa"))', 'print(b"".fromhex("aa"))'],
    fine: [`${own('fromhex')}A().fromhex("aa")`, 'import c\nc.fromhex("aa")'],
  },
  'star-arguments': {
    marked: ['print(*[1], *[2])', 'print(*[1], 2)', 'def f(**k):\n    return k\nprint(f(**{"a": 1}, **{"b": 2}))'],
    fine: [
      'print(*[1, 2])',
      'print(1, *[2], sep="-")',
      'def f(a, *b, **c):\n    return b\nprint(f(1, *[2], **{"x": 3}))',
      'a, *b = [1, 2, 3]',
      'print(2 * 3, 2 ** 3)',
    ],
  },
  'dict-union': {
    marked: ['print({1: 2} | {3: 4})', 'a = {1: 2}\na |= {3: 4}', 'a = dict()\nb = {}\nprint(a | b)'],
    fine: ['print({1} | {2}, 1 | 2)', 'a = 1\na |= 2', 'def f(x: dict | None = None):\n    return x\nf()'],
  },
  'pow-three': {
    marked: ['print(pow(2, 5, 7))'],
    fine: ['print(pow(2, 5))', 'def pow(a, b, c):\n    return a\npow(1, 2, 3)', 'import math\nmath.pow(2, 3)'],
  },
  'round-whole': {
    marked: [
      'print(round(1234, -2))',
      'n = 5\nn = n + 1\nprint(round(n, 1))',
      'from microbit import *\nt = temperature()\nprint(round(t, 1))',
      'def f(x):\n    return round(x, -1)\nprint(f(14))',
      'from microbit import *\nprint(round(accelerometer.get_x(), -1))',
    ],
    fine: [
      'print(round(3.14, 1), round(2.5), round(7 / 2, 1))',
      'print(round(1234.5, -2))',
      'import robot\nround(robot.get_x(), 1)',
      'def f(x):\n    return round(x, 2)\nprint(f(1.234))',
      'n = 5\nn /= 2\nprint(round(n, 1))',
    ],
  },
  'next-default': {
    marked: ['print(next(iter([]), 5))'],
    fine: ['print(next(iter([5])))', 'def next(a, b):\n    return a\nnext(1, 2)', `${own('next')}A().next(1, 2)`],
  },
  'not-implemented': {
    marked: ['def f():\n    return NotImplemented\nf()'],
    fine: ['try:\n    raise NotImplementedError\nexcept NotImplementedError:\n    pass', 'print("NotImplemented")'],
  },
  'builtin-name': {
    marked: ['exec(compile("print(1)", "x", "exec"))'],
    fine: ['exec("print(1)")\neval("1")', 'def compile(x):\n    return x\ncompile(3)', 'dict(compile=3)'],
  },
  'int-bytes': {
    marked: ['print(int.from_bytes(b"ab"))', 'n = 5\nprint(n.to_bytes())', 'print((5).to_bytes(2))'],
    fine: ['print(int.from_bytes(b"ab", "big"), (5).to_bytes(2, "little"))', `${own('to_bytes')}A().to_bytes()`],
  },
  'special-method': {
    marked: [
      'class V:\n    def __mul__(self, n):\n        return n\nprint(V() * 2)',
      'class V:\n    def __neg__(self):\n        return 1\nprint(-V())',
      'class V:\n    def __float__(self):\n        return 1.5\nprint(float(V()))',
    ],
    fine: [
      'class V:\n    def __add__(self, n):\n        return 1\n    def __sub__(self, n):\n        return 1\nprint(V() + 1, V() - 1)',
      'class V:\n    def __eq__(self, n):\n        return True\n    def __len__(self):\n        return 1\nprint(V() == 1, len(V()))',
      'class V:\n    def __iadd__(self, n):\n        return self\n    def __contains__(self, n):\n        return True\nv = V()\nv += 1\nprint(2 in v)',
      'class V:\n    def __getitem__(self, n):\n        return n\n    def __call__(self):\n        return 1\nprint(V()[1], V()())',
      'def __mul__(a, b):\n    return a\n__mul__(1, 2)',
    ],
  },
  'reverse-method': {
    marked: ['class V:\n    def __radd__(self, n):\n        return n\nprint(2 + V())'],
    fine: ['class V:\n    def radd(self, n):\n        return n\nprint(V().radd(2))'],
  },
  'attribute-hook': {
    marked: [
      'class A:\n    def __setattr__(self, name, value):\n        print(name)\nA().x = 1',
      'class A: pass\nobject.__setattr__(A(), "x", 1)',
    ],
    fine: [
      'class A:\n    def __getattr__(self, name):\n        return 1\nprint(A().x)',
      'class A: pass\nsetattr(A(), "x", 1)',
    ],
  },
  descriptor: {
    marked: ['class D:\n    def __get__(self, o, t):\n        return 5\nclass A:\n    d = D()\nprint(A().d)'],
    fine: [
      'class A:\n    @property\n    def x(self):\n        return 1\n    def get(self):\n        return 2\nprint(A().x)',
    ],
  },
  'function-attribute': {
    marked: ['def f():\n    pass\nprint(f.__name__)'],
    fine: [
      'class A: pass\nprint(A.__name__, type(3).__name__)',
      'print(__name__)',
      'def f(cls):\n    return cls.__name__\nf(int)',
    ],
  },
  'slice-attribute': {
    marked: ['class S:\n    def __getitem__(self, i):\n        return i.start\nprint(S()[1:2])'],
    fine: [
      'class S:\n    def __getitem__(self, i):\n        return i\nprint(S()[1])',
      'print(range(1, 5).start)',
      `${own('start')}A().start()`,
    ],
  },
  'array-slice': {
    marked: [
      'b = bytearray(4)\nb[1:3] = b"xy"',
      'import array\na = array.array("b", [1, 2])\na[0:1] = array.array("b", [3])',
    ],
    fine: ['a = [1, 2, 3]\na[0:2] = [9]', 'b = bytearray(4)\nb[1] = 3\nprint(b[1:3])'],
  },
  'math-name': {
    marked: [
      'import math\nprint(math.inf)',
      'from math import tau',
      'from math import *\nprint(log10(100))',
      'import math as m\nm.isclose(1, 2)',
    ],
    fine: [
      'import math\nprint(math.pi, math.sin(1), math.isinf(1), math.log(8, 2))',
      'inf = 3\nprint(inf)',
      'from math import *\ndef log10(x):\n    return 1\nlog10(1)',
      'class M:\n    inf = 3\nmath = M()\nmath.inf',
    ],
  },
  'math-missing': {
    marked: ['from math import factorial\nfactorial(3)'],
    fine: ['def factorial(n):\n    return 1\nfactorial(3)'],
  },
  deque: {
    marked: ['from collections import deque\nprint(deque((), 3))', 'import collections\ncollections.deque((), 3)'],
    fine: ['from collections import namedtuple, OrderedDict', 'deque = []\ndeque.append(1)'],
  },
  'time-name': {
    marked: ['import time\ntime.time()', 'from utime import localtime'],
    fine: ['import time\ntime.sleep(0.1)\nprint(time.ticks_ms())', 'time = 3\nprint(time)'],
  },
  'type-name': {
    marked: [
      'import microbit\nprint(microbit.Button)',
      'from microbit import MicroBitDigitalPin',
      'import os\nprint(os.uname_result)',
    ],
    fine: [
      'from microbit import button_a, pin0\nimport os\nprint(os.uname())',
      'class Button:\n    pass\nButton()',
      'import microbit\ndef f(pin: microbit.MicroBitDigitalPin) -> microbit.Button:\n    return pin\nf(1)',
      'import microbit\npin: microbit.MicroBitDigitalPin = 3\nprint(pin)',
    ],
  },
  module: {
    marked: ['import itertools', 'from typing import List', 'import struct, ubinascii'],
    fine: [
      'import math, random, struct, os, sys, gc, array, errno, utime, urandom, ustruct, machine, micropython',
      'try:\n    import numpy\nexcept ImportError:\n    pass',
    ],
  },
  'module-instead': {
    marked: ['import json', 'import ujson as json', 'from datetime import datetime'],
    fine: ['json = "{}"\nprint(json)'],
  },
  'not-iterable': {
    marked: [
      'from microbit import *\nprint(sum(audio.AudioFrame()))',
      'from microbit import *\nframe = audio.AudioFrame()\nfor value in frame:\n    print(value)\n    break',
    ],
    fine: [
      'with open("a", "w") as f:\n    f.write("x")\nfor line in open("a").read().split("\\n"):\n    print(line)',
      'from microbit import *\nframe = audio.AudioFrame()\nfor i in range(len(frame)):\n    frame[i] = 128',
      'def open(name):\n    return [name]\nfor line in open("a"):\n    print(line)',
      'for f in [1, 2]:\n    print(f)\nprint(sum([1]), 2 in {2})',
    ],
  },
  'in-place': {
    marked: [
      'text = "ab"\ntext *= 3',
      'row = [0]\nrow *= 9',
      's = "%d"\ns %= 5',
      'b = b"x"\nb *= 2',
      'from microbit import *\npic = Image("1:")\npic += Image("2:")',
      'from microbit import *\npic = Image.HEART\npic *= 0.5',
    ],
    fine: [
      'n = 2\nn *= 3\nn %= 4\nn -= 1\nn //= 1\nn **= 2',
      'text = "a"\ntext += "b"\nrow = []\nrow += [1]',
      't = (1,)\nt *= 2\nx = 1.5\nx *= 2\ns = {1}\ns |= {2}\ns &= {1}',
      'def f(x):\n    x *= 2\n    return x\nf(3)',
      'x = "a"\nx = 3\nx *= 2',
      'for x in [1, 2]:\n    x *= 2',
    ],
  },
  'starts-ends': {
    marked: [
      'print("abc".endswith("c", 1))',
      'print("abc".startswith("b", 1, 2))',
      'def f(t):\n    return t.endswith(("a", "b"))\nprint(f("a"))',
      'print("abc".startswith(("a", "b")))',
    ],
    fine: [
      'print("abc".startswith("b", 1), "abc".endswith("c"))',
      `${own('endswith')}A().endswith(1, 2)`,
      'def f(t, end):\n    return t.endswith(end)\nf("a", "b")',
    ],
  },
  'array-method': {
    marked: ['b = bytearray(b"a,b")\nprint(b.find(b","))', 'print(bytearray(b"ab").startswith(b"a"))'],
    fine: [
      'b = bytearray(b"ab")\nb.append(1)\nb.extend(b"c")\nprint(b.decode(), bytes(b).find(b"a"), b"a".find(b"a"))',
      'row = [1, 2]\nprint(row.index(2), row.count(1))',
    ],
  },
  'struct-x': {
    marked: ['import struct\nprint(struct.calcsize("Bx"))', 'import ustruct\nustruct.pack("xB", 1)'],
    fine: [
      'import struct\nprint(struct.pack("<hB", 1, 2))',
      'class S:\n    def pack(self, x):\n        pass\nS().pack("x")',
    ],
  },
  'timer-without-time': {
    marked: [
      'from microbit import *\n@run_every\ndef f():\n    pass',
      'from microbit import run_every\n@run_every()\ndef f():\n    pass',
      'import microbit\nmicrobit.run_every(print, ms=0)',
      'from microbit import *\nrun_every(callback=print)',
    ],
    fine: [
      'from microbit import *\n@run_every(ms=100)\ndef f():\n    pass',
      'from microbit import *\nrun_every(print, s=0, min=1)\nrun_every(print, **{"s": 1})\nt = 0\nrun_every(print, h=t)',
      'def run_every(f):\n    return f\n@run_every\ndef g():\n    pass\nrun_every(g)',
    ],
  },
  'newer-name': {
    marked: [
      'from microbit import *\ndisplay.rotate(90)',
      'import microbit\nmicrobit.display.rotate(90)',
      'from microbit import *\nprint(pin_logo.was_touched(), pin0.get_touches())',
      'from microbit import *\nprint(SoundEvent.CLAP)',
    ],
    fine: [
      'from microbit import *\nbutton_a.was_pressed()\npin0.is_touched()\nmicrophone.sound_level()',
      'class D:\n    def rotate(self, a):\n        pass\ndisplay = D()\ndisplay.rotate(90)',
      'def f(robot):\n    robot.rotate(90)',
    ],
  },
};

/** Refused here as on the device; marked because the sentence helps. */
const REFUSED_HERE: readonly RuleId[] = [
  'module',
  'module-instead',
  'time-name',
  'newer-name',
  'in-place',
  'array-method',
  'struct-x',
];

describe.each(Object.keys(rules) as RuleId[])('the rule %s', (rule) => {
  const { marked, fine } = cases[rule];

  it.each(marked)('marks %j', (program) => {
    expect(found(program).map((it) => it.split(' ')[0])).toContain(rule);
  });

  it.each(fine)('does not mark %j', (program) => {
    expect(found(program)).toEqual([]);
  });

  it.skipIf(REFUSED_HERE.includes(rule)).each(marked)('is about what runs here: %j', (program) => {
    const run = play(program).until(1000);
    expect(run.ended(), run.printed()).toEqual({ kind: 'finished', exception: null });
  });
});

describe('newer firmware', () => {
  it('is not reproached with what its MicroPython 1.23 learned: several stars, joined dictionaries', () => {
    const newer: Device = { features: [], micropython: [1, 23, 0] };
    expect(found('print(*[1], *[2])\nprint({1: 2} | {3: 4})\nprint(f"{1}")', newer)).toEqual(['f-string']);
  });

  it('has the names of its features', () => {
    const newer: Device = { features: ['rotate'], micropython: [1, 23, 0] };
    const program = 'from microbit import *\ndisplay.rotate(90)\nmicrophone.sound_level_db()';
    expect(found(program, newer)).toEqual(['newer-name microphone.sound_level_db']);
    expect(found(program)).toEqual(['newer-name display.rotate', 'newer-name microphone.sound_level_db']);
  });
});

describe('a file in a for loop', () => {
  it.each(['for line in open("a"):\n    print(line)', 'with open("a") as g:\n    for line in g:\n        print(line)'])(
    'is marked before it runs: %s',
    (program) => expect(found(program).map((one) => one.split(' ')[0])).toEqual(['not-iterable']),
  );
});

describe('docs/device-check.md', () => {
  it('has a row for every rule', () => {
    const page = readFileSync('docs/device-check.md', 'utf8');
    expect(Object.keys(rules).filter((rule) => !page.includes(`| \`${rule}\``))).toEqual([]);
  });
});
