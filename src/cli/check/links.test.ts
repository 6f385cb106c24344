import { describe, expect, it } from 'vitest';
import { linksIn } from './links';

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
