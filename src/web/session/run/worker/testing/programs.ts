/** Programs of all kinds, for tests of properties that must hold for each. */
import type { Rng } from '#core/rng';

/** A program's files by name. */
export type ProgramFiles = Readonly<Record<string, string>>;

/**
 * Pieces that a program is put together from: the code before the loop, and that of each round. `@` is a number of its
 * own.
 */
const PIECES: readonly { readonly before: string; readonly round: string }[] = [
  {
    before: 'def fib@(k):\n    if k < 2:\n        return k\n    return fib@(k - 1) + fib@(k - 2)',
    round: 'print("fib", fib@(n % 6))',
  },
  {
    before:
      'def count@(k):\n    for i in range(k):\n        got = yield i * n\n        if got: print("got", got)\ng@ = count@(5)\nnext(g@)',
    round:
      'try:\n    print("gen", g@.send(n))\nexcept StopIteration:\n    g@ = count@(3)\n    next(g@)\nprint(sum(count@(3)), [v for v in count@(2)])',
  },
  {
    before: 'def all@():\n    yield from range(2)\n    try:\n        yield 7\n    finally:\n        print("left")',
    round: 'for v in all@():\n    if v + n > 8: break\n    print(v)',
  },
  {
    before:
      'def last@(k):\n    try:\n        try:\n            return 12 // k\n        finally:\n            k = [3, 4][k]\n    except IndexError as e:\n        return repr(e)\n    except ZeroDivisionError:\n        raise\n    finally:\n        print("finally", k)',
    round: 'try:\n    print(last@(n % 3))\nexcept ZeroDivisionError as e:\n    print("caught", e)',
  },
  {
    before:
      'class Shape@:\n    made = 0\n    def __init__(self, k):\n        self.k = k\n        Shape@.made += 1\n    def __add__(self, other):\n        return Shape@(self.k + other.k)\n    def __enter__(self):\n        return self\n    def __exit__(self, *what):\n        return True\n    @property\n    def twice(self):\n        return 2 * self.k\nclass Ball@(Shape@):\n    def __init__(self, k):\n        super().__init__(k + 1)',
    round: 'with Ball@(n) as s:\n    print((s + Shape@(2)).twice, Shape@.made)\n    [][n]',
  },
  {
    before:
      'def outer@():\n    total = 0\n    def inner(k):\n        nonlocal total\n        total += k\n        return lambda: total * k\n    return inner\nf@ = outer@()',
    round: 'print("closure", f@(n)(), sorted([3, 1, 2], key=lambda v: -v))',
  },
  {
    before:
      'ticks@ = []\ndef tick@():\n    ticks@.append(n)\n    if len(ticks@) > 4: ticks@.clear()\nrun_every(tick@, ms=17)',
    round: 'print("ticks", len(ticks@))',
  },
  {
    before: 'music.play(music.NYAN, wait=False, loop=True)',
    round: 'if n % 3 == 2: music.pitch(300 + n, 20, wait=n % 2 == 0)',
  },
  { before: 'import helper', round: 'print("helper", helper.average([n, 2 * n, 9]), helper.calls)' },
  { before: '', round: 'if n == 2:\n    import late\n    print(late.square(n))\nexec("x = n\\nx += 1\\nprint(x)")' },
  {
    before: 'names@ = {}\nbig@ = 1',
    round:
      'names@[str(n)] = [i * n for i in range(20)]\nbig@ *= 12345\nprint(len(names@), big@ % 97, bytes(names@)[:3] if n < 0 else "")',
  },
  {
    before: '',
    round: 's = ""\nfor i in range(30): s += chr(65 + (i * n) % 26)\nprint(s[:5])\nif n % 4 == 3:\n    gc.collect()',
  },
  {
    before: 'radio.on()',
    round: 'radio.send("n%d" % n)\nprint(radio.receive())\nprint(button_a.was_pressed(), button_b.is_pressed())',
  },
  {
    before: '',
    round:
      'display.show(n % 10, wait=False)\ni = 0\nwhile i < 25: i += 1\nprint(random.randint(0, 9), pin1.read_digital())',
  },
  {
    before: 'def deep@(k):\n    return 0 if k == 0 else 1 + deep@(k - 1)',
    round: 'try:\n    print(deep@(n * 40))\nexcept RuntimeError:\n    print("too deep")',
  },
  {
    before: 'm@ = bytearray(64)',
    round: 'for i in range(0, 64, 7):\n    m@[i] = (n * i) & 255\nprint(sum(m@), hash(bytes(m@)) & 15)',
  },
];

const HELPER = `calls = 0
def average(values):
    global calls
    calls += 1
    total = 0
    for value in values:
        total += value
    return total / len(values)
`;
const LATE = 'def square(n):\n    return n * n\nprint("late", [square(i) for i in range(3)])\n';

/** Additional code in each round of a program with a robot. */
const DRIVE = `if n % 4 == 0: forward()
elif n % 4 == 1: leftArc(0.08)
elif n % 4 == 2: right()
else: stop()
print(getDistance(), irLeft.read_digital())`;

/** A program of some pieces, chosen and ordered at random. */
export function randomProgram(rng: Rng, hasRobot: boolean): ProgramFiles {
  const pieces = Array.from({ length: 3 + (rng.u32() % 3) }, (_, place) => {
    const { before, round } = PIECES[rng.u32() % PIECES.length] ?? { before: '', round: '' };
    return { before: before.replaceAll('@', `_${place}`), round: round.replaceAll('@', `_${place}`) };
  });
  const rounds = [...pieces.map(({ round }) => round), ...(hasRobot ? [DRIVE] : [])];
  const main = [
    'from microbit import *\nimport gc, music, radio, random',
    ...(hasRobot ? ['from mbrobot import *'] : []),
    'n = 0',
    ...pieces.map(({ before }) => before),
    `while n < ${4 + (rng.u32() % 20)}:`,
    ...rounds.map((round) => round.replace(/^/gm, '    ')),
    '    n += 1',
    `    sleep(${1 + (rng.u32() % 40)})`,
    'print(gc.mem_free())',
    ...(rng.unit() < 0.3 ? ['1 / 0'] : []),
  ];
  return { 'main.py': `${main.filter((line) => line !== '').join('\n')}\n`, 'helper.py': HELPER, 'late.py': LATE };
}
