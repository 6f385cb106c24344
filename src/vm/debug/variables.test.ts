import { describe, expect, it } from 'vitest';
import { deviceWith, runProgram } from '../run/testing/run-program';
import { readVariables, type Variable, type Variables } from './variables';

/** The variables of a program half a second after its start. */
function look(program: string, files: Readonly<Record<string, string>> = {}): Variables {
  const { vm } = deviceWith(`from microbit import *\n${program}`, { files });
  vm.resume(500_000);
  expect(vm.ended?.exception ?? null).toBeNull();
  return readVariables(vm.inspected);
}

const texts = (variables: readonly Variable[] | undefined): Readonly<Record<string, string>> =>
  Object.fromEntries((variables ?? []).map(({ name, value }) => [name, value.text]));

/** The value of a global variable, with its parts. */
const valueOf = (program: string, name: string) =>
  look(`${program}\nsleep(1000)`).globals.find((one) => one.name === name)?.value;

const EXPRESSIONS = [
  'None', 'True', 'False', '0', '-1', '1073741823', '-1073741824', '1073741824', '10 ** 30', '-(7 ** 40)',
  '0.5', '1.0', '-2.5e-07', '1e30', '21 * 1.8 + 32', 'float("inf")', 'float("nan")', '1 / 3',
  '""', '"text"', '"it\'s"', '\'say "hi"\'', '"both \' and \\""', '"a\\nb\\tc\\\\d"', '"Grüezi €"', '"x" * 100', '"\\x00\\x7f"',
  'b""', 'b"bytes\\x00\\xff\'"', 'bytearray(b"abc")', 'bytearray(0)',
  '[]', '[1, 2, 3]', '[[], [1, [2]]]', '()', '(1,)', '(1, "a", 2.5)', '{}', '{"a": 1, 2: [3]}', '{1: {2: {3: 4}}}',
  'set()', '{1}', 'frozenset()', 'frozenset((1,))', 'range(5)', 'range(2, 10, 3)',
  'ValueError("no", 3)', 'OSError(19)', 'KeyError()', 'StopIteration', 'int', 'object', '...', 
  '__import__("array").array("h", [1, -2, 300])', '__import__("array").array("f", [0.1])', '__import__("array").array("b")',
  '__import__("collections").namedtuple("Point", ("x", "y"))(1, [2])', '__import__("collections").OrderedDict([(2, 1), (1, 2)])',
  '[i for i in range(20)]', '{x: x * x for x in range(6)}', '(None, (True, (False,)))',
]; // prettier-ignore

describe('the variables of a program that stands still', () => {
  it.each(EXPRESSIONS)('are shown as repr gives them: %s', (expression) => {
    const program = `x = ${expression}\nprint(repr(x))\nsleep(1000)`;
    const { vm, console } = deviceWith(`from microbit import *\n${program}`);
    vm.resume(900_000);
    expect(texts(readVariables(vm.inspected).globals)['x']).toBe(console().trimEnd());
  });

  it('are those of every function that runs, innermost first', () => {
    const { stack } = look(`
total = 10
def inner(a, b=2, *rest, key=5, **others):
    c = a + b
    del b
    sleep(1000)
def outer(n):
    words = ['x'] * n
    inner(n, 4, 7, 8, z=9)
outer(3)`);
    expect(stack.map(({ function: name, line }) => `${name}:${line}`)).toEqual(['inner:7', 'outer:10', '<module>:11']);
    expect(texts(stack[0]?.locals)).toEqual({ a: '3', key: '5', rest: '(7, 8)', others: "{'z': 9}", c: '7' });
    expect(texts(stack[1]?.locals)).toEqual({ n: '3', words: "['x', 'x', 'x']" });
    expect(stack[2]?.locals).toEqual([]);
  });

  it('are found in closures, comprehensions, generators, class bodies and handlers', () => {
    expect(
      look(`
def counter(step):
    count = 0
    def more(by):
        nonlocal count
        count += step * by
        sleep(1000)
        return count
    return more
counter(3)(2)`).stack.map(({ locals }) => texts(locals)),
    ).toEqual([{ by: '2', step: '3', count: '6' }, {}]);
    const comprehension = look(
      'def wait(n):\n    sleep(1000)\ndef f(k):\n    return [wait(i * k) for i in range(4)]\nf(2)',
    );
    expect(comprehension.stack.map(({ function: name, locals }) => [name, texts(locals)])).toEqual([
      ['wait', { n: '0' }],
      ['<listcomp>', { i: '0', k: '2' }],
      ['f', { k: '2' }],
      ['<module>', {}],
    ]);
    const generator = look(
      'def g():\n    at = 0\n    while True:\n        at += 1\n        sleep(200)\n        yield at\nfor x in g():\n    y = x',
    );
    expect(generator.stack.map(({ function: name, locals }) => [name, texts(locals)])).toEqual([
      ['g', { at: '3' }],
      ['<module>', {}],
    ]);
    expect(texts(generator.globals)).toEqual({ g: '<function g>', x: '2', y: '2' });
    const body = look('class Robot:\n    wheels = 2\n    name = "mouse"\n    sleep(1000)');
    expect(texts(body.stack[0]?.locals)).toEqual({ wheels: '2', name: "'mouse'" });
    const handler = look(
      'def f():\n    try:\n        [][3]\n    except IndexError as error:\n        sleep(1000)\nf()',
    );
    expect(texts(handler.stack[0]?.locals)).toEqual({ error: "IndexError('list index out of range',)" });
  });

  it('are those of the file that runs, without what it has imported', () => {
    const seen = look('import music\nfrom random import randint\nimport helper\n', {
      'helper.py': 'from microbit import *\nimport math\nlimit = 5\nsleep(1000)',
    });
    expect(seen.stack.map(({ file }) => file)).toEqual(['helper.py', 'main.py']);
    expect(texts(seen.globals)).toEqual({ limit: '5' });
    expect(texts(look('import music\nimport helper\nx = 1\nsleep(1000)', { 'helper.py': 'y = 2' }).globals)).toEqual({
      helper: "<module 'helper'>",
      x: '1',
    });
  });

  it('leave out what a driver of a robot has brought, whether it is imported as a whole or by its names', () => {
    const { vm } = deviceWith('from motors import *\nimport motors\nspeed = 3\nmine = Motor()\nwhile True: pass', {
      libraries: { 'motors.py': 'class Motor: pass\nleft = Motor()\nLIMIT = 255\ndef go(): pass' },
    });
    vm.resume(500_000);
    expect(texts(readVariables(vm.inspected).globals)).toEqual({ speed: '3', mine: '<Motor object>' });
  });

  it('can be unfolded: items, entries, attributes', () => {
    const robot = valueOf(
      'class Robot:\n    kind = "mouse"\n    def __init__(self):\n        self.speed = 3\n        self.path = [(1, 2), (3, 4)]\nrobot = Robot()',
      'robot',
    );
    expect(robot).toEqual({
      type: 'Robot',
      text: '<Robot object>',
      parts: [
        { name: 'speed', value: { type: 'int', text: '3' } },
        {
          name: 'path',
          value: {
            type: 'list',
            text: '[(1, 2), (3, 4)]',
            parts: [
              { name: '[0]', value: expect.objectContaining({ type: 'tuple', text: '(1, 2)' }) },
              { name: '[1]', value: expect.objectContaining({ text: '(3, 4)' }) },
            ],
          },
        },
      ],
    });
    expect(
      valueOf('d = {"left": 3, (1, 2): None}', 'd')
        ?.parts?.map(({ name }) => name)
        .sort(),
    ).toEqual(["['left']", '[(1, 2)]']);
    expect(valueOf('class Stack(list):\n    pass\ns = Stack([7])\ns.name = "s"', 's')).toMatchObject({
      text: '[7]',
      parts: [{ name: 'name' }, { name: '[0]', value: { text: '7' } }],
    });
  });

  it('are bounded, and what contains itself is named, not followed', () => {
    const long = valueOf('numbers = list(range(1000))', 'numbers');
    expect([long?.parts?.length, long?.more]).toEqual([100, 900]);
    expect(long?.text).toMatch(/^\[0, 1, 2, .*, 39, …\]$/);
    expect(valueOf('ring = [1]\nring.append(ring)', 'ring')).toMatchObject({
      text: '[1, […]]',
      parts: [{ name: '[0]' }, { name: '[1]', value: { type: 'list', text: '[1, […]]' } }],
    });
    expect(valueOf('deep = []\nfor i in range(200):\n    deep = [deep]', 'deep')?.text).toBe('[[[[[[…]]]]]]');
    expect(valueOf('huge = 3 ** 5000', 'huge')?.text).toBe('<int>');
  });

  it('stay after the program has ended', () => {
    const { vm } = deviceWith('x = 4\ndef f(): pass');
    vm.resume(1_000_000);
    expect(vm.ended?.kind).toBe('finished');
    expect(readVariables(vm.inspected).stack).toEqual([]);
    expect(texts(readVariables(vm.inspected).globals)).toEqual({ x: '4', f: '<function f>' });
  });

  it('are looked at without a trace: output, time and free memory are those of a run that nobody watched', () => {
    const program = `
import gc, random
class Node:
    def __init__(self, n, next):
        self.n = n
        self.next = next
def build(n):
    return None if n == 0 else Node(n, build(n - 1))
chain = build(12)
table = {}
for i in range(300):
    table[i % 17] = [random.random() for _ in range(i % 5)]
    gc.mem_free()
print(gc.mem_free(), len(table), sorted(table)[3])`;
    const alone = runProgram(program);
    const { vm, clock, console } = deviceWith(program);
    let looks = 0;
    while (!vm.ended) {
      vm.resume(clock.nowUs + 97);
      looks += readVariables(vm.inspected).globals.length;
    }
    expect(looks).toBeGreaterThan(1000);
    expect({ console: console(), nowUs: clock.nowUs, heapFree: vm.heapFree() }).toEqual({
      console: alone.console,
      nowUs: alone.nowUs,
      heapFree: alone.heapFree,
    });
  });
});
