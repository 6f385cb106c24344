import { describe, expect, it } from 'vitest';

import { spreadsheetForm } from './spreadsheet-form';

describe('a spreadsheet’s signs', () => {
  it.each([
    ['de', ['de-CH'], '; .'],
    ['de', ['en-US', 'de-DE'], '; ,'],
    ['it', ['it-CH', 'it'], '; .'],
    ['fr', ['fr-CH'], '; ,'],
    ['fr', ['de-CH'], '; ,'],
    ['de', ['de'], '; ,'],
    ['en', ['en-GB'], ', .'],
    ['en', ['en-ZA'], '; ,'],
  ] as const)('in %s on a device of %j are %s', (language, tags, signs) => {
    const { sign, point } = spreadsheetForm(language, tags);
    expect(`${sign} ${point}`).toBe(signs);
  });
});
