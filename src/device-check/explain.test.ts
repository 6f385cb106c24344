import { describe, expect, it } from 'vitest';

import type { Language } from '#core/languages';
import { mistakesIn } from '#reference/testing/catalogues';
import { checkForDevice } from './check-for-device';
import { explain } from './explain';
import { rules, type RuleId } from './rule-table';
import de from './words/de.json';
import en from './words/en.json';
import fr from './words/fr.json';
import italian from './words/it.json';
import { loadRuleTexts } from './rule-texts';

const first = (program: string) =>
  checkForDevice({ 'main.py': program }, { features: [], micropython: [1, 18, 0] })[0]!;

describe('the explanation of a finding', () => {
  it.each([
    ['de', 'Der micro:bit V2 kennt keine f-Strings. Schreib stattdessen "{:.1f} cm".format(x)'],
    ['fr', 'Le micro:bit V2 ne connaît pas les f-strings. Écris plutôt "{:.1f} cm".format(x)'],
    ['it', 'Il micro:bit V2 non conosce le f-string. Scrivi invece "{:.1f} cm".format(x)'],
    ['en', 'The micro:bit V2 does not know f-strings. Write this instead: "{:.1f} cm".format(x)'],
  ] satisfies [Language, string][])(
    'names the board, what is missing and the way out in %s',
    async (language, said) => {
      const texts = await loadRuleTexts(language);
      expect(explain(first('print(f"{x:.1f} cm")'), 'micro:bit V2', texts)).toBe(said);
    },
  );

  it('names what is written there', () => {
    expect(explain(first('x.splitlines()'), 'micro:bit V2', de)).toBe(
      'Texte haben auf dem micro:bit V2 kein splitlines(). Schreib stattdessen x.split("\\n")',
    );
  });

  it('says the same in German, French, Italian and English', () => {
    expect(mistakesIn({ de, fr, it: italian, en })).toEqual([]);
  });

  it.each(Object.keys(rules) as RuleId[])('says something about %s that fits on two lines of a phone or so', (rule) => {
    for (const text of [de[rule], fr[rule], italian[rule], en[rule]]) {
      expect(text.length).toBeLessThan(200);
      expect(text).toContain(rule === 'newer-name' ? '{name}' : '{board}');
      expect(text).not.toMatch(/\bSie\b|\b[Vv]ous\b|\bLei\b/);
    }
  });
});
