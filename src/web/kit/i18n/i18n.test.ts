import { afterEach, describe, expect, it } from 'vitest';

import { loadTexts, preferredLanguage, showLanguage, t, type Language } from '.';

describe('the language of a first visit', () => {
  it('is the first of the browser that the app has', () => {
    expect(preferredLanguage(['fr-CH', 'de-CH'])).toBe('fr');
    expect(preferredLanguage(['pt-BR', 'it', 'en'])).toBe('it');
    expect(preferredLanguage(['en-US'])).toBe('en');
    expect(preferredLanguage(['DE'])).toBe('de');
  });

  it('is German for Swiss German, and where the app has none of the browser’s languages', () => {
    expect(preferredLanguage(['gsw-CH', 'fr-CH'])).toBe('de');
    expect(preferredLanguage(['rm-CH'])).toBe('de');
    expect(preferredLanguage([])).toBe('de');
  });

  it('is not mistaken for another whose tag begins alike: frr is North Frisian, den is Slavey', () => {
    expect(preferredLanguage(['frr', 'den', 'it'])).toBe('it');
  });
});

describe('a text with places for values', () => {
  const zoom = { de: '{cm} cm', fr: '{cm} cm', it: '{cm} cm', en: '{cm} cm' };

  afterEach(() => speak('de'));

  async function speak(language: Language): Promise<void> {
    await loadTexts(language);
    showLanguage(language);
  }

  it('writes numbers as the language does', async () => {
    await speak('fr');
    expect(t('arena.distanceCm', { cm: 2.5 })).toBe('2,5 cm');
    expect(t(zoom, { cm: 2.5 })).toBe('2,5 cm');
    await speak('de');
    expect(t('arena.distanceCm', { cm: 2.5 })).toBe('2.5 cm');
    expect(t(zoom, { cm: 2.5 })).toBe('2.5 cm');
  });

  it('leaves words as they are, and a place whose value is missing in sight', async () => {
    await speak('fr');
    expect(t('files.saved', { file: 'a.1.py' })).toBe('a.1.py est enregistré.');
    expect(t(zoom)).toBe('{cm} cm');
  });
});
