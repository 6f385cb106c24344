import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

import { scenes } from './scenes.ts';

let folder = '';
beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scenes-'));
});
afterAll(() => rm(folder, { recursive: true }));

/** The build's output for a course file with this text. */
async function built(text: string): Promise<string | null> {
  const path = join(folder, 'scene.json');
  await writeFile(path, text);
  const load = scenes().load as (id: string) => Promise<{ readonly code: string } | null>;
  const around = {
    addWatchFile: () => undefined,
    error(message: string) {
      throw new Error(message);
    },
  };
  return (await load.call(around, `${path}?scene`))?.code ?? null;
}

describe('a course that comes with the app', () => {
  it('is read while the app is built, with every default', async () => {
    const code = await built('{"format":"parcours-scene","version":1,"name":"A"}');
    expect(code).toMatch(/^export default \{"name":"A","description":"","size":\[1200,900\]/);
  });

  it('stops the build where it is wrong, with file and place', async () => {
    const text = '{"format":"parcours-scene","version":1,"robot":{"at":[1]}}';
    await expect(built(text)).rejects.toThrow(/scene\.json: robot\.at/);
  });
});
