import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';

import { aSeries } from '#check/series/testing/series';
import { seriesToFolder, seriesToText } from '#check/series/write-series';

import { openGiven } from './file';
import { seriesAmong, tasksAmong } from './series-among';

const none = () => null;
const file = (path: string, content: string | Uint8Array) => {
  const bytes = typeof content === 'string' ? strToU8(content) : content;
  return { path, size: bytes.length, read: () => ({ bytes }) };
};
type Files = readonly ReturnType<typeof file>[];
const opened = (files: Files) => Promise.all(files.map((one) => openGiven(one)));
const folder = () => seriesToFolder(aSeries(), ({ title }) => title || 'task');
async function found(...files: Files) {
  const among = await seriesAmong(await opened(files), none);
  if (among === null) return null;
  const { document, rest } = among;
  const tasks = document.kind === 'series' ? document.series.tasks.map(({ from }) => from.kind) : document.problem.code;
  return { tasks, rest: rest.map((one) => one.file.path) };
}

describe('a series among files', () => {
  it('is its one file; the others are not its own', async () => {
    const series = file('woche.json', seriesToText(aSeries()));
    expect(await found(file('anna.py', ''), series, file('ben.json', '{}'))).toEqual({
      tasks: ['course', 'project', 'project'],
      rest: ['anna.py', 'ben.json'],
    });
  });

  it('is a folder with all the files that it names', async () => {
    const files = folder().map(({ name, text }) => file(`woche/${name}`, text));
    expect(await found(...files, file('anna.py', ''))).toEqual({
      tasks: ['course', 'project', 'project'],
      rest: ['anna.py'],
    });
    expect(await found(files[0]!)).toMatchObject({ tasks: ['course', 'unread', 'unread'] });
  });

  it('is the zip of such a folder', async () => {
    const zip = zipSync(Object.fromEntries(folder().map(({ name, text }) => [`woche/${name}`, strToU8(text)])));
    expect(await found(file('woche.zip', zip))).toEqual({
      tasks: ['course', 'project', 'project'],
      rest: [],
    });
  });

  it('says why it cannot be read', async () => {
    const newer = '{"format":"parcours-series","version":2,"tasks":[]}';
    expect(await found(file('neu.json', newer))).toEqual({
      tasks: 'newer',
      rest: [],
    });
  });

  it('is none among hand-ins', async () => {
    const zip = zipSync({ 'anna/main.py': strToU8('a'), 'series.json': strToU8('{}') });
    expect(await found(file('anna.py', ''), file('ben.json', '{"format":"x"}'), file('7b.zip', zip))).toBeNull();
    expect(await found(file('kaputt.zip', 'no zip'))).toBeNull();
  });
});

describe('the tasks among files', () => {
  it('are unpacked as far as the directory of a zip says, whatever lies in it', async () => {
    const zip = zipSync({ 'a.json': strToU8(' '.repeat(5000)) }, { level: 9 });
    const view = new DataView(zip.buffer, zip.byteOffset);
    for (let at = 0; at < zip.length - 4; at += 1) if (view.getUint32(at, true) === 0x02014b50) view.setUint32(at + 24, 10, true); // prettier-ignore
    const { unreadable } = await tasksAmong(await opened([file('tasks.zip', zip)]), none);
    expect(unreadable).toMatchObject([{ file: 'tasks.zip/a.json', document: { problem: { code: 'zip-bomb' } } }]);
  });
});
