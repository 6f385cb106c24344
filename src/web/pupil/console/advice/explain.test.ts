import { describe, expect, it } from 'vitest';

import { loadTexts, showLanguage, t } from '../../../kit/i18n';
import { explain, fetchAdvice } from './explain';

describe('what is told of an error', () => {
  const failure = { type: 'NameError', message: "name 'x' isn't defined" };
  const report = { failure, source: null, table: null };

  it('is that there was one, in the words of the device, and why as soon as that is fetched', async () => {
    expect(explain(report)).toEqual({ key: 'error.other', values: {}, device: "NameError: name 'x' isn't defined" });
    await fetchAdvice();
    const { key, values } = explain(report);
    expect(key).toBe('error.NameError');
    expect(t(key, values)).toContain('Den Namen x kennt das Programm nicht.');
    expect(t('error.other')).toBe('Das Programm ist wegen eines Fehlers zu Ende.');
  });

  it('comes in every language that is chosen later', async () => {
    await fetchAdvice();
    await loadTexts('en');
    showLanguage('en');
    expect(t('error.NameErrorAny')).toBe('The program does not know a name. Check its spelling.');
    expect(t('bar.run')).toBe('Simulate');
  });
});
