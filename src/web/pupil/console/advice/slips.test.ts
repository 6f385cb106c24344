import { describe, expect, it } from 'vitest';

import { adviceWords } from '#advice/say';
import type { AdviceTexts } from '#advice/text';
import { inEvery } from '#core/words';
import { play } from '#vm/library/testing/play';
import { filled } from '../../../kit/i18n/filled';
import type { Language } from '../../../kit/i18n';
import { lastPlace } from '../log/console-log';
import { adviceFor, type Advice } from './error-advice';

const catalogues: Readonly<Record<Language, Readonly<Record<string, string>>>> = inEvery((language) =>
  Object.fromEntries(Object.entries(adviceWords).map(([name, texts]) => [name, texts[language]])),
);

function failureOf(program: string) {
  return play(program).until(3_000).ended()?.exception ?? null;
}

/** Runs a program on our VM and gives what the page says about its error. */
function adviceOf(program: string): Advice {
  const exception = failureOf(program);
  if (exception === null) throw new Error(`No error in: ${program}`);
  const line = lastPlace(exception.traceback, ['main.py'])?.line ?? 1;
  return adviceFor(exception, { text: program, line });
}

const USING = 'from microbit import *\n';

/** A slip, what explains it, and where a button mends it: what the program has become in that line. */
type Row = readonly [program: string, key: keyof AdviceTexts, code?: string];

const rows: readonly Row[] = [
  ['repeat 4:\n    print(1)', 'repeat', 'for i in range(4):'],
  ['repeat(4):\n    print(1)', 'repeat', 'for i in range(4):'],
  ['repeat 4\n    print(1)', 'repeat', 'for i in range(4):'],
  ['repeat 4: print(1)', 'repeat', 'for i in range(4):'],
  ['i = 2\nrepeat i + 1:  # so oft\n    print(i)', 'repeat', 'for j in range(i + 1):'],
  ['def f():\n    repeat 3:\n        print(1)\nf()', 'repeat', 'for i in range(3):'],
  ['repeat:\n    print(1)\n    break', 'repeat', 'while True:'],
  ['if 1 > 2:\n    pass\nelse if 2 > 1:\n    pass', 'elseIf', 'elif 2 > 1:'],
  ['if 1 > 2:\n    pass\nelseif 2 > 1:\n    pass', 'elseIf', 'elif 2 > 1:'],
  ['if 1:\n    pass\nelse 2 > 1:\n    pass', 'elseCondition', 'elif 2 > 1:'],
  ['if 1 > 3: print(1) else: print(2)', 'elseSameLine'],
  ['if 1 > 2 then:\n    pass', 'wordTooMuch', 'if 1 > 2:'],
  ['while 3 < 2 do:\n    pass', 'wordTooMuch', 'while 3 < 2:'],
  ['While False:\n    pass', 'keywordSmall', 'while False:'],
  ['If 1 > 0:\n    pass', 'keywordSmall', 'if 1 > 0:'],
  ['From microbit import *', 'keywordSmall', 'from microbit import *'],
  ['Def f():\n    pass', 'keywordSmall', 'def f():'],
  ['Print("a")', 'keywordSmall', 'print("a")'],
  ['PRINT("a")', 'keywordSmall', 'print("a")'],
  ['for i in range 4:\n    print(i)', 'rangeBrackets', 'for i in range(4):'],
  ['for i range(3):\n    pass', 'forForm'],
  ['for i of range(3):\n    pass', 'forForm'],
  ['for i = 1 to 10:\n    print(i)', 'forForm'],
  ['for 4:\n    print(1)', 'forForm'],
  ['x = 3\nif x > 2,5:\n    pass', 'decimalComma', 'if x > 2.5:'],
  ['x = 3\nwhile x < 0,25:\n    pass', 'decimalComma', 'while x < 0.25:'],
  ['x = 3\nif x => 2:\n    pass', 'compareSign', 'if x >= 2:'],
  ['x = 3\nif x =< 2:\n    pass', 'compareSign', 'if x <= 2:'],
  ['x = 3\nif x =! 2:\n    pass', 'compareSign', 'if x != 2:'],
  ['x = 3\nif x <> 2:\n    pass', 'compareSign', 'if x != 2:'],
  ['x = 3\nif x > 2 and < 5:\n    pass', 'compareAgain'],
  ['x = 3\nif x == 1 or == 2:\n    pass', 'compareAgain'],
  ['x = 3\nx++', 'countStep', 'x += 1'],
  ['x = 3\nx--', 'countStep', 'x -= 1'],
  ['if 1 && 2:\n    pass', 'wordForSign', 'if 1 and 2:'],
  ['if 1 || 2:\n    pass', 'wordForSign', 'if 1 or 2:'],
  ['if !True:\n    pass', 'wordForSign', 'if not True:'],
  ['x := 3', 'assignSign', 'x = 3'],
  ['x == 3\nprint(x)', 'assignOnce', 'x = 3'],
  ['var x = 3', 'noDeclaration', 'x = 3'],
  ['let x = 3', 'noDeclaration', 'x = 3'],
  ['int x = 3', 'noDeclaration', 'x = 3'],
  ['int x', 'noDeclaration'],
  ['function f():\n    pass', 'defWord', 'def f():'],
  ['func f():\n    pass', 'defWord', 'def f():'],
  ['define f():\n    pass', 'defWord', 'def f():'],
  ['def f:\n    pass', 'defBrackets', 'def f():'],
  ['def 3f():\n    pass', 'nameDigit'],
  ['def f(1):\n    pass', 'defValues'],
  ['x = 3\nif x > 2 {\n    print(x)\n}', 'braces'],
  ['// Kommentar', 'commentSign', '# Kommentar'],
  ["// it's so", 'commentSign', "# it's so"],
  ['/* a */', 'commentSign', '# a */'],
  ['x = 5 – 3', 'typedSign', 'x = 5 - 3'],
  ['x = 5 − 3', 'typedSign', 'x = 5 - 3'],
  ['x = 3 × 4', 'typedSign', 'x = 3 * 4'],
  ['x = 6 ÷ 2', 'typedSign', 'x = 6 / 2'],
  ['if 3 ≥ 2:\n    pass', 'typedSign', 'if 3 >= 2:'],
  ['print（1）', 'typedSign', 'print(1)'],
  ['if\u00a0True:\n    pass', 'hiddenSign', 'if True:'],
  ['print(1)\u200b', 'hiddenSign', 'print(1)'],
  ['print(„Hallo“)', 'curlyQuotes', 'print("Hallo")'],
  ['x = „Hallo“', 'curlyQuotes', 'x = "Hallo"'],
  ['print("Hallo“)', 'curlyQuotes', 'print("Hallo")'],
  ['print(«Bonjour»)', 'curlyQuotes', 'print("Bonjour")'],
  ['import * from microbit', 'importForm', 'from microbit import *'],
  ['import microbit *', 'importForm', 'from microbit import *'],
  ['from microbit', 'importForm', 'from microbit import *'],
  ['from microbit import', 'importForm', 'from microbit import *'],
  ['include microbit', 'importForm', 'from microbit import *'],
  ['from microbit import display.show', 'importDot'],
  ['if 1:\n    pass\nend if', 'endWord'],
  ['wenn 3 > 2:\n    pass', 'otherWord'],
  ['forever:\n    pass', 'otherWord'],
  ['until 3 > 2:\n    pass', 'otherWord'],
  ['switch 3:\n    pass', 'otherWord'],
  ['print "a"', 'printBrackets', 'print("a")'],
  ['x = 3\nprint x', 'printBrackets', 'print(x)'],
  [`${USING}display show("a")`, 'missingDot', 'display.show("a")'],
  [`${USING}sleep 1`, 'callBrackets', 'sleep(1)'],
  [`${USING}display.show "a"`, 'callBrackets', 'display.show("a")'],
  [`${USING}display.show{"a"}`, 'roundBrackets'],
  ['mein name = 3', 'nameSpace'],
  ['{"a" = 1}', 'dictColon'],
  ['{"a" 1}', 'dictColon'],
  ['print(1) print(2)', 'twoCommands'],
  ['x = ', 'unfinishedAbove'],
  ['x = 3 +', 'unfinishedAbove'],
  ['x = [3, +]', 'SyntaxError'],
  ['x = 3€', 'strangeSign'],
  ['x = [1 2 3]', 'missingComma'],
  ['print("Zahl" 3)', 'missingComma'],
  ['max(1 2)', 'missingComma'],
  ['print("a"]', 'mixedBrackets'],
  ['x = [1, 2)', 'mixedBrackets'],
  ['x = 1\ny = """abc\nz = 2', 'openLongText'],
  ['for i in range(3)\n    print(i)', 'missingColonAbove', 'for i in range(3):'],
  ['for i in range(3);\n    print(i)', 'missingColon', 'for i in range(3):'],
  ['x = true', 'truthWord', 'x = True'],
  ['x = null', 'truthWord', 'x = None'],
  ['x = FALSE', 'truthWord', 'x = False'],
  ['x = wahr', 'truthWord', 'x = True'],
  ['exit()', 'noExit'],
  ['print(Hallo)', 'textOrName'],
  [`${USING}display.show(A)`, 'textOrName'],
  ['import turtle', 'moduleOfComputer'],
  ['import numpy as np', 'moduleOfComputer'],
  ['import matplotlib.pyplot as plt', 'moduleOfComputer'],
  ['from gturtle import *', 'moduleOfComputer'],
  ['x = [1]\nx.add(2)', 'listAppend'],
  ['x = "abc"\nx.length()', 'useLen'],
  ['x = "a"\nx.append("b")', 'noAppend'],
  [`${USING}x = temperature + 1`, 'callForgotten'],
  [`${USING}if accelerometer.get_x > 3:\n    pass`, 'callForgotten'],
  ['if "3" > 2:\n    pass', 'compareTextNumber'],
  ['x = "3"\nprint(x - 1)', 'textReckon'],
  ['x = 3,5\nprint(x + 1)', 'commaNumber'],
  ['raise "a"', 'raiseText'],
  ['raise', 'raiseAlone'],
];

describe('a slip', () => {
  it.each(rows.map(([program, key, code]) => ({ program, key, code })))(
    'is $key for $program',
    ({ program, key, code }) => {
      const { key: found, values, mend } = adviceOf(program);
      expect({ key: found, code: mend?.code }).toEqual({ key: `error.${key}`, code });
      for (const [language, texts] of Object.entries(catalogues) as [Language, Readonly<Record<string, string>>][]) {
        const sentence = filled(texts[key] ?? '', values, language);
        expect(sentence).not.toMatch(/^$|\{\w+\}|undefined/);
      }
      if (mend === undefined) return;
      expect(mend.before).toBe(program);
      expect(failureOf(mend.after)?.type ?? '').not.toBe('SyntaxError');
    },
  );
});

describe('loops of TigerJython', () => {
  const mended = (program: string): string | undefined => adviceOf(program).mend?.after;

  it('are rewritten all at once, those within others with another name', () => {
    expect(mended('repeat 4:\n    repeat 2:\n        print(1)\nrepeat 3:\n    print(2)')).toBe(
      'for i in range(4):\n    for j in range(2):\n        print(1)\nfor i in range(3):\n    print(2)',
    );
  });

  it('take no name that the program has', () => {
    expect(mended('i = 1\nj = 2\nrepeat 4:\n    print(i, j)')).toContain('for k in range(4):');
  });

  it('are not looked for in texts and comments', () => {
    expect(mended('# repeat 4:\nx = """\nrepeat 4:\n"""\nrepeat 2:\n    print(x)')).toBe(
      '# repeat 4:\nx = """\nrepeat 4:\n"""\nfor i in range(2):\n    print(x)',
    );
  });

  it('stay unexplained where something of one’s own is called repeat', () => {
    expect(adviceOf('def repeat(n):\n    pass\nrepeat(4) x').key).not.toBe('error.repeat');
  });
});

describe('no slip', () => {
  it.each([
    ['x = (1 if 2 else 3', 'error.openBracket'],
    ['print("a" "b", f"x" 3', 'error.openBracket'],
    ['sleep = [\n1\nrepeat = 4', 'error.openBracket'],
    ['pass 3', 'error.SyntaxError'],
  ])('is guessed for %j', (program, key) => expect(adviceOf(program).key).toBe(key));
});
