import LZString from 'lz-string';
import { describe, expect, it } from 'vitest';

import type { SourceFile } from '../project';
import { isProgramLink, programOfLink } from './program-link';
import { readWorld } from './read-world';
import { noteText } from './say';
import { linkSamples } from './testing/links';

/** A link's `code` as WebTigerPython makes it. */
const codeOf = (value: unknown): string =>
  LZString.compressToBase64(JSON.stringify(value)).replaceAll('+', '-').replaceAll('/', '_');
const HOST = 'https://webtigerpython.ethz.ch/';
const text = 'from microbit import *\nwhile True:\n    display.show("ü")\n';
const one = codeOf([{ name: 'main.py', data: text }]);
const main = { name: 'main.py', text };
/** A link with files alone. */
const bare = (files: readonly SourceFile[]) => ({ files, device: null, world: null, notes: [] });
/** A link's `playground` as in the public ones, before it is encoded for an address. */
const worldOf = (value: unknown): string => LZString.compressToBase64(JSON.stringify(value)).replaceAll('=', '');
const notesOf = (address: string): readonly string[] => {
  const read = programOfLink(address);
  if ('problem' in read) throw new Error(read.problem.message);
  return read.notes.map((one) => noteText(one, 'en'));
};
const problemOf = (address: string): string | null => {
  const read = programOfLink(address);
  return 'problem' in read ? `${read.problem.code}: ${read.problem.message}` : null;
};

describe('a link of WebTigerPython', () => {
  it('opens its program, in the query or in the fragment, as a whole address or a part', () => {
    for (const address of [`${HOST}?code=${one}`, `${HOST}#?code=${one}`, `?code=${one}`, `#?code=${one}`]) {
      expect(isProgramLink(address)).toBe(true);
      expect(programOfLink(address)).toEqual(bare([main]));
    }
    expect(programOfLink(`${HOST}?lang=de&code=${encodeURIComponent(one)}&layout=%5B%22Canvas%22%5D#x`)).toEqual(bare([main])); // prettier-ignore
    expect(isProgramLink(HOST)).toBe(false);
    expect(isProgramLink('#p=1.abc')).toBe(false);
  });

  it('says which microcomputer the program is for, where we have it', () => {
    const device = (name: string) => programOfLink(`${HOST}?device=${encodeURIComponent(name)}&code=${one}`);
    expect(device('micro:bit')).toMatchObject({ device: 'microbit-v2' });
    expect(device('Calliope mini 3')).toMatchObject({ device: 'calliope-mini-3' });
    expect(device('Oxocard')).toMatchObject({ device: null });
  });

  it('opens several files, main.py first', () => {
    const code = codeOf([{ name: 'fahren.py', data: 'x = 1\r\n' }, { name: 'main.py', data: 'import fahren' }]); // prettier-ignore
    expect(programOfLink(`#?code=${code}`)).toEqual(
      bare([
        { name: 'main.py', text: 'import fahren' },
        { name: 'fahren.py', text: 'x = 1\n' },
      ]),
    );
    expect(programOfLink(`#?code=${codeOf([{ name: 'robot.py', data: 'y' }])}`)).toMatchObject({ files: [{ name: 'main.py', text: 'y' }] }); // prettier-ignore
  });

  it('opens the project of a page with several files, in each form that we know', () => {
    const files = [main, { name: 'drive.py', text: 'x = 1\n' }];
    const named = { 'drive.py': 'x = 1\r\n', 'main.py': text };
    for (const form of [
      named,
      { files: named },
      { '/main.py': { content: text }, '/drive.py': { content: 'x = 1\n' } },
      [...files.map((file) => ({ name: file.name, data: file.text }))],
      { open: 'main.py', files: files.map((file) => ({ path: `./${file.name}`, code: file.text })) },
    ]) {
      const address = `${HOST}#?fs=${codeOf(form)}`;
      expect(isProgramLink(address)).toBe(true);
      expect(programOfLink(address)).toEqual(bare(files));
    }
    expect(codeOf(named)).toMatch(/^N4Ig/);
  });

  it('says so when the project of several files has a form that we do not know', () => {
    for (const form of [{}, [], 'main.py', 7, null, { 'main.py': { folder: {} } }, { files: 7 }])
      expect(problemOf(`#?fs=${codeOf(form)}`)).toMatch(/^unknown-form: /);
    expect(problemOf(`#?fs=${codeOf({ 'lib/a.py': '' })}`)).toBeNull(); // the only file is the program
    expect(problemOf(`#?fs=${codeOf({ 'main.py': '', 'lib/a.py': '' })}`)).toMatch(/^invalid/);
    expect(problemOf('#?fs=A')).toMatch(/^damaged/);
  });

  it('gives a message when it is cut off, changed or holds something else', () => {
    for (const code of [
      '',
      'A',
      one.slice(0, 20),
      `${one.slice(0, 30)}!${one.slice(31)}`,
      codeOf({ name: 'x' }),
      codeOf([]),
      codeOf([7]),
      codeOf('x'),
      '%E4',
    ])
      expect(problemOf(`?code=${code}`)).toMatch(/^damaged: The link is damaged/);
    expect(problemOf(HOST)).toMatch(/^damaged/);
    expect(
      problemOf(
        `?code=${codeOf([
          { name: '../a.py', data: '' },
          { name: '../a.py', data: '' },
        ])}`,
      ),
    ).toBe(
      'invalid: The program in the link cannot be opened: files[1].name: "../a.py" cannot be the name of a file: it may have letters, digits, "_", "-" and "." only.',
    );
  });

  it('is given up when it unpacks to more than 4 million characters', () => {
    // 5 million equal characters, packed by hand: each code of the packed text repeats one more than the one before.
    expect(problemOf(`?code=${bomb(5_000_000)}`)).toMatch(/^too-large/);
    expect(problemOf(`?code=${'A'.repeat(500_001)}`)).toMatch(/^too-long/);
    expect(problemOf(`?code=${one}&x=${'A'.repeat(2_000_000)}`)).toMatch(/^too-long/);
  });
});

describe('a link of WebTigerPython with a world', () => {
  it.each(linkSamples)('opens: $name', ({ link, program, playground }) => {
    const files = program === '' ? [] : [{ name: 'main.py', text: program }];
    const world = playground === null ? null : readWorld(playground);
    expect(programOfLink(link)).toMatchObject({ files, device: 'microbit-v2', world });
    expect(world?.notes ?? []).toEqual([]);
    const broken = 'The world in the link could not be read: a part of it is missing or changed. Copy the link again, whole.'; // prettier-ignore
    expect(notesOf(link)).toEqual(playground === null ? [broken] : []);
  });

  it('opens where a + became a space, and in the alphabet of addresses', () => {
    const [{ link }] = [linkSamples.find(({ name }) => name.includes('raw'))!];
    const whole = programOfLink(link);
    expect(programOfLink(link.replaceAll('+', ' '))).toEqual(whole);
    expect(programOfLink(link.replaceAll('+', '%20'))).toEqual(whole);
    expect(programOfLink(link.replaceAll('+', '-'))).toEqual(whole);
    expect(programOfLink(link.replace('#?', '?'))).toEqual(whole);
  });

  it('opens its program wherever the world was cut off', () => {
    const [{ link, program }] = [linkSamples[0]!];
    for (let end = link.indexOf('playground=') + 12; end < link.length - 1; end += 1)
      expect(programOfLink(link.slice(0, end))).toMatchObject({ files: [{ text: program }], world: null, notes: [{ code: 'worldDamaged' }] }); // prettier-ignore
  });

  it('says so when the world is something else or too large, and opens the program', () => {
    const codes = (playground: string): unknown => programOfLink(`?code=${one}&playground=${encodeURIComponent(playground)}`); // prettier-ignore
    expect(codes(worldOf({ walls: [] }))).toMatchObject({ files: [main], notes: [{ code: 'worldUnknown' }] });
    expect(codes(worldOf([1]))).toMatchObject({ notes: [{ code: 'worldUnknown' }] });
    expect(codes(bomb(1_500_000))).toMatchObject({ notes: [{ code: 'worldTooLarge' }] });
    expect(codes('A'.repeat(1_000_000))).toMatchObject({ notes: [{ code: 'worldTooLarge' }] });
    expect(codes('')).toMatchObject({ world: null, notes: [] });
    expect(programOfLink(`?code=${one}&playground=%E4`)).toMatchObject({ notes: [{ code: 'worldDamaged' }] });
  });

  it('opens a whole world without its damaged program, and says so', () => {
    const whole = encodeURIComponent(worldOf({ StartBox: [9, 9, 0] }));
    const read = programOfLink(`?code=A&playground=${whole}`);
    expect(read).toMatchObject({ files: [], notes: [{ code: 'programDamaged' }] });
  });

  it('opens nothing when there is neither program nor world in it', () => {
    for (const world of ['A', '%E4', worldOf({ walls: [] })])
      expect(problemOf(`?code=&playground=${world}`)).toMatch(/^damaged/);
    expect(problemOf(`?playground=${bomb(1_500_000)}`)).toMatch(/^too-large/);
  });

  it('names what it sets besides, but not what a page looks like', () => {
    const address = `${HOST}#?layout=x&lang=de&dark_mode=true&full_screen=true&hide_topbar=true&tutorial_size=9&utm_source=x&vanilla_python=false&breakpoints=&seed=7`; // prettier-ignore
    expect(notesOf(`${address}&code=${one}`)).toEqual([]);
    expect(notesOf(`${HOST}?vanilla_python=true&x=1&fs=abc&code=${one}&device=Oxocard`)).toEqual([
      'Parcours does not have the device “Oxocard”: the program’s imports say which microcomputer runs.',
      'The link also sets what Parcours does not have: vanilla_python, x, fs.',
    ]);
    const many = Array.from({ length: 200_000 }, (_, place) => `x${String(place)}=1`).join('&');
    expect(notesOf(`?${many}&code=${one}`)).toEqual(['The link also sets what Parcours does not have: x0, x1, x2, x3, x4, ….']); // prettier-ignore
  });
});

/** LZ-String's form of many equal characters: after the first, each code names the entry that is just being made. */
function bomb(characters: number): string {
  const bits: number[] = [];
  const put = (value: number, width: number): void => {
    for (let bit = 0; bit < width; bit += 1) bits.push((value >> bit) & 1);
  };
  put(0, 2);
  put(97, 8);
  let [width, left, next, length] = [3, 4, 4, 1];
  for (let total = 1; total < characters; total += length) {
    put(next, width);
    next += 1;
    length += 1;
    left -= 1;
    if (left === 0) [left, width] = [1 << width, width + 1];
  }
  put(2, width);
  const signs = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
  const sixes = Array.from({ length: Math.ceil(bits.length / 6) }, (_, at) =>
    [0, 1, 2, 3, 4, 5].reduce((value, bit) => value * 2 + (bits[at * 6 + bit] ?? 0), 0),
  );
  return sixes.map((six) => signs.charAt(six)).join('');
}
