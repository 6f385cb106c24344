import { describe, expect, it } from 'vitest';

import { csvText, formWith, spreadsheetText, usualForm } from './csv';

const rows = [
  ['Name', 'Note', 'Zeit'],
  ['Ada; "die" Erste', 5.5, null],
  ['=1+1', -2.5, '12.5'],
] as const;

describe('a table as CSV', () => {
  it('has commas and points for programs, and no cell is a formula', () =>
    expect(csvText(rows)).toBe('Name,Note,Zeit\r\n"Ada; ""die"" Erste",5.5,\r\n\'=1+1,-2.5,12.5\r\n'));

  it.each(['de', 'fr', 'it'] as const)('has semicolons and decimal commas for a spreadsheet in %s', (language) =>
    expect(spreadsheetText(rows, usualForm(language))).toBe(
      '\ufeffName;Note;Zeit\r\n"Ada; ""die"" Erste";5,5;\r\n\'=1+1;-2,5;12.5\r\n',
    ),
  );

  it('has commas and points for a spreadsheet in English', () =>
    expect(spreadsheetText([['a', 0.25]], usualForm('en'))).toBe('\ufeffa,0.25\r\n'));

  it('has the decimal sign of the country, which never parts cells, too', () =>
    expect(
      [formWith('de', '.'), formWith('en', ','), formWith('en', '.')].map(({ sign, point }) => sign + point),
    ).toEqual([...[';.', ';,', ',.']]));
});
