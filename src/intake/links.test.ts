import { describe, expect, it } from 'vitest';
import { linksIn, linksInFile } from './links';

const LINK = 'https://parcours.example/app/#p=4.abcdef-_';

describe('the links in a text', () => {
  it('have the names that stand before them', () => {
    const mail = `Dear teacher\n\nAnna: ${LINK}\n- Ben – ${LINK}0.\nCem\n<${LINK}1>\nsee https://example.org/about\n`;
    expect(linksIn(mail)).toEqual([
      { name: 'Anna', address: LINK },
      { name: 'Ben', address: `${LINK}0` },
      { name: 'Cem', address: `${LINK}1` },
    ]);
  });

  it('may be several on a line, and without a name', () => {
    expect(linksIn(`Anna ${LINK}, Ben ${LINK}\n\n${LINK}`).map(({ name }) => name)).toEqual(['Anna', 'Ben', '']);
  });

  it('are none where an address leads elsewhere', () => {
    expect(linksIn('https://example.org/ #p= #p=x')).toEqual([]);
  });
});

describe('the links in a table', () => {
  it('are read behind a cell of many megabytes, and in a table whose quotes never end, in no time', () => {
    const long = `Name,Text,Link\nAda,"${'x""\n'.repeat(3_000_000)}",${LINK}\nBen,"",${LINK}0`;
    expect(linksInFile('long.csv', long)).toMatchObject([{ address: LINK }, { name: 'Ben', address: `${LINK}0` }]);
    const open = `Name,Link\n${'"""a\n'.repeat(200_000)}`;
    expect(linksInFile('open.csv', `Ada,${LINK}\n${open}`)).toEqual([{ name: 'Ada', address: LINK }]);
  });

  const named = (name: string, address = LINK) => ({ name, address });

  it('have the name that stands in the cell before them', () => {
    const answers = `"Timestamp","Name","Class","Link"\n"2026/11/20, 8:15","Anna ""Ann"" Weber","","${LINK}"\n"2026/11/20, 8:20","Ben","","${LINK}0"\n`;
    expect(linksInFile('answers.csv', answers)).toEqual([named('Anna "Ann" Weber'), named('Ben', `${LINK}0`)]);
  });

  it('are found with semicolons and tabs, without a last line end, and with a line end in a cell', () => {
    expect(linksInFile('a.csv', `Name;Link\r\nAnna;${LINK}`)).toEqual([named('Anna')]);
    expect(linksInFile('a.csv', `Name\tLink\nAnna\t"My link:\n${LINK}"\n`)).toEqual([named('Anna')]);
  });
});

describe('the links in a page', () => {
  it('are there once, whether their address is shown or a name', () => {
    const page = `<ul><li>Anna: <a class="x" href="${LINK}?a=1&amp;b=2">${LINK.slice(0, 20)}…</a></li><li><a href='${LINK}'>Ben</a></li></ul>`;
    expect(linksInFile('page.html', page).map(({ name }) => name)).toEqual(['Anna', 'Ben']);
  });
});

describe('a megabyte of anything', () => {
  // A pattern that looks at each sign again from each sign would not end within the time of a test.
  it.each(['<', '<a href=x>', '"', '" ', ' ', '.', '&', `${LINK}.`, `a,"`])('is read if it consists of %j', (piece) => {
    const much = piece.repeat(Math.ceil(1_000_000 / piece.length));
    for (const kind of ['a.txt', 'a.csv', 'a.html'])
      expect(linksInFile(kind, `${much}x\nAnna ${LINK}\n${much}${LINK}${much}x`)).toBeInstanceOf(Array);
  });
});

describe('the single link in a mail', () => {
  const nameAfter = (before: string): string | undefined =>
    linksInFile('a.eml', `From: Ida Sutter <ida@example.org>\n\n${before}: ${LINK}\n`)[0]?.name;

  it.each([
    ...[
      'Hier',
      'Hier ist mein Link',
      'Der Link',
      'Das ist mein Programm',
      'Anbei der Link',
      'Guten Tag, hier mein Link',
    ],
    ...[
      'Voici',
      'Voici mon lien',
      "C'est mon lien",
      'Ecco il link',
      'Questo è il mio programma',
      'The link',
      'My program',
    ],
  ])('is its sender’s after “%s:”', (before) => {
    expect(nameAfter(before)).toBe('Ida Sutter');
  });

  it.each(['Zoë', 'My Nguyen', 'Qui Tran', 'Mia Link', 'Dies Irae'])(
    'is that of %s, who is named before it',
    (name) => {
      expect(nameAfter(name)).toBe(name);
    },
  );
});
