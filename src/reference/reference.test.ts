import { describe as describeThing, expect, it } from 'vitest';

import { boardTypes } from '#board/boards/index';
import type { BoardApi } from '#core/board-api';
import { callAt, parametersOf } from './arguments';
import { complete } from './complete';
import type { ReferenceContext } from './context';
import { describe } from './describe';
import type { Item } from './item';
import { boardModules } from './modules/index';
import { mistakesIn } from './testing/catalogues';
import { allTextKeys } from './text-keys';
import de from './words/de.json';
import en from './words/en.json';
import fr from './words/fr.json';
import italian from './words/it.json';
import type { Entry, Names } from './types';

const microbit: ReferenceContext = { board: 'microbit-v2', features: [], modules: [], files: {} };
const calliope: ReferenceContext = { ...microbit, board: 'calliope-mini-3' };

/** A program with ¦ where the cursor stands. */
function at(program: string): [source: string, offset: number] {
  return [program.replace('¦', ''), program.indexOf('¦')];
}
const offered = (program: string, context = microbit): string[] =>
  complete(...at(program), context)?.items.map(({ item }) => item.label) ?? [];
const described = (program: string, context = microbit): Item | null => describe(...at(program), context)?.item ?? null;
const hinted = (program: string, context = microbit): string | null => {
  const hint = callAt(...at(program), context);
  if (hint === null) return null;
  const parameter = parametersOf(hint.item.calls[hint.call] ?? '')[hint.parameter];
  return `${hint.item.label}: ${parameter?.text ?? 'too many'}`;
};
/** Texts with the same words in English and another language. */
const ALIKE = ['microbit.pin8', 'microbit.pin9', 'microbit.pin12', 'microbit.pin16'];
const FROM_BOARD = 'from microbit import *\n';

function everyEntry(names: Names, path: string): [path: string, entry: Entry][] {
  return Object.entries(names).flatMap(([name, entry]) => [
    [`${path}.${name}`, entry] as [string, Entry],
    ...everyEntry(entry.members, `${path}.${name}`),
  ]);
}

describeThing('suggestions in an import', () => {
  it('give another name to a module and to what comes out of it, but not to the star', () => {
    expect(offered('import music ¦')).toEqual(['as']);
    expect(offered('from music import play ¦')).toEqual(['as']);
    expect(offered('from microbit import *¦')).toEqual([]);
  });
});

describeThing('the words of the reference', () => {
  const needed = allTextKeys();

  it('say something about each of 720 names, and about nothing else', () => {
    expect(needed.size).toBeGreaterThan(720);
    expect(Object.keys(de).filter((key) => !needed.has(key))).toEqual([]);
    expect([...needed].filter((key) => !(key in de))).toEqual([]);
  });

  it('say the same in German, French, Italian and English, with the same names and numbers', () => {
    expect(mistakesIn({ de, fr, it: italian, en }, ALIKE)).toEqual([]);
  });

  it('fit a small card: at most 180 signs, ending in a full stop', () => {
    for (const [key, text] of [de, fr, italian, en].flatMap((texts) => Object.entries(texts))) {
      expect(text.length, key).toBeLessThanOrEqual(180);
      expect(text.trim(), key).toMatch(/[.)]$/);
    }
  });

  it('mention no value outside of 0 to 9 for the brightness of an LED', () => {
    expect(de['microbit.display.set_pixel']).toContain('0 (aus) bis 9');
  });
});

describeThing('the tables of the reference', () => {
  const all = boardModules.flatMap((module) => everyEntry(module.names, module.name));

  it('write every call as parameters in brackets, with what comes back behind an arrow', () => {
    for (const [path, entry] of all) {
      for (const call of entry.calls) {
        expect(call, path).toMatch(/^\(.*\)( -> .+)?$/);
        for (const { text } of parametersOf(call)) expect(text, path).toMatch(/^\**\w+(: [^=]+)?( ?= ?.+)?$/);
      }
    }
  });

  it('know the types of all values', () => {
    for (const [path, entry] of all) {
      if (entry.kind !== 'value' || entry.type === 'ellipsis') continue;
      const module = path.split('.')[0] ?? '';
      const board = module.startsWith('calliope') ? calliope : microbit;
      const names = path.slice(module.length + 1).split('.');
      const item = described(`from ${module} import *\n${names.join('.')}¦`, board);
      if (entry.boards?.includes(board.board) ?? true) expect(item?.type, path).toBe(entry.type);
    }
  });

  it('name boards and features as the boards do', () => {
    const boards: BoardApi[] = ['microbit-v2', 'calliope-mini-3'];
    expect(boardTypes.map(({ id }) => id)).toEqual(boards);
    const known = new Set(all.map(([, { feature }]) => feature).filter((feature) => feature !== undefined));
    const had = new Set(boardTypes.flatMap(({ firmwares }) => firmwares.flatMap(({ features }) => features)));
    expect([...known].sort()).toEqual([...had].sort());
  });
});

describeThing('completion', () => {
  it('offers the names of what stands before the dot', () => {
    expect(offered(`${FROM_BOARD}display.¦`)).toEqual(
      expect.arrayContaining(['show', 'scroll', 'clear', 'set_pixel', 'is_on']),
    );
    expect(offered(`${FROM_BOARD}button_a.¦`)).toEqual(['is_pressed', 'was_pressed', 'get_presses']);
    expect(offered('import music as m\nm.¦')).toContain('pitch');
    expect(offered('import microbit\nmicrobit.display.¦')).toContain('show');
  });

  it('follows imports under another name, variables, loops, calls and brackets', () => {
    expect(offered('from neopixel import NeoPixel as N\nnp = N(0, 8)\nnp.¦')).toContain('fill');
    expect(offered(`${FROM_BOARD}for clock in Image.ALL_CLOCKS:\n    clock.¦`)).toContain('shift_left');
    expect(offered(`${FROM_BOARD}Image.HEART.copy().invert().¦`)).toContain('crop');
    expect(offered(`${FROM_BOARD}texts = ['a', 'b']\ntexts[0].¦`)).toContain('upper');
    expect(offered('x = "a,b".split(",")[0]\nx.¦')).toContain('upper');
    expect(offered('with open("a.txt") as f:\n    f.¦')).toContain('readline');
    expect(offered('try:\n    pass\nexcept OSError as e:\n    e.¦')).toContain('errno');
  });

  it('offers images before the functions of an image, and the functions first on an image', () => {
    expect(offered(`${FROM_BOARD}Image.¦`)[0]).toBe('HEART');
    expect(offered(`${FROM_BOARD}x = Image.DUCK\nx.¦`)[0]).toBe('width');
  });

  it('offers names of own functions, classes and files', () => {
    const files = {
      'robot.py': 'class Car:\n    """A car."""\n    wheels = 4\n    def go(self, speed):\n        pass\n',
    };
    const context = { ...microbit, files };
    expect(offered('import ¦', context)).toContain('robot');
    expect(offered('from robot import Car\ncar = Car()\ncar.¦', context)).toEqual(['wheels', 'go']);
    expect(offered('def ride(fast):\n    fa¦')).toContain('fast');
    expect(offered('def ride(fast):\n    pass\nfa¦')).not.toContain('fast');
    expect(offered('class A:\n    def __init__(self):\n        self.x = 1\n    def f(self):\n        self.¦')).toEqual([
      'x',
      'f',
    ]);
  });

  it('offers arguments by name, but not those that the device takes by place only', () => {
    expect(offered(`${FROM_BOARD}display.show('a', ¦`)).toEqual(expect.arrayContaining(['delay=', 'wait=', 'loop=']));
    expect(offered('range(1, ¦')).not.toContain('step=');
    expect(offered('sorted([], ¦')).toContain('reverse=');
  });

  it('offers the gestures inside the quotes', () => {
    expect(offered(`${FROM_BOARD}if accelerometer.was_gesture('¦`)).toContain('face up');
  });

  it('offers modules and their names in imports', () => {
    expect(offered('import ¦')).toEqual(expect.arrayContaining(['microbit', 'music', 'utime']));
    expect(offered('import ¦')).not.toContain('builtins');
    expect(offered('from music import ¦')).toContain('ODE');
  });

  it('knows which board it is for', () => {
    expect(offered('import ¦')).not.toContain('calliopemini');
    expect(offered('import ¦', calliope)).toEqual(
      expect.arrayContaining(['calliopemini', 'calliope_mini', 'microbit']),
    );
    expect(offered('from calliopemini import *\npin_M0¦', calliope)).toContain('pin_M0_SPEED');
    expect(offered('from microbit import *\npin3.¦')).not.toContain('is_touched');
    expect(offered('from microbit import *\npin3.¦', calliope)).toContain('is_touched');
  });

  it('leaves out what the firmware is too old for', () => {
    expect(offered(`${FROM_BOARD}display.¦`)).not.toContain('rotate');
    expect(offered(`${FROM_BOARD}display.¦`, { ...microbit, features: ['rotate'] })).toContain('rotate');
    expect(offered(`${FROM_BOARD}Butt¦`)).not.toContain('Button');
  });

  it('is silent in comments, texts, numbers and where a new name is written', () => {
    for (const program of ['# dis¦', "x = 'pri¦nt'", 'x = 12¦', 'def pri¦', 'class Pri¦', 'import music as pri¦']) {
      expect(offered(program), program).toEqual([]);
    }
  });

  it('offers only words like and, or behind a value', () => {
    expect(offered(`${FROM_BOARD}if button_a.is_pressed() ¦`)).toContain('and');
    expect(offered(`${FROM_BOARD}if button_a.is_pressed() ¦`)).not.toContain('display');
  });

  it('survives a missing bracket in an earlier line', () => {
    expect(offered(`${FROM_BOARD}print(1\ndef f():\n    display.¦`)).toContain('show');
    expect(offered(`${FROM_BOARD}x = (1, [\nwhile True:\n    display.¦\n    sleep(1)`)).toContain('show');
  });

  it('survives every prefix of a program, and names that refer to themselves', () => {
    const program = `${FROM_BOARD}a = b\nb = a\ndef f(x, *, y=[1, {2: "z"}]):\n    """Doc."""\n    x = x.copy()\n    return f"{x}"[::-1]\nclass C(C):\n    pass\nlambda: (yield)\n`;
    for (let end = 0; end <= program.length; end += 1) {
      expect(() => complete(program, end, microbit)).not.toThrow();
      expect(() => complete(program.slice(0, end), end, microbit)).not.toThrow();
      expect(() => describe(program.slice(0, end), end, microbit)).not.toThrow();
      expect(() => callAt(program.slice(0, end), end, microbit)).not.toThrow();
    }
  });
});

describeThing('description', () => {
  it('finds the words of a name through its module', () => {
    expect(described(`${FROM_BOARD}display.sc¦roll("a")`)?.text).toBe('microbit.display.scroll');
    expect(described('from calliopemini import *\n¦display', calliope)?.text).toBe('microbit.display');
    expect(described('import utime\nutime.sleep¦_ms(1)')?.text).toBe('time.sleep_ms');
    expect(described('from time import sleep\n¦sleep(1)')?.text).toBe('time.sleep');
    expect(described('from microbit import *\n¦sleep(1)')?.text).toBe('microbit.sleep');
    expect(described('wh¦ile True: pass')?.text).toBe('keyword.while');
    expect(described('import mus¦ic')?.text).toBe('music');
  });

  it('takes the last import when two modules have the same name', () => {
    expect(described('from time import *\nfrom microbit import *\nslee¦p(1)')?.text).toBe('microbit.sleep');
    expect(described('from microbit import *\nfrom time import *\nslee¦p(1)')?.text).toBe('time.sleep');
  });

  it("shows the pupil's own words and what a variable is", () => {
    const item = described('def go(cm, fast=False):\n    """Drives."""\n    pass\ng¦o(3)');
    expect(item).toMatchObject({ calls: ['(cm, fast=False)'], own: 'Drives.', text: null });
    expect(described('x = 3\ny = x / 2\n¦y')).toMatchObject({ kind: 'variable', type: 'float' });
  });

  it('says that a newer firmware is needed', () => {
    expect(described(`${FROM_BOARD}display.rot¦ate(90)`)?.missing).toBe('rotate');
    expect(described('from microbit import But¦ton')?.missing).toBe('absent');
  });

  it('names the argument', () => {
    expect(describe(...at(`${FROM_BOARD}display.show('a', wai¦t=False)`), microbit)).toMatchObject({
      argument: 'wait',
      item: { label: 'show' },
    });
  });

  it('has nothing to say about unknown names', () => {
    expect(described('pri¦mt(3)')).toBeNull();
    expect(described('import nowhe¦re')).toBeNull();
  });
});

describeThing('the hint on arguments', () => {
  it('follows the commas and the names', () => {
    expect(hinted(`${FROM_BOARD}display.set_pixel(¦`)).toBe('set_pixel: x: int');
    expect(hinted(`${FROM_BOARD}display.set_pixel(max(1, 2), [3, 4][0], ¦)`)).toBe('set_pixel: value: int');
    expect(hinted(`${FROM_BOARD}display.show('a', wait=¦`)).toBe('show: wait: bool = True');
    expect(hinted(`${FROM_BOARD}display.set_pixel(1, 2, 3, ¦`)).toBe('set_pixel: too many');
    expect(hinted('print(1, 2, ¦')).toBe('print: *values');
  });

  it('chooses the way of calling that still fits', () => {
    expect(hinted('range(¦')).toBe('range: stop: int');
    expect(hinted('range(1, ¦')).toBe('range: stop: int');
    expect(hinted('range(1, 2, ¦')).toBe('range: step: int = 1');
  });

  it('is for the innermost call, also inside a list, and knows own functions and classes', () => {
    expect(hinted(`${FROM_BOARD}display.show([Image(¦`)).toBe("Image: text: str = ''");
    expect(hinted(`${FROM_BOARD}music = 1\nprint([1, ¦`)).toBe('print: *values');
    expect(hinted('class A:\n    def __init__(self, size, *, name="x"):\n        pass\nA(1, name=¦')).toBe(
      'A: name="x"',
    );
  });

  it('is silent outside of calls and where a function is defined', () => {
    expect(hinted('x = (1, ¦')).toBeNull();
    expect(hinted('def print(¦')).toBeNull();
    expect(hinted('print(1)¦')).toBeNull();
  });
});
