import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { readZip, type ZipEntry } from './zip';

const entriesOf = (bytes: Uint8Array): readonly ZipEntry[] => {
  const zip = readZip(bytes);
  if ('problem' in zip) throw new Error(zip.problem.code);
  return zip.entries;
};

describe('a zip', () => {
  it('gives its files one by one, packed and unpacked', () => {
    const zip = zipSync({ 'a.py': strToU8('x = 1'), 'ö/b.py': [strToU8('y = 2'), { level: 0 }] });
    const texts = entriesOf(zip).map((entry) => {
      const read = entry.read(100);
      return [entry.path, 'bytes' in read ? new TextDecoder().decode(read.bytes) : read.problem.code];
    });
    expect(texts).toEqual([['a.py', 'x = 1'], ['ö/b.py', 'y = 2']]); // prettier-ignore
  });

  it('has all its files, from wherever they were packed, and its folders', () => {
    const paths = ['./a.py', '/home/b.py', '../../c.py', 'x\\.\\d.py', 'e/', './', '..'];
    const zip = zipSync(Object.fromEntries(paths.map((path) => [path, strToU8('')])));
    expect(entriesOf(zip).map(({ path }) => path)).toEqual(['a.py', 'home/b.py', 'c.py', 'x/d.py', 'e/']);
  });

  it('is not unpacked if it would unpack to a gigabyte', () => {
    const bomb = zipSync({ 'a.py': new Uint8Array(20_000_000) }, { level: 9 });
    expect(bomb.length).toBeLessThan(25_000);
    expect(entriesOf(bomb)[0]?.read(1_000_000)).toEqual({ problem: { code: 'zip-bomb', params: { most: 1_000_000 } } }); // prettier-ignore
  });

  it('is refused if it is none, or a part of one', () => {
    const zip = zipSync({ 'a.py': strToU8('x = 1') });
    for (const bytes of [strToU8('hello'), zip.subarray(0, zip.length - 10), new Uint8Array()])
      expect(readZip(bytes)).toEqual({ problem: { code: 'zip', params: {} } });
  });

  it('may be damaged anywhere, and nothing is thrown', () => {
    const zip = zipSync({ 'a.py': strToU8('x = 1\n'.repeat(50)), 'b.py': strToU8('y') });
    for (let at = 0; at < zip.length; at++) {
      for (const byte of [0, 0xff, (zip[at] ?? 0) ^ 1]) {
        const damaged = Uint8Array.from(zip);
        damaged[at] = byte;
        const read = readZip(damaged);
        if ('entries' in read) for (const entry of read.entries) entry.read(10_000);
      }
    }
  });
});
