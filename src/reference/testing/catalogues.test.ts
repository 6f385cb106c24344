import { describe, expect, it } from 'vitest';

import { mistakesIn, type Catalogues } from './catalogues';

/** The same text in every language, good until one of them is changed. */
const good: Catalogues = {
  de: { wait: 'Wartet: sleep(1000) ist 1 Sekunde.' },
  fr: { wait: 'Attend\u202f: sleep(1000), c’est 1 seconde.' },
  it: { wait: 'Aspetta: sleep(1000) è 1 secondo.' },
  en: { wait: 'Waits: sleep(1000) is 1 second.' },
};

describe('the comparison of languages', () => {
  it('has nothing against texts that say the same', () => {
    expect(mistakesIn(good)).toEqual([]);
  });

  it('finds a text that is missing and one that is too many', () => {
    expect(mistakesIn({ ...good, it: { stop: 'Ferma.' } })).toEqual(['it: wait is missing', 'it: stop is too many']);
  });

  it('finds another number and another name', () => {
    expect(mistakesIn({ ...good, it: { wait: 'Aspetta: slip(100) è 1 secondo.' } })).toEqual([
      'it: wait: says “1 100 slip” where German says “1 1000 sleep”',
    ]);
  });

  it('finds a text that was not translated, unless the words are the same in both', () => {
    const same = {
      ...good,
      fr: { wait: 'Radio.' },
      de: { wait: 'Funk.' },
      it: { wait: 'Radio.' },
      en: { wait: 'Radio.' },
    };
    expect(mistakesIn(same)).toEqual(['fr: wait: is the English text', 'it: wait: is the English text']);
    expect(mistakesIn(same, ['wait'])).toEqual([]);
  });

  it.each([
    ['de', 'Grüße: sleep(1000), 1.', 'has an ß'],
    ['fr', 'Attend : sleep(1000), 1.', 'has a wide space before a sign'],
    ['fr', 'Attend: sleep(1000), 1.', 'lacks a narrow space'],
    ['it', 'Aspetta : sleep(1000), 1.', 'has a space before a sign'],
    ['it', "Aspetta un'ora: sleep(1000), 1.", 'has a straight apostrophe'],
    ['en', 'Waits:  sleep(1000), 1.', 'has a space too many'],
  ] as const)('finds signs that %s does not write: %s', (language, text, mistake) => {
    expect(mistakesIn({ ...good, [language]: { wait: text } })).toEqual([`${language}: wait: ${mistake}`]);
  });

  it('takes the quotes of Python for no apostrophe', () => {
    const python = (text: string): Catalogues => ({ ...good, fr: { wait: text }, de: { wait: "b'abc' und 'a'." } });
    expect(mistakesIn(python("b'abc' et 'a'.")).filter((mistake) => mistake.startsWith('fr'))).toEqual([]);
  });
});
