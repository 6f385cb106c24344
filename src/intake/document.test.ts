import { describe, expect, it } from 'vitest';

import { readyCourses } from '#check/series/testing/series';
import { documentOfAddress } from './address';
import { documentIn, documentOf, openFile, openGiven } from './file';
import { limits, mostBytes, stemOf } from './formats';
import { addresses, samples } from './testing/samples';
import type { TreeFile } from './tree';

const none = () => null;
const fileOf = (path: string, bytes: Uint8Array, size = bytes.length): TreeFile => ({ path, size, read: () => ({ bytes }) }); // prettier-ignore

describe('a file', () => {
  it.each(samples)(
    '$name is of the kind “$kind”, in whatever folder and however its ending is written',
    async (one) => {
      const { name, bytes, kind } = one;
      expect((await documentOf(name, bytes, readyCourses)).kind).toBe(kind);
      expect(
        (await documentOf(`a.zip/${name.replace(/\.\w+$/, (ending) => ending.toUpperCase())}`, bytes, none)).kind,
      ).toBe(kind);
      expect((await documentIn(await openGiven(fileOf(name, bytes)), none)).kind).toBe(kind);
    },
  );

  it('is not read if it is too large', async () => {
    const unread = (path: string): TreeFile => ({ ...fileOf(path, new Uint8Array(), mostBytes(path) + 1), read: () => expect.fail('It was read.') }); // prettier-ignore
    for (const name of ['a.py', 'a.json', 'a.txt', 'a.tsv'])
      expect(await openFile(unread(name), none)).toMatchObject({ problem: { code: 'large', params: { file: name } } });
    expect((await openGiven(unread('a.zip'))).zip).toMatchObject({ problem: { code: 'large' } });
    expect(await openFile(unread('film.mp4'), none)).toMatchObject({ problem: { code: 'kind' } });
    expect(await openFile(unread('photo.jpg'), none)).toEqual({ kind: 'picture' });
  });

  it('says so if it vanishes while it is read', async () => {
    const gone: TreeFile = { path: 'a.py', size: 1, read: () => Promise.reject(new Error('no disk')) };
    expect(await openFile(gone, none)).toMatchObject({ problem: { code: 'gone', params: { problem: 'no disk' } } });
  });

  it('has a name without its ending', () => {
    const names = ['x/anna.py', 'anna.parcours.json', 'anna.run.json', 'anna.v2.zip', '.json', 'anna'];
    expect(names.map(stemOf)).toEqual(['anna', 'anna', 'anna', 'anna.v2', '.json', 'anna']);
  });

  it('is at most as large for all doors', () => {
    expect([limits.program, limits.json, limits.log]).toEqual([262_144, 16_777_216, 1_048_576]);
  });
});

describe('an address', () => {
  it.each(Object.entries(addresses))('is of the kind “%s”', (kind, address) => {
    expect(documentOfAddress(` ${address}\n`, readyCourses).kind).toBe(kind);
  });

  it('may name a ready course beside its program, a task before an arena', () => {
    expect(documentOfAddress(`${addresses.program}&world=hall`, none)).toMatchObject({
      kind: 'program',
      course: 'hall',
    });
    expect(documentOfAddress('#?world=hall&task=a%20b', none)).toEqual({ kind: 'ready', course: 'a b', isWhole: true });
  });

  it('says so if it is damaged or newer', () => {
    const codes = ['#p=1.x', '#p=99.abc', '#r=1.0.x', '#r=99.0.x', '?code=x'].map((address) => {
      const document = documentOfAddress(address, none);
      return document.kind === 'unreadable' ? [document.problem.code, document.link?.code] : document.kind;
    });
    expect(codes).toEqual([
      ['link', 'damaged'],
      ['newer-link', 'newer-version'],
      ['link', 'damaged'],
      ['newer-link', 'newer-version'],
      ['link', 'damaged'],
    ]);
  });
});
