// @vitest-environment happy-dom
import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';

import { projectToText } from '#project/file';
import { defaultScene } from '#scene/scene';

import { unreadReason } from '../../exchange/share/unreadable-words';
import { collectFiles } from './collect';

const text = projectToText({ files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null });
const zipOf = (files: Readonly<Record<string, Uint8Array>>) => {
  const file = new File([zipSync(files, { level: 9 })], 'tasks.zip');
  return [{ path: file.name, file }];
};

describe('the files of a series', () => {
  it('may lie in a zip', async () => {
    const { tasks, refusals } = await collectFiles(zipOf({ 'a.json': strToU8(text), 'note.txt': strToU8('x') }));
    expect([tasks.length, refusals]).toEqual([1, []]);
  });

  it('are known by the directory of their zip: what would be too much is told, and nothing is unpacked', async () => {
    const large = new Uint8Array(8 * 1024 * 1024);
    const many = Object.fromEntries(Array.from({ length: 9 }, (_, at) => [`${String(at)}.json`, large]));
    const { tasks, refusals } = await collectFiles(zipOf(many));
    expect(tasks).toEqual([]);
    expect(refusals).toHaveLength(1);
    expect(refusals[0]).toMatch(/^tasks\.zip: .*67108864/);
  });

  it('are reported if they cannot be read, and the others are taken', async () => {
    const damaged = [{ path: 'broken.zip', file: new File(['no zip'], 'broken.zip') }];
    const { refusals } = await collectFiles(damaged);
    expect(refusals).toHaveLength(1);
    const huge = zipOf({ 'huge.json': new Uint8Array(17 * 1024 * 1024), 'a.json': strToU8(text) });
    const { tasks, refusals: told } = await collectFiles(huge);
    expect([tasks.length, told.length]).toEqual([1, 1]);
    expect(told[0]).toContain('tasks.zip/huge.json');
  });

  it('are to come together: what did not come is told in the place of its task', async () => {
    const series = '{"format":"parcours-series","version":1,"title":"A","tasks":[{"file":"gone.json"}]}';
    const read = await collectFiles([{ path: 'series.json', file: new File([series], 'series.json') }]);
    const from = read.series[0]?.tasks[0]?.from;
    expect(from?.kind === 'unread' && unreadReason(from)).toContain('Öffne alle Dateien des Ordners zusammen');
  });
});
