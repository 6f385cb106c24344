import { describe, expect, it } from 'vitest';

import { strictReport } from './strict';

const V212 = { features: [], micropython: [1, 18, 0] } as const;

describe('parcours run --strict', () => {
  const files = { 'main.py': 'import json\nx = 3\nprint(f"{x}")\ndef tidy(n): return round(n, -1)\n' };

  it('lists every place with file, line, column and a sentence, and counts those where the device stops', async () => {
    expect(await strictReport(files, 'micro:bit V2', V212, 'en')).toEqual({
      text:
        'main.py:1:8: There is no module json on the micro:bit V2. Perhaps this helps you: text.split(",")\n' +
        'main.py:3:7: The micro:bit V2 does not know f-strings. Write this instead: "{}".format(x)\n' +
        'main.py:4:21: hint: The micro:bit V2 cannot round a whole number to places. Make a decimal number of it first: round(float(n), -1)\n',
      count: 2,
      first: 'main.py:1:8: There is no module json on the micro:bit V2. Perhaps this helps you: text.split(",")',
      hints: 1,
    });
  });

  it.each([
    [
      'de',
      'Hinweis: Eine ganze Zahl kann der Calliope mini 3 nicht auf Stellen runden. Mach zuerst eine Kommazahl daraus: round(float(n), -1)',
    ],
    [
      'fr',
      'remarque\u202f: Le Calliope mini 3 ne sait pas arrondir un nombre entier à un nombre de chiffres. Fais-en d’abord un nombre à virgule\u202f: round(float(n), -1)',
    ],
    [
      'it',
      'avviso: Il Calliope mini 3 non sa arrotondare un numero intero a un numero di cifre. Prima fanne un numero con la virgola: round(float(n), -1)',
    ],
  ] as const)('speaks %s too', async (language, sentence) => {
    const { text } = await strictReport(
      { 'main.py': 'def tidy(n): return round(n, -1)' },
      'Calliope mini 3',
      V212,
      language,
    );
    expect(text).toBe(`main.py:1:21: ${sentence}\n`);
  });

  it('says nothing about a program that runs on the device', async () => {
    expect(await strictReport({ 'main.py': 'print("{}".format(3))' }, 'micro:bit V2', V212, 'en')).toEqual({
      text: '',
      count: 0,
      first: '',
      hints: 0,
    });
  });
});
