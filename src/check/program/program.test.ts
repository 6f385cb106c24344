import { describe, expect, it } from 'vitest';
import type { Fact } from '../task/task';
import { findFact } from './facts';
import { twinHash } from './twin';

const holds = (fact: Fact, text: string): boolean => findFact(fact, { 'main.py': text }).holds;

describe('facts about a program', () => {
  it('a loop is a for or a while, not a word in a text', () => {
    const loop: Fact = { type: 'loop' };
    expect(holds(loop, 'while True:\n  pass')).toBe(true);
    expect(holds(loop, 'def f():\n  for i in x: pass')).toBe(true);
    expect(holds(loop, '# while True:\nprint("for i in x:")')).toBe(false);
  });

  it('a call is found by the name of the function or of its object, also under another name', () => {
    const irLeft: Fact = { type: 'calls', name: 'irLeft' };
    expect(holds(irLeft, 'if irLeft.read_digital() == 0: pass')).toBe(true);
    expect(holds(irLeft, 'from mbrobot import irLeft as l\nx = l.read_digital()')).toBe(true);
    expect(holds(irLeft, 'irLeft\nx = irLeft.read_digital')).toBe(false);
    expect(holds({ type: 'calls', name: 'display.show' }, 'display.show(1)')).toBe(true);
    expect(holds({ type: 'calls', name: 'display.show' }, 'display.scroll(1); show(1)')).toBe(false);
  });

  it('lines are those with code on them', () => {
    const text = '# a\n\nx = 1  # b\nif x:\n    y = """\nc\n"""\n';
    expect(findFact({ type: 'lines', most: 5 }, { 'main.py': text })).toEqual({ holds: true, found: 5, line: null });
    expect(findFact({ type: 'lines', most: 4 }, { 'main.py': text }).holds).toBe(false);
    expect(findFact({ type: 'lines', most: 9 }, { 'main.py': 'x = 1', 'a.py': 'y = 1', 'b.txt': 'z' }).found).toBe(2);
  });

  it('the longest wait counts ms, seconds of time.sleep, and sums of figures', () => {
    const most: Fact = { type: 'delay', most: 2000 };
    const longest = (text: string) => findFact(most, { 'main.py': text });
    expect(longest('delay(100)\ndelay(2500)\n')).toEqual({ holds: false, found: 2500, line: 2 });
    expect(longest('sleep(2 * (500 + 500))').holds).toBe(true);
    expect(longest('import time\ntime.sleep(3)')).toEqual({ holds: false, found: 3000, line: 2 });
    expect(longest('from time import sleep\nsleep(3)').found).toBe(3000);
    expect(longest('delay(x)\nrobot.delay("a")').found).toBe(0);
  });

  it('are found in a half-written program as far as it goes', () => {
    expect(holds({ type: 'loop' }, 'while True\n  x = (')).toBe(true);
    expect(holds({ type: 'loop' }, '('.repeat(5_000))).toBe(false);
    expect(holds({ type: 'delay', most: 1 }, `delay(${'1+'.repeat(5_000)}1)`)).toBe(true);
  });
});

describe('twins', () => {
  const program =
    'from mbrobot import *\ndef corner(ms):\n    left()\n    delay(ms)\nfor i in range(4):\n    corner(500)\n';
  const twin = (text: string): string => twinHash({ 'main.py': text });

  it('are programs that differ in names, spaces and comments', () => {
    const copied = '# by Beat\nfrom mbrobot import *\ndef ecke(zeit):\n  left( )\n  delay( zeit )\n\nfor k in range( 4 ):\n  ecke(500)  # !\n'; // prettier-ignore
    expect(twin(copied)).toBe(twin(program));
  });

  it('are not programs that do something else', () => {
    for (const [from, to] of [
      ['left', 'right'],
      ['4', '5'],
      ['500', '600'],
      ['corner(500)', 'corner(500)\n    corner(500)'],
    ] as const)
      expect(twin(program.replaceAll(from, to)), to).not.toBe(twin(program));
    expect(twin('from mbrobot import left\nleft()')).not.toBe(twin('from mbrobot import right\nright()'));
    expect(twin('if a:\n  b()\nc()')).not.toBe(twin('if a:\n  b()\n  c()'));
    expect(twin('x = 1\ny = x')).not.toBe(twin('x = 1\ny = y'));
  });
});

describe('a pause by another name', () => {
  const within = (text: string) => findFact({ type: 'delay', most: 1000 }, { 'main.py': text });

  it('is found, in the unit of what it stands for', () => {
    expect(within('from microbit import sleep as warte\nwarte(5000)')).toEqual({ holds: false, found: 5000, line: 2 });
    expect(within('from time import sleep as warte\nwarte(2)')).toEqual({ holds: false, found: 2000, line: 2 });
    expect(within('import time as t\nt.sleep(2)')).toEqual({ holds: false, found: 2000, line: 2 });
    expect(within('from microbit import sleep as warte\nwarte(500)').holds).toBe(true);
    expect(within('from microbit import *\nwarte = sleep\nwarte(5000)').found).toBe(5000);
    expect(within('import time\nwarte = time.sleep\nwarte(2)').found).toBe(2000);
  });

  it('is found where its figure has a name: the one given last', () => {
    expect(within('from microbit import *\nt = 5000\nsleep(t)')).toEqual({ holds: false, found: 5000, line: 3 });
    expect(within('t = 5000\nt = 100\nsleep(t)').found).toBe(100);
    expect(within('t = 100\nsleep(t)\nt = 5000\nsleep(2 * t)')).toEqual({ holds: false, found: 10_000, line: 4 });
    expect(within('SECOND = 1000\ndef pause():\n    sleep(long)\nlong = 3 * SECOND\npause()').found).toBe(3000);
    expect(within('t = 5000\nt = t - 4900\nsleep(t)').holds).toBe(true);
    expect(within('t = 5000\nt -= 4900\nsleep(t)').holds).toBe(true);
    expect(within('for t in range(5000):\n    sleep(t)\na = b\nb = a\nsleep(a)').found).toBe(0);
  });
});
