import { describe, expect, it } from 'vitest';

import type { AtTable } from '#advice/at-table';
import { adviceWords } from '#advice/say';
import { robotTypes } from '#robots/index';
import { play } from '#vm/library/testing/play';
import de from '../../../kit/words/de.json';
import en from '../../../kit/words/en.json';
import type { TextKey } from '../../../kit/i18n/texts';
import { lastPlace } from '../log/console-log';
import { adviceFor, type Advice } from './error-advice';

/** Runs a program with a mistake on our VM and gives what the page says about it. */
function adviceOf(program: string): Advice {
  const run = play(program).until(30_000);
  const exception = run.ended()?.exception;
  if (exception === null || exception === undefined) throw new Error(`No error in: ${program}`);
  const line = lastPlace(exception.traceback, ['main.py'])?.line ?? 1;
  return adviceFor(exception, { text: program, line });
}

const said = (language: 'de' | 'en') =>
  Object.fromEntries(Object.entries(adviceWords).map(([name, texts]) => [name, texts[language]]));
const catalogues: Readonly<Record<'de' | 'en', Readonly<Record<string, string>>>> = {
  de: { ...de.error, ...said('de') },
  en: { ...en.error, ...said('en') },
};

/** The sentence that the page shows. */
function sentence({ key, values }: Advice, language: 'de' | 'en' = 'de'): string {
  const text = catalogues[language][key.slice('error.'.length)] ?? '';
  return text.replace(/\{(\w+)\}/g, (_whole, value: string) => String(values[value] ?? `{${value}}`));
}

const USING = 'from microbit import *\n';

type Mistake = readonly [key: TextKey, program: string, shown?: Readonly<Record<string, string>>];

/** Mistakes by what they are explained with. Whatever the device says about them is what our VM says here. */
const mistakes: readonly Mistake[] = [
  ['error.NameError', 'x = irLinks', { name: 'irLinks' }],
  ['error.nameOfModule', 'radio.on()', { name: 'radio' }],
  ['error.nameOfModule', 'time.sleep(1)', { name: 'time' }],
  ['error.truthWord', 'x = true'],
  ['error.localUnbound', 'n = 1\ndef f():\n    n += 1\nf()'],
  ['error.curlyQuotes', 'print(“hallo”)'],

  ['error.AttributeError', `${USING}display.sow("a")`, { owner: 'Display', name: 'sow' }],
  ['error.AttributeError', `${USING}display.show(Image.HAERT)`, { owner: 'Image', name: 'HAERT' }],
  ['error.AttributeError', '"a".push("b")', { owner: 'str', name: 'push' }],
  ['error.attributeOfModule', 'import music\nmusic.plai(1)', { name: 'plai' }],
  ['error.attributeOfNone', 'x = print("a")\nx.upper()', { name: 'upper' }],

  ['error.ImportError', 'import mbrobbot', { name: 'mbrobbot' }],
  ['error.driverMissing', 'import maqueenPlusV2', { robot: 'Maqueen Plus V2', module: 'mbrobot_plusV2' }],
  ['error.driverMissing', 'from mbrobot_plusv2 import *', { module: 'mbrobot_plusV2' }],
  ['error.robotNotSimulated', 'from mbminibit import *', { name: 'mbminibit', of: '4tronix minibit' }],
  ['error.robotNotSimulated', 'import MiniBit', { of: '4tronix minibit' }],
  ['error.robotUnknown', 'from mbrobot_plusV9 import *', { name: 'mbrobot_plusV9' }],
  [
    'error.makeCodeRobot',
    'maqueenPlusV2.i2c_init()\nradio.set_group(37)',
    { name: 'maqueenPlusV2', robot: 'Maqueen Plus V2' },
  ],
  [
    'error.makeCodeRobot',
    'matrixLidarDistance.get_data()\nmaqueen.motor_stop(1)',
    { name: 'matrixLidarDistance', robot: 'Maqueen Lite' },
  ],
  ['error.robotNotSimulated', 'CutebotPro.pwm_cruise_control(0, 0)\nbasic.pause(50)', { of: 'Cutebot Pro' }],
  ['error.makeCode', 'def on_forever():\n    basic.show_string("A")\non_forever()', { name: 'basic' }],
  ['error.makeCode', 'input.on_button_pressed(1, 2)', { name: 'input' }],
  ['error.makeCode', 'radio.set_group(1)\nbasic.pause(50)', { name: 'radio' }],
  ['error.NameError', 'led.on()', { name: 'led' }],
  ['error.moduleOfCalliope', 'from calliopemini import *', { name: 'calliopemini' }],
  ['error.importName', 'from microbit import knopf_a', { name: 'knopf_a' }],

  ['error.addTextNumber', 'print("Punkte: " + 3)'],
  ['error.addTextNumber', 'print(3 + "Punkte")'],
  ['error.addTextNumber', 'n = 3\ntext = "Punkte: "\ntext += n'],
  ['error.textReckon', 'print("3" - 1)'],
  ['error.compareTextNumber', 'if "3" > 2: pass'],
  ['error.callForgotten', 'print("a" + len)'],
  ['error.operandTypes', 'print("a" + [1])', { left: 'str', right: 'list' }],
  ['error.operandNone', 'print("a" + None)'],
  ['error.operandNone', 'x = print()\nprint(x * 2)'],
  ['error.operandNone', `${USING}sleep(None)`],
  ['error.compareTypes', 'if "3" < [4]: pass', { left: 'str', right: 'list' }],
  ['error.operandTypes', 'print([1] - [2])', { left: 'list', right: 'list' }],
  ['error.operandType', 'print(-"a")', { type: 'str' }],
  ['error.unhashable', 'd = {[1]: 2}', { type: 'list' }],
  ['error.notCallable', 'n = 3\nn()', { type: 'int' }],
  ['error.moduleNotCallable', 'import music\nmusic()'],
  ['error.wholeNotIterable', 'for i in 10:\n    print(i)'],
  ['error.notIterable', 'for i in None:\n    print(i)', { type: 'NoneType' }],
  ['error.functionSubscript', 'def f(): pass\nf[0]'],
  ['error.notSubscriptable', 'x = 3\nprint(x[0])', { type: 'int' }],
  ['error.fixedType', 'x = "abc"\nx[0] = "d"', { type: 'str' }],
  ['error.noLength', 'len(3)', { type: 'int' }],
  ['error.indexType', 'a = [1, 2]\nprint(a[0.5])'],
  ['error.argumentCount', 'def f(a): pass\nf(1, 2)', { name: 'f', expected: '1', given: '2' }],
  ['error.argumentCount', 'len()', { name: 'len', expected: '1', given: '0' }],
  ['error.argumentCountAny', 'print(len(), abs(-1))', { expected: '1', given: '0' }],
  ['error.argumentRequired', `${USING}display.show()`, { name: 'image' }],
  ['error.keywordExtra', `${USING}display.show("a", warten=True)`],
  ['error.argumentMissing', `${USING}display.show("a", 400, 3)`],
  ['error.argumentMissing', '"abc".find()'],
  ['error.keywordUnknown', 'def f(a): pass\nf(b=3)', { name: 'b' }],
  ['error.keywordNone', 'len(x=3)'],
  ['error.argumentTwice', 'def f(a): pass\nf(1, a=2)', { name: 'a' }],
  ['error.textNotNumber', '"a,b".split(3)'],
  ['error.textNeeded', '"a,b".split([3])', { type: 'list' }],
  ['error.numberNotText', `${USING}sleep("lang")`],
  ['error.numberWhole', `${USING}display.set_pixel(0.5, 1, 9)`],
  ['error.numberNeeded', `${USING}sleep([1])`, { type: 'list' }],
  ['error.commaNumber', `${USING}pause = 0,5\nsleep(pause)`],
  ['error.imageFixed', `${USING}Image.HEART.set_pixel(0, 0, 9)`],
  ['error.formatCount', 'print("%d %d" % 3)'],
  ['error.oneCharacter', 'ord("ab")'],
  ['error.bytesNeeded', `${USING}uart.write(3)`],

  ['error.wholeOfText', 'int("3.5")', { text: '3.5' }],
  ['error.wholeOfText', 'int("zwölf")', { text: 'zwölf' }],
  ['error.wholeOfNothing', 'int("")'],
  ['error.wholeOfUnknown', 'x = "3.5"\nint(x)'],
  ['error.numberOfText', 'float("3,5")'],
  ['error.unpackMany', 'a, b = 1, 2, 3', { expected: '2' }],
  ['error.unpackFew', 'a, b = [1]'],
  ['error.pinOfDisplay', `${USING}pin3.write_digital(1)`, { pin: '3' }],
  ['error.pixelIndex', `${USING}display.set_pixel(5, 0, 9)`],
  ['error.brightness', `${USING}display.set_pixel(0, 0, 10)`],
  ['error.valueRange', `${USING}pin0.write_analog(2000)`, { least: '0', most: '1023' }],
  ['error.valueBit', `${USING}pin0.write_digital(2)`],
  ['error.argumentRange', 'import radio\nradio.config(group=300)', { name: 'group' }],
  ['error.keywordUnknown', 'import radio\nradio.config(grupp=3)', { name: 'grupp' }],
  ['error.gesture', `${USING}accelerometer.is_gesture("shak")`],
  ['error.radioOff', 'import radio\nradio.off()\nradio.send("a")'],
  ['error.spiOff', `${USING}spi.write(b"a")`],
  ['error.textNotFound', '"abc".index("z")'],
  ['error.notInList', '[1].remove(5)'],
  ['error.mathDomain', 'import math\nmath.sqrt(-1)'],
  ['error.emptySequence', 'max([])'],
  ['error.fileClosed', 'f = open("a", "w")\nf.close()\nf.write("a")'],
  ['error.imageText', `${USING}Image("abc")`],
  ['error.ValueError', 'raise ValueError("eigener Grund")'],

  ['error.IndexError', '[1, 2][5]'],
  ['error.popEmpty', '[].pop()'],
  ['error.KeyError', '{"a": 1}["b"]', { name: 'b' }],
  ['error.ZeroDivisionError', '1 // 0'],
  ['error.noDevice', `${USING}i2c.write(0x55, b"a")`],
  ['error.noFile', 'open("nix.txt")'],
  ['error.boardFull', 'f = open("a.txt", "w")\nwhile True:\n    f.write("x" * 1000)'],
  ['error.memoryAtOnce', 'bytearray(200000)', { bytes: '200000' }],
  ['error.MemoryError', 'x = []\nwhile True:\n    x.append(["abcdefgh"])'],
  ['error.recursion', 'def f(): f()\nf()'],
  ['error.AssertionError', 'assert 1 == 2'],
  ['error.StopIteration', 'next(iter([]))'],
  ['error.UnicodeError', 'b"\\xff".decode()'],
  ['error.OverflowError', 'int(float("inf"))'],
  ['error.KeyboardInterrupt', 'raise KeyboardInterrupt'],
  ['error.other', 'class MeinFehler(Exception): pass\nraise MeinFehler("oh")'],

  ['error.missingColonAbove', 'x = 3\nif x > 2\n\n    print(x)', { word: 'if', line: '2' }],
  ['error.missingColonAbove', 'def f(a, b)\n    pass', { word: 'def', line: '1' }],
  ['error.missingColonAbove', 'x = 3\nif x > 2', { word: 'if', line: '2' }],
  ['error.unfinishedAbove', 'x = 3 +\n# next\nprint(x)', { line: '1' }],
  ['error.missingColon', 'while True print(1)', { word: 'while' }],
  ['error.equalsInCondition', 'x = 3\nif x = 3:\n    print(x)'],
  ['error.openBracket', 'print(1\n', { bracket: '(', line: '1' }],
  ['error.openBracket', `${USING}while True:\n    sleep(10\n    display.clear()`, { bracket: '(', line: '3' }],
  ['error.openBracket', 'x = [1, 2\ny = 3\nprint(y)', { bracket: '[', line: '1' }],
  ['error.missingComma', 'd = {\n    "a": 1\n    "b": 2\n}\nprint(d)'],
  ['error.extraBracket', 'print("a"))', { bracket: ')' }],
  ['error.openQuote', 'print("hallo)', { line: '1' }],
  ['error.openQuote', "print('it's')"],
  ['error.curlyQuotes', 'x = 3\nprint(“guten Tag”)'],
  ['error.printBrackets', 'print "hallo"'],
  ['error.keywordAsName', 'class = 3', { name: 'class' }],
  ['error.keywordAsName', 'def for(): pass', { name: 'for' }],
  ['error.countStep', 'x = 3\nx++', { sign: '++' }],
  ['error.wordForSign', 'if 1 && 2:\n    pass', { sign: '&&' }],
  ['error.indentMissing', 'for i in range(3):\nprint(i)'],
  ['error.indentMissing', 'if True:\n\n# so\nprint(1)'],
  ['error.elseAlone', 'x = 3\nelse:\n    pass', { word: 'else' }],
  ['error.tryAlone', 'try:\n    x = 1\nprint(x)'],
  ['error.strangeSign', 'x = 5 § 3'],
  ['error.indentUnexpected', 'x = 3\n    y = 4'],
  ['error.indentMismatch', 'if True:\n    print(1)\n  print(2)'],
  ['error.returnOutside', 'return 3'],
  ['error.breakOutside', 'break'],
  ['error.assignTarget', '3 = x'],
  ['error.argumentReused', 'def f(a, a): pass'],
  ['error.globalLate', 'def f(x):\n    global x', { word: 'global' }],
  ['error.nonlocalUnknown', 'def f():\n    nonlocal x'],
  ['error.digitFirst', '1abc = 3'],
  ['error.starPlace', 'x = [*[1], 2]'],
  ['error.machineCode', 'import micropython\n@micropython.native\ndef f(): pass'],
];

describe('advice for an error that a program makes', () => {
  const cases = mistakes.map(([key, program, shown = {}]) => ({ key, program, shown }));

  it.each(cases)('is $key for $program', ({ key, program, shown }) => {
    const advice = adviceOf(program);
    expect({ key: advice.key, device: advice.device }).toEqual({ key, device: advice.device });
    const values = Object.fromEntries(Object.entries(advice.values).map(([name, value]) => [name, String(value)]));
    expect(values).toMatchObject(shown);
    for (const language of ['de', 'en'] as const) expect(sentence(advice, language)).not.toMatch(/[{]\w+[}]|undefined/);
  });
});

describe('advice', () => {
  it('keeps the device’s own words', () => {
    expect(adviceFor({ type: 'NameError', message: "name 'irLinks' isn't defined" })).toEqual({
      key: 'error.NameError',
      values: { name: 'irLinks' },
      device: "NameError: name 'irLinks' isn't defined",
    });
    expect(adviceFor({ type: 'PupilError', message: '' }).device).toBe('PupilError');
  });

  it('reads like this', () => {
    expect(sentence(adviceOf('print("Punkte: " + 3)'))).toBe(
      'Text und Zahl lassen sich nicht mit + verbinden. Mach mit str(…) einen Text aus der Zahl oder mit int(…) eine Zahl aus dem Text.',
    );
    expect(sentence(adviceOf('if 3 > 2\n    pass'), 'en')).toBe(
      'In line 1, a colon (:) is missing at the end, after if. The microcomputer only notices it further down.',
    );
  });

  it('understands the words of newer MicroPython too', () => {
    const key = (type: string, message: string): TextKey => adviceFor({ type, message }).key;
    expect(key('AttributeError', "module 'music' has no attribute 'plai'")).toBe('error.attributeOfModule');
    expect(key('ImportError', 'can\'t import name "x"')).toBe('error.ImportErrorAny');
    expect(key('OSError', '19')).toBe('error.noDevice');
    expect(key('TypeError', "'int' object is not callable")).toBe('error.notCallable');
    expect(key('RuntimeError', 'Please connect to Maqueen robot and switch it on.')).toBe('error.noRobot');
    expect(key('RuntimeError', 'pystack exhausted')).toBe('error.recursion');
    expect(key('TypeError', 'function missing 1 required positional arguments')).toBe('error.argumentMissing');
    expect(key('NotImplementedError', 'reading machine.mem32[0x00000000] is not simulated')).toBe('error.notSimulated');
    expect(key('NotImplementedError', '')).toBe('error.NotImplementedError');
  });

  it('explains the values that the robots’ libraries refuse', () => {
    const says = (type: string, message: string, language: 'de' | 'en' = 'de'): string =>
      sentence(adviceFor({ type, message }), language);
    expect(says('ValueError', 'Invalid angle. Must be between 0 and 180')).toBe(
      'Der Winkel muss zwischen 0 und 180 Grad liegen.',
    );
    expect(says('ValueError', 'invalid RGB-LED position. Must be 0,1,2 or 3.')).toBe(
      'Dieses Farblicht gibt es nicht. Es gibt 0,1,2 und 3.',
    );
    expect(says('ValueError', "Unknown Servo. Please use 'S1' or 'S2'.")).toBe(
      "Diesen Servo-Anschluss gibt es nicht. Es gibt 'S1' und 'S2'.",
    );
    expect(says('ValueError', "Unknown Servo. Please use 'P0', 'P1' or 'P2'.", 'en')).toBe(
      "There is no such servo port. There are 'P0', 'P1' and 'P2'.",
    );
    expect(says('RuntimeError', 'percent must be from 0 to 100, not 120')).toBe(
      'Der Wert muss zwischen 0 und 100 liegen.',
    );
  });

  it('names every robot that there is, whatever their number, where one is not', () => {
    const { values } = adviceOf('from mbthetabot import *');
    expect(values['robots']).toBe(robotTypes.map(({ name }) => name).join(', '));
  });

  it('shortens what does not fit into a sentence', () => {
    const { values } = adviceFor({ type: 'KeyError', message: 'x'.repeat(500) });
    expect(String(values['name'])).toHaveLength(41);
  });

  it('says that the program is too long where the board has no room for its text', () => {
    const traceback =
      'MemoryError: …\nmain.py: the program is too long for the board. It has 65800 characters; about 20000 fit.\n';
    expect(adviceFor({ type: 'MemoryError', message: '', traceback }).key).toBe('error.tooLong');
    expect(adviceFor({ type: 'MemoryError', message: '', traceback: 'MemoryError: \n' }).key).toBe('error.MemoryError');
  });

  it('names what is missing at the end of the line itself where the device names that line, as MicroPython 1.23 does', () => {
    const advice = (text: string) => adviceFor({ type: 'SyntaxError', message: 'invalid syntax' }, { text, line: 1 });
    expect(advice('if x > 2\n    print(x)').key).toBe('error.missingColon');
    expect(advice('x =\ny = 3').key).toBe('error.valueMissing');
  });

  it('says the general thing about "invalid syntax" when the line is not known', () => {
    expect(adviceFor({ type: 'SyntaxError', message: 'invalid syntax' }).key).toBe('error.SyntaxError');
  });
});

describe('advice for a robot that does not answer', () => {
  const silent = { type: 'RuntimeError', message: 'Please connect to Maqueen robot and switch it on.' };
  const anyRobot = { type: 'RuntimeError', message: 'Please connect to a robot and switch it on.' };
  const noDevice = { type: 'OSError', message: '[Errno 19] ENODEV' };
  const fault = { key: 'error.otherRobot', values: { meant: 'Maqueen Lite', robot: 'Calli:bot' } } as const;
  const at = (failure: typeof silent, table: AtTable) => sentence(adviceFor(failure, null, table));

  it('names the robot that is chosen and the one that the program is for', () => {
    for (const failure of [silent, anyRobot, noDevice])
      expect(at(failure, { robot: 'Calli:bot', fault })).toBe(
        'Dieses Programm ist für den Maqueen Lite, gewählt ist der Calli:bot. Wähle den Maqueen Lite unter Gerät.',
      );
  });

  it('asks for a robot only where none is chosen', () => {
    expect(at(silent, { robot: null, fault: null })).toContain('braucht einen Roboter');
    expect(at(noDevice, { robot: null, fault: null })).toContain('Braucht das Programm einen Roboter?');
    expect(at(anyRobot, { robot: 'Calli:bot', fault: null })).toContain(
      'Der Calli:bot antwortet diesem Programm nicht.',
    );
  });

  it('speaks of the address and of i2c.scan() where a fitting robot is there', () => {
    expect(at(noDevice, { robot: 'Calli:bot', fault: null })).toBe(
      'Unter dieser Adresse antwortet nichts am I2C-Bus. i2c.scan() gibt die Adressen, die antworten.',
    );
  });

  it('leaves every other error as it is', () => {
    expect(adviceFor({ type: 'ZeroDivisionError', message: '' }, null, { robot: 'Calli:bot', fault }).key).toBe(
      'error.ZeroDivisionError',
    );
  });
});
