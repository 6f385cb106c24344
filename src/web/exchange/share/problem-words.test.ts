import { beforeAll, describe, expect, it } from 'vitest';

import { documentOfText } from '#intake/text';
import { projectOfLink } from '#project/link/link';
import { programOfLink } from '#project/webtigerpython/program-link';

import { LANGUAGES, showLanguage, type Language } from '../../kit/i18n';
import { linkReason, reasonOf } from './problem-words';

const header = { format: 'parcours-project', version: 1 };
const scene = { format: 'parcours-scene', version: 2 };
const main = { name: 'main.py', text: '' };
const wall = { id: 'w', type: 'wall', from: [1, 1], to: [1, 1] };

const files: readonly unknown[] = [
  {},
  { ...header, version: 9 },
  { ...header, version: 'x' },
  { ...header, files: [main], scene: 7 },
  { ...header, files: [main, main], scene },
  { ...header, files: [{ name: 'x.py', text: '' }], scene },
  { ...header, files: [{ ...main, text: 'x'.repeat(300_000) }], scene },
  { ...header, files: [], scene },
  {
    ...header,
    files: [main],
    scene: { ...scene, size: [1, 1.5], objects: [wall, { ...wall, to: [2, 2] }], colour: 1 },
  },
  { ...header, files: [main], scene: { ...scene, objects: [{ type: 'cloud' }, wall] } },
  { ...scene, version: 99 },
  [{ x: 1, y: 1 }],
];

/** The message on each broken file and link. */
function said(): readonly string[] {
  const opened = [...files.map((file) => JSON.stringify(file)), '[1,', 'x'.repeat(12_000_001)].map((text) => documentOfText(text, () => null)); // prettier-ignore
  const reasons = opened.map((it) => (it.kind === 'unreadable' ? reasonOf(it.problems) : ''));
  const links = ['#p=1.x', '#p=9.x', `#p=1.${'x'.repeat(600_000)}`].map((link) => projectOfLink(link, () => null));
  const programs = [programOfLink('?code=x')];
  return [...reasons, ...[...links, ...programs].map((it) => ('problem' in it ? linkReason(it.problem) : ''))];
}

describe.each(LANGUAGES.map((language): [Language] => [language]))(
  'what is said of broken files and links (%s)',
  (language) => {
    beforeAll(() => showLanguage(language));

    it('is a sentence each, with nothing left to fill in', () => {
      for (const sentence of said()) expect(sentence).toMatch(/^[^{}]+[.)]$/);
    });
  },
);

describe('what is said of a broken file', () => {
  it('names place and value', () => {
    showLanguage('de');
    expect(said().slice(3, 6)).toEqual([
      'Das ist weder ein Projekt noch ein Parcours.',
      '"main.py" ist kein möglicher Dateiname.',
      'Die erste Datei muss main.py heissen.',
    ]);
    expect(said()[8]).toBe('scene.colour ist unbekannt. (und 4 mehr)');
    expect(said()[9]).toBe('scene.objects[0].type: "cloud" ist hier nicht möglich. (und 1 mehr)');
    showLanguage('en');
    expect(said()[12]).toBe('the file is damaged or was not downloaded completely (line 1, column 4).');
  });
});
