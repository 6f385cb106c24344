import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { tapeToText } from '#tape/file';
import { runLinkOf } from '#tape/link';
import type { HandIn } from '#check/hand-in/hand-in';
import { contentOf, fileSource, listSources, type Source } from './sources';

const files = { 'main.py': 'forward()\n', 'own.py': 'x = 1\n' };
const setup = soloRun({
  ...{ scene: { ...defaultScene(), name: 'Hall' }, files, seed: 1, reality: 0 },
  ...{ robot: 'maqueen-lite', board: 'microbit-v2' },
});
const result = { traceHash: '0', simulatedUs: 5_000_000, devices: [] };
/** A recording with a made-up result: a hand-in is run anyway. */
const run = tapeToText({ madeBy: '0.0.0', physics: 2, setup, untilUs: 5_000_000, untilProgramEnds: true, result });
const address = `https://parcours.example/#${runLinkOf(run, 1_000_000)}`;

async function handInOf(source: Source | undefined): Promise<HandIn> {
  const content = source === undefined ? null : await contentOf(source);
  if (content === null || 'problem' in content) throw new Error(content?.problem.code ?? 'There is none.');
  return content.handIn;
}
const programs = ({ project }: HandIn): object =>
  Object.fromEntries(project.files.map(({ name, text }) => [name, text]));

describe('a run that is handed in', () => {
  it('is the project in its link among others, on the course that it was driven on', async () => {
    const [ada, ben] = listSources(`Ada: ${address}\nBen: #${runLinkOf(run, 0)}.`, () => null);
    expect([ada?.name, ben?.name]).toEqual(['Ada', 'Ben']);
    const handIn = await handInOf(ada);
    expect(programs(handIn)).toEqual(files);
    expect([handIn.hasCourse, handIn.project.scene.name, handIn.said]).toEqual([true, 'Hall', null]);
    expect(programs(await handInOf(ben))).toEqual(files);
  });

  it('is the same as its file', async () => {
    const bytes = new TextEncoder().encode(run);
    const source = fileSource({ path: 'Ada.run.json', size: bytes.length, read: () => ({ bytes }) }, () => null);
    expect(programs(await handInOf(source))).toEqual(files);
  });

  it('whose program or set-up was changed in its file is told as such', async () => {
    const read = async (text: string): Promise<HandIn> => {
      const bytes = new TextEncoder().encode(text);
      return handInOf(fileSource({ path: 'Ada.run.json', size: bytes.length, read: () => ({ bytes }) }, () => null));
    };
    const changed = [run, run.replace('forward()', 'backward()'), run.replace('"seed":1', '"seed":2')];
    expect((await Promise.all(changed.map(read))).map(({ isEdited }) => isEdited)).toEqual([undefined, true, true]);
    expect((await handInOf(listSources(`#${runLinkOf(changed[1] ?? '', 0)}`, () => null)[0])).isEdited).toBe(true);
  });

  it('says so if its link is not whole, or from a newer Parcours', async () => {
    const newer = address.replace('#r=1.', '#r=2.');
    const found = await Promise.all(listSources(`${address.slice(0, -9)}\n${newer}`, () => null).map(contentOf));
    expect(found).toEqual([{ problem: { code: 'link', params: {} } }, { problem: { code: 'newer-link', params: {} } }]);
  });
});
