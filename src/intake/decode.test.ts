import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';

import { handInOfBytes } from './contents';
import { decoded } from './decode';
import { readZip } from './zip';

const none = () => null;
/** A text in Latin-1, of which Windows-1252 has all letters. */
const latin = (text: string): Uint8Array => Uint8Array.from(text, (sign) => sign.charCodeAt(0));
const utf16 = (text: string): Uint8Array => Uint8Array.from(Buffer.from(`\ufeff${text}`, 'utf16le'));

describe('a text', () => {
  it('is read as UTF-8, as UTF-16 with its mark, else as Windows-1252', () => {
    expect(decoded(strToU8('\ufeff# Übung'))).toEqual({ text: '# Übung' });
    expect(decoded(utf16('# Übung'))).toEqual({ text: '# Übung', coding: 'UTF-16' });
    expect(decoded(utf16('# Übung').map((_, at, all) => all[at ^ 1] ?? 0))).toEqual({
      text: '# Übung',
      coding: 'UTF-16',
    });
    expect(decoded(latin('# Übung \x80 \x96'))).toEqual({ text: '# Übung € –', coding: 'Windows-1252' });
  });

  it('is none where it has signs that no text has', () => {
    for (const bytes of [
      [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a],
      [0xff, 0xfe, 0x00],
      [0xff, 0xd8, 0x00],
    ])
      expect(decoded(Uint8Array.from(bytes))).toBeNull();
  });

  it('is a program as well, and the hand-in knows that boards want another coding', async () => {
    for (const [bytes, coding] of [[utf16('# Übung\n'), 'UTF-16'], [latin('# Übung\n'), 'Windows-1252']] as const)
      expect(await handInOfBytes('main.py', bytes, none)).toMatchObject({ handIn: { coding, project: { files: [{ text: '# Übung\n' }] } } }); // prettier-ignore
    const zip = zipSync({ 'main.py': latin('# für\n'), 'own.py': strToU8('x = 1'), 'photo.bin': latin('\xff\xd8') });
    expect(await handInOfBytes('a.zip', zip, none)).toMatchObject({
      handIn: { coding: 'Windows-1252', project: { files: [{ text: '# für\n' }, { name: 'own.py' }] } },
    });
  });
});

describe('a name in a zip', () => {
  /** A zip as Windows makes it: a name in its code page, without the mark of UTF-8. */
  function windowsZip(name: string, bytes: Readonly<Record<string, number>>): Uint8Array {
    const zip = zipSync({ [name]: strToU8('x') });
    return zip.map((byte) => bytes[String.fromCharCode(byte)] ?? byte);
  }
  const nameIn = (zip: Uint8Array) => {
    const read = readZip(zip);
    return 'problem' in read ? read.problem.code : read.entries[0]?.path;
  };

  it('has its umlauts from the code page of Windows, and from a Mac as one letter each', () => {
    expect(nameIn(windowsZip('J~rg B^r.py', { '~': 0x94, '^': 0x84 }))).toBe('Jörg Bär.py');
    expect(nameIn(windowsZip('C~line Ni^o.py', { '~': 0x82, '^': 0xa4 }))).toBe('Céline Niño.py');
    expect(nameIn(zipSync({ 'Zoe\u0308.py': strToU8('x') }))).toBe('Zoë.py');
  });
});
