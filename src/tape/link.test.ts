import { describe, expect, it } from 'vitest';
import { isRunLink, readRunLink, runLinkOf } from './link';

const text = `{\n  "format": "parcours-tape", ${'"files": "forward()",'.repeat(50)} "name": "Zürich – 5 ✓"\n}\n`;
const link = runLinkOf(text, 12_340_000);

describe('a link to a run', () => {
  it('brings its file and its moment back, with the # and without', () => {
    expect(link).toMatch(/^r=1\.12340\.[\w-]+$/);
    expect(link.length).toBeLessThan(text.length / 4);
    for (const fragment of [link, `#${link}`, ` #${link}\n`])
      expect(readRunLink(fragment)).toEqual({ text, atUs: 12_340_000 });
    expect([isRunLink(`#${link}`), isRunLink('#p=2.abc')]).toEqual([true, false]);
  });

  it('is refused when a part of it is missing or changed, wherever', () => {
    for (let at = 0; at < link.length; at += 1) {
      const cut = readRunLink(link.slice(0, at));
      expect(cut).toEqual({ fault: 'damaged' });
    }
    const changed = link.slice(0, 60) + (link[60] === 'A' ? 'B' : 'A') + link.slice(61);
    expect(readRunLink(changed)).toEqual({ fault: 'damaged' });
  });

  it('says so if it is of a newer version', () => {
    expect(readRunLink('r=2.of-another-form')).toEqual({ fault: 'newer' });
  });

  it('unpacks to no more than 4 MB', () => {
    expect(readRunLink(runLinkOf(' '.repeat(6_000_000), 0))).toEqual({ fault: 'damaged' });
  });
});
