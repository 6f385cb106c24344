import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { fingerprint } from './fingerprint.mjs';

let folder;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'parcours-fingerprint-'));
  await writeFile(join(folder, 'a.ts'), 'one');
});

afterAll(() => rm(folder, { recursive: true }));

describe('a fingerprint', () => {
  it('is the same for the same content and another for changed content', async () => {
    const first = await fingerprint([folder]);
    expect(await fingerprint([folder])).toBe(first);
    await writeFile(join(folder, 'a.ts'), 'two');
    expect(await fingerprint([folder])).not.toBe(first);
  });

  it('sees a new file, but not one that does not count', async () => {
    const counts = (path) => !path.endsWith('.test.ts');
    const before = await fingerprint([folder], counts);
    await writeFile(join(folder, 'b.test.ts'), 'test');
    expect(await fingerprint([folder], counts)).toBe(before);
    await writeFile(join(folder, 'b.ts'), 'code');
    expect(await fingerprint([folder], counts)).not.toBe(before);
  });

  it('takes a missing source for an absent one', async () => {
    expect(await fingerprint([`${folder}/nothing`])).toBe(await fingerprint([]));
  });
});
