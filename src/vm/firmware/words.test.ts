import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { linesOf, play } from '../library/testing/play';

/** The line that ends a traceback, or what the program prints, in place of which the device stands on the right. */
type Case = readonly [program: string, device: string];

function lastLineOf(program: string): string {
  const run = play(program, { 'mine.py': 'x = 1\n' }).until(5000);
  return run.printed().trimEnd().split('\n').at(-1) ?? '';
}

/** py/*.c of MicroPython 1.18, whatever MICROPY_ERROR_REPORTING_NORMAL selects. */
const ofMicroPython: Readonly<Record<string, readonly Case[]>> = {
  'bc.c: calls of Python functions': [
    ['def f(a): return a\nf()', 'TypeError: function takes 1 positional arguments but 0 were given'],
    ['def f(): pass\nf(1, 2)', 'TypeError: function takes 0 positional arguments but 2 were given'],
    ['def f(a, b=1): pass\nf()', 'TypeError: function takes 1 positional arguments but 0 were given'],
    ['def f(a, b=1): pass\nf(1, 2, 3)', 'TypeError: function takes 2 positional arguments but 3 were given'],
    ['(lambda x: x)()', 'TypeError: function takes 1 positional arguments but 0 were given'],
    ['class C:\n  def m(self): pass\nC().m(1)', 'TypeError: function takes 1 positional arguments but 2 were given'],
    [
      'class C:\n  def __init__(self, a): pass\nC()',
      'TypeError: function takes 2 positional arguments but 1 were given',
    ],
    ['def f(a, b): pass\nf(b=1)', 'TypeError: function missing required positional argument #0'],
    ['def f(a): pass\nf(1, a=2)', "TypeError: function got multiple values for argument 'a'"],
    ['def f(a): pass\nf(b=2)', "TypeError: unexpected keyword argument 'b'"],
    ['def f(*, a): pass\nf()', 'TypeError: function missing keyword-only argument'],
    ['def f(*, a, b=1): pass\nf()', "TypeError: function missing required keyword argument 'a'"],
  ],
  'argcheck.c: calls of C functions': [
    ['len()', 'TypeError: function takes 1 positional arguments but 0 were given'],
    ['len(x=3)', "TypeError: function doesn't take keyword arguments"],
    ['[].append()', 'TypeError: function takes 2 positional arguments but 1 were given'],
    ['"a".find()', 'TypeError: function missing 1 required positional arguments'],
    ['abs(1, 2)', 'TypeError: function takes 1 positional arguments but 2 were given'],
    ['range(1, 2, 3, 4)', 'TypeError: function expected at most 3 arguments, got 4'],
    ['sorted()', 'TypeError: function missing 1 required positional arguments'],
  ],
  'objnamedtuple.c: named tuples': [
    [
      'from collections import namedtuple\nnamedtuple("P", "x y")(1)',
      'TypeError: function takes 2 positional arguments but 1 were given',
    ],
    [
      'from collections import namedtuple\nnamedtuple("P", "x y")(1, z=2)',
      "TypeError: unexpected keyword argument 'z'",
    ],
  ],
  'parsenum.c: numbers from texts': [
    ['int("x")', 'ValueError: invalid syntax for integer with base 10'],
    ['int("")', 'ValueError: invalid syntax for integer with base 10'],
    ['int("12", 2)', 'ValueError: invalid syntax for integer with base 2'],
    ['int("3.5")', 'ValueError: invalid syntax for integer with base 10'],
    ['float("x")', 'ValueError: invalid syntax for number'],
  ],
  'runtime.c: names, attributes, operators': [
    ['x', "NameError: name 'x' isn't defined"],
    ['def f():\n  n += 1\nf()', 'NameError: local variable referenced before assignment'],
    ['(1).x', "AttributeError: 'int' object has no attribute 'x'"],
    ['class C: pass\nC.x', "AttributeError: type object 'C' has no attribute 'x'"],
    ['import math\nmath.x', "AttributeError: 'module' object has no attribute 'x'"],
    ['import mine\nmine.y', "AttributeError: 'module' object has no attribute 'y'"],
    ['from math import x', "ImportError: can't import name x"],
    ['import nothing', "ImportError: no module named 'nothing'"],
    ['1 + "a"', "TypeError: unsupported types for __add__: 'int', 'str'"],
    ['-"a"', "TypeError: unsupported type for : 'str'"],
    ['7 % None', "TypeError: unsupported types for : 'int', 'NoneType'"],
    ['None - 1', "TypeError: unsupported types for __sub__: 'NoneType', 'int'"],
    ['3()', "TypeError: 'int' object isn't callable"],
    ['a, b = 1,', 'ValueError: need more than 1 values to unpack'],
    ['a, b = 1, 2, 3', 'ValueError: too many values to unpack (expected 2)'],
    ['for i in 3: pass', "TypeError: 'int' object isn't iterable"],
    ['raise 3', 'TypeError: exceptions must derive from BaseException'],
  ],
  'obj.c, objlist.c, objdict.c: things and their parts': [
    ['[1][3]', 'IndexError: list index out of range'],
    ['(1, 2)["a"]', 'TypeError: tuple indices must be integers, not str'],
    ['len(3)', "TypeError: object of type 'int' has no len()"],
    ['3[0]', "TypeError: 'int' object isn't subscriptable"],
    ['(1,)[0] = 2', "TypeError: 'tuple' object doesn't support item assignment"],
    ['del "a"[0]', "TypeError: 'str' object doesn't support item deletion"],
    ['{}["a"]', 'KeyError: a'],
    ['[].pop()', 'IndexError: pop from empty list'],
    ['chr("a")', "TypeError: can't convert str to int"],
    ['{[]: 1}', "TypeError: unsupported type for __hash__: 'list'"],
  ],
  'objstr.c: texts': [
    ['"a" + 1', "TypeError: can't convert 'int' object to str implicitly"],
    ['s = "a"\ns += 1', "TypeError: can't convert 'int' object to str implicitly"],
    ['"a" - 1', "TypeError: can't convert 'int' object to str implicitly"],
    ['"a" < 1', "TypeError: can't convert 'int' object to str implicitly"],
    ['5 in "abc"', "TypeError: can't convert 'int' object to str implicitly"],
    ['"a" + b"b"', "TypeError: can't convert 'bytes' object to str implicitly"],
    ['"a" + None', "TypeError: can't convert 'NoneType' object to str implicitly"],
    ['b"a" + 1', "TypeError: unsupported types for __add__: 'bytes', 'int'"],
    ['"a" * "b"', "TypeError: unsupported types for : 'str', 'str'"],
    ['s = "ab"\ns = s * 2\nprint(s * 2, "%s" % 3, s == 3, s != None, [] == s)', 'abababab 3 False True False'],
    ['"%d" % "a"', "TypeError: can't convert str to int"],
    ['"%d %d" % 3', 'TypeError: format string needs more arguments'],
    ['"%d" % (1, 2)', "TypeError: format string didn't convert all arguments"],
    ['"{".format()', "ValueError: unmatched '{' in format"],
    ['"}".format()', "ValueError: single '}' encountered in format string"],
    ['"{:x}".format("a")', "ValueError: unknown format code 'x' for object of type 'str'"],
    ['"abc".index("d")', 'ValueError: substring not found'],
    ['ord("ab")', 'TypeError: ord() expected a character, but string of length 2 found'],
  ],
  'compile.c, parse.c: the text of a program': [
    ['print(a=1, 2)', 'SyntaxError: non-keyword arg after keyword arg'],
    ['x = (', 'SyntaxError: invalid syntax'],
    ['break', "SyntaxError: 'break'/'continue' outside loop"],
    ['return 3', "SyntaxError: 'return' outside function"],
    ['def f(a, a): pass', 'SyntaxError: argument name reused'],
    ['def f(a=1, b): pass', 'SyntaxError: non-default argument follows default argument'],
    ['1 = x', "SyntaxError: can't assign to expression"],
    ['  x = 1', 'IndentationError: unexpected indent'],
  ],
};

describe('errors of MicroPython, at the device’s level of reporting', () => {
  describe.each(Object.entries(ofMicroPython))('%s', (_, cases) => {
    it.each(cases)('%j', (program, device) => expect(lastLineOf(program)).toBe(device));
  });
});

describe('errors of a newer MicroPython, the Calliope mini’s 1.23', () => {
  it.each([
    ['"a" + 1', "TypeError: unsupported types for __add__: 'str', 'int'"],
    ['print(a=1, 2)', 'SyntaxError: positional arg after keyword arg'],
    ['def f(a): pass\nf()', 'TypeError: function takes 1 positional arguments but 0 were given'],
  ])('%j', (program, device) => {
    const run = play(program, {}, undefined, { type: calliopeMini3 }).until(5000);
    expect(run.printed().trimEnd().split('\n').at(-1)).toBe(device);
  });
});

/** Calls of the device's own functions: which macro defines them (micropython-microbit-v2 src/codal_port) decides. */
const ofDevice: readonly Case[] = [
  ['display.show()', "TypeError: 'image' argument required"],
  ['display.show(delay=3)', "TypeError: 'image' argument required"],
  ['display.show(imag=3)', "TypeError: 'image' argument required"],
  ['display.show("a", 400, 3)', 'TypeError: extra positional arguments given'],
  ['display.show("a", dely=3)', 'TypeError: extra keyword arguments given'],
  ['display.show("a", image="b")', 'TypeError: extra keyword arguments given'],
  ['display.scroll()', "TypeError: 'text' argument required"],
  ['display.set_pixel(1, 2)', 'TypeError: function takes 4 positional arguments but 3 were given'],
  ['display.get_pixel(x=1, y=2)', "TypeError: function doesn't take keyword arguments"],
  ['button_a.is_pressed(1)', 'TypeError: function takes 1 positional arguments but 2 were given'],
  ['sleep()', 'TypeError: function takes 1 positional arguments but 0 were given'],
  ['sleep(ms=10)', "TypeError: function doesn't take keyword arguments"],
  ['panic(1, 2)', 'TypeError: function expected at most 1 arguments, got 2'],
  ['pin0.write_digital()', 'TypeError: function takes 2 positional arguments but 1 were given'],
  ['pin0.write_digital(value=1)', "TypeError: function doesn't take keyword arguments"],
  ['scale(1)', "TypeError: 'from_' argument required"],
  ['scale(1, to=(0, 1))', "TypeError: 'from_' argument required"],
  ['print(scale(1, from_=(0, 2), to=(0, 10)), scale(1, (0, 2), (0, 10)))', '5 5'],
  ['Image.HEART.shift_left()', 'TypeError: function takes 2 positional arguments but 1 were given'],
  ['Image().blit(Image.HEART)', 'TypeError: function missing 4 required positional arguments'],
  ['Image(x=1)', "TypeError: function doesn't take keyword arguments"],
  ['i2c.read(1)', "TypeError: 'n' argument required"],
  ['i2c.read(1, 2, True, 4)', 'TypeError: extra positional arguments given'],
  ['uart.read(nbytes=3)', "TypeError: function doesn't take keyword arguments"],
  ['uart.read(1, 2)', 'TypeError: function expected at most 2 arguments, got 3'],
  ['spi.read()', 'TypeError: function missing 1 required positional arguments'],
  ['import music\nmusic.pitch()', "TypeError: 'frequency' argument required"],
  ['import music\nmusic.set_tempo(120)', 'TypeError: extra positional arguments given'],
  ['import music\nmusic.stop(1, 2)', 'TypeError: function expected at most 1 arguments, got 2'],
  ['import speech\nspeech.say()', 'TypeError: function missing 1 required positional arguments'],
  ['import speech\nspeech.say("a", 3)', 'TypeError: extra positional arguments given'],
  ['import speech\nspeech.say("a", pich=3)', 'TypeError: extra keyword arguments given'],
  ['import machine\nmachine.time_pulse_us(pin0)', 'TypeError: function missing 1 required positional arguments'],
  ['run_every(s=1)(print)()', 'TypeError: function takes 1 positional arguments but 0 were given'],
  ['run_every(sec=1)', 'TypeError: extra keyword arguments given'],
  // The device's neopixel.py is Python.
  ['import neopixel\nneopixel.NeoPixel()', 'TypeError: function takes 3 positional arguments but 1 were given'],
  ['import neopixel\nneopixel.NeoPixel(pin0)', 'TypeError: function takes 3 positional arguments but 2 were given'],
  ['import neopixel\nneopixel.NeoPixel(pin0, 3, bp=4)', "TypeError: unexpected keyword argument 'bp'"],
  [
    'import neopixel\nneopixel.NeoPixel(pin0, 3).show(1)',
    'TypeError: function takes 1 positional arguments but 2 were given',
  ],
];

describe('wrong calls of the device’s functions', () => {
  it.each(ofDevice)('%j', (program, device) => expect(lastLineOf(`from microbit import *\n${program}`)).toBe(device));
});

describe('what prints as on the device', () => {
  it('a bound method, a closure and the functions of the board are no more than that; one’s own have names', () => {
    const program = `
def f(n):
    return lambda: n
print("".join, display.show, f(1), print, sleep)
print(str(f).split(' ')[:2], str(lambda: 1).split(' ')[:2])`;
    expect(linesOf(program)).toEqual([
      '<bound_method> <bound_method> <closure> <function> <function>',
      "['<function', 'f'] ['<function', '<lambda>']",
    ]);
  });

  it('a module by its name alone, which sys has too', () => {
    const program = `
import sys, music, mine
print(sys, sys.__name__, music, mine)`;
    expect(linesOf(program, { 'mine.py': '' })).toEqual(["<module 'sys'> sys <module 'music'> <module 'mine'>"]);
  });

  it('no warning where an exception is raised from another one', () => {
    const program = `
try:
    raise RuntimeError('x') from ValueError('y')
except RuntimeError as e:
    print(e)`;
    expect(linesOf(program)).toEqual(['x']);
  });
});

describe('a module of the device', () => {
  it('can neither be changed nor emptied by a program', () => {
    const program = `
import music, builtins, math, sys, microbit
def change(module, name):
    setattr(module, name, None)
def remove(module, name):
    delattr(module, name)
err(change, music, 'pitch')
err(change, music, 'mine')
err(remove, music, 'pitch')
err(change, builtins, 'abs')
err(change, math, 'pi')
err(change, sys, 'path')
err(change, microbit, 'sleep')
print(abs(-1), music.pitch, sys.path.append('x'))`;
    const lacks = (name: string): string => `AttributeError: 'module' object has no attribute '${name}'`;
    const names = ['pitch', 'mine', 'pitch', 'abs', 'pi', 'path', 'sleep'];
    expect(linesOf(program)).toEqual([...names.map(lacks), '1 <function> None']);
  });

  it('a module of one’s own can be changed', () => {
    expect(
      linesOf('import mine\nmine.x = 3\ndel mine.y\nprint(mine.x, hasattr(mine, "y"))', { 'mine.py': 'y = 2' }),
    ).toEqual(['3 False']);
  });

  it('is looked for with * in something that is no module: an ImportError', () => {
    const program = `
import sys
class Thing:
    x = 1
sys.modules['thing'] = Thing
try:
    from thing import *
except ImportError as e:
    print(e)`;
    expect(lastLineOf(program)).toBe("can't import name *");
  });
});
