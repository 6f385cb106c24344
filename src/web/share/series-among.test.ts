// @vitest-environment happy-dom
import { strToU8, zipSync } from 'fflate';
import { beforeAll, describe, expect, it } from 'vitest';

import { aSeries } from '#check/series/testing/series';
import { seriesToFolder, seriesToText } from '#check/series/write-series';

import { loadTexts } from '../page/i18n';
import { seriesAmong } from './series-among';

const added = (path: string, content: BlobPart) => ({ path, file: new File([content], path.split('/').at(-1) ?? '') });
const folder = () => seriesToFolder(aSeries(), ({ title }) => title || 'task');
async function found(...files: Parameters<typeof seriesAmong>[0]) {
  const among = await seriesAmong(files);
  if (among === null) return null;
  const { read, rest } = among;
  const tasks = 'series' in read ? read.series.tasks.map(({ from }) => from.kind) : read.problem;
  return { tasks, rest: rest.map(({ path }) => path) };
}

beforeAll(() => loadTexts('de'));

describe('a series among files', () => {
  it('is its one file; the others are not its own', async () => {
    const file = added('woche.json', seriesToText(aSeries()));
    expect(await found(added('anna.py', ''), file, added('ben.json', '{}'))).toEqual({
      tasks: ['course', 'project', 'project'],
      rest: ['anna.py', 'ben.json'],
    });
  });

  it('is a folder with all the files that it names', async () => {
    const files = folder().map(({ name, text }) => added(`woche/${name}`, text));
    expect(await found(...files, added('anna.py', ''))).toEqual({
      tasks: ['course', 'project', 'project'],
      rest: ['anna.py'],
    });
    expect(await found(files[0]!)).toMatchObject({ tasks: ['course', 'unread', 'unread'] });
  });

  it('is the zip of such a folder', async () => {
    const zip = zipSync(Object.fromEntries(folder().map(({ name, text }) => [`woche/${name}`, strToU8(text)])));
    expect(await found(added('woche.zip', zip as BlobPart))).toEqual({
      tasks: ['course', 'project', 'project'],
      rest: [],
    });
  });

  it('that cannot be read says why', async () => {
    const newer = '{"format":"parcours-series","version":2,"tasks":[]}';
    expect(await found(added('neu.json', newer))).toEqual({
      tasks: expect.stringContaining('aus einer neueren Version'),
      rest: [],
    });
  });

  it('is none among hand-ins', async () => {
    const zip = zipSync({ 'anna/main.py': strToU8('a'), 'series.json': strToU8('{}') });
    expect(
      await found(added('anna.py', ''), added('ben.json', '{"format":"x"}'), added('7b.zip', zip as BlobPart)),
    ).toBeNull();
    expect(await found(added('kaputt.zip', 'no zip'))).toBeNull();
  });
});
