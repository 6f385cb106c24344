import { describe, expect, it } from 'vitest';

import { spreadsheetForm } from './spreadsheet-form';

describe('a spreadsheet’s signs', () => {
  it.each([
    ['de', ['de-CH'], '; .'],
    ['de', ['en-US', 'de-DE'], '; ,'],
    ['it', ['it-CH', 'it'], '; .'],
    ['fr', ['fr-CH'], '; .'],
    ['fr', ['fr-FR'], '; ,'],
    ['fr', ['de-CH'], '; ,'],
    ['de', ['de'], '; ,'],
    ['en', ['en-GB'], ', .'],
    ['en', ['en-ZA'], '; ,'],
  ] as const)('in %s on a device of %j are %s', (language, tags, signs) => {
    const { sign, point } = spreadsheetForm(language, tags, 'Europe/Berlin');
    expect(`${sign} ${point}`).toBe(signs);
  });

  it.each([
    ['fr', ['fr', 'fr-FR'], '; .'],
    ['de', ['de'], '; .'],
    ['it', ['it-IT'], '; .'],
    ['en', ['en-US'], ', .'],
  ] as const)(
    'in %s have a point where the clock is Switzerland’s, whatever the browser says: %j',
    (language, tags, signs) => {
      const { sign, point } = spreadsheetForm(language, tags, 'Europe/Zurich');
      expect(`${sign} ${point}`).toBe(signs);
    },
  );
});
