import { describe, expect, it } from 'vitest';

import { strictReport } from './strict';

const V212 = { features: [], micropython: [1, 18, 0] } as const;

describe('parcours run --strict', () => {
  const files = { 'main.py': 'import json\nx = 3\nprint(f"{x}")\npi = 3.14159265\n' };

  it('lists every place with file, line, column and a sentence, and counts those where the device stops', async () => {
    expect(await strictReport(files, 'micro:bit V2', V212, 'en')).toEqual({
      text:
        'main.py:1:8: There is no module json on the micro:bit V2. Perhaps this helps you: text.split(",")\n' +
        'main.py:3:7: The micro:bit V2 does not know f-strings. Write this instead: "{}".format(x)\n' +
        'main.py:4:6: hint: The micro:bit V2 calculates with about 7 digits. The last ones of 3.14159265 get lost.\n',
      count: 2,
      first: 'main.py:1:8: There is no module json on the micro:bit V2. Perhaps this helps you: text.split(",")',
      hints: 1,
    });
  });

  it.each([
    ['de', 'Hinweis: Der Calliope mini 3 rechnet mit etwa 7 Stellen. Von 1.23456789 gehen die hinteren verloren.'],
    [
      'fr',
      'remarque\u202f: Le Calliope mini 3 calcule avec environ 7 chiffres. Les derniers de 1.23456789 se perdent.',
    ],
    ['it', 'nota: Il Calliope mini 3 calcola con circa 7 cifre. Le ultime di 1.23456789 vanno perse.'],
  ] as const)('speaks %s too', async (language, sentence) => {
    const { text } = await strictReport({ 'main.py': 'x = 1.23456789' }, 'Calliope mini 3', V212, language);
    expect(text).toBe(`main.py:1:5: ${sentence}\n`);
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
