import { describe, expect, it } from 'vitest';

import { checkForDevice } from './check-for-device';
import { explain } from './explain';
import { rules, type RuleId } from './rule-table';
import { de } from './texts/de';
import { en } from './texts/en';

const first = (program: string) =>
  checkForDevice({ 'main.py': program }, { features: [], micropython: [1, 18, 0] })[0]!;

describe('the explanation of a finding', () => {
  it('names the board, what is missing and the way out, in German and English', () => {
    const finding = first('print(f"{x:.1f} cm")');
    expect(explain(finding, 'micro:bit V2', 'de')).toBe(
      'Der micro:bit V2 kennt keine f-Strings. Schreib stattdessen "{:.1f} cm".format(x)',
    );
    expect(explain(finding, 'micro:bit V2', 'en')).toBe(
      'The micro:bit V2 does not know f-strings. Write this instead: "{:.1f} cm".format(x)',
    );
    expect(explain(first('x.splitlines()'), 'micro:bit V2', 'de')).toBe(
      'Texte haben auf dem micro:bit V2 kein splitlines(). Schreib stattdessen x.split("\\n")',
    );
  });

  it.each(Object.keys(rules) as RuleId[])('says something about %s that fits on two lines of a phone or so', (rule) => {
    for (const text of [de[rule], en[rule]]) {
      expect(text.length).toBeLessThan(200);
      expect(text).toContain(rule === 'newer-name' ? '{name}' : '{board}');
      expect(text).not.toMatch(/ß|\bSie\b/);
    }
  });
});
