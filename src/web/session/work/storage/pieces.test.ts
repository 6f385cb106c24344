import { describe, expect, it } from 'vitest';

import type { Project } from '#project/project';
import { defaultScene } from '#scene/scene';

import { workToText, type Work } from './history';
import { joinWork, piecesIn, splitWork } from './pieces';
import { workFromText } from './read-work';

const picture = `data:image/png;base64,${'AbCd'.repeat(350_000)}`;
const background = { at: [0, 0], size: [400, 300], cells: [2, 2], levels: 'AAAA', picture } as const;
const withPicture: Project = {
  files: [{ name: 'main.py', text: '{"parcours.piece":"1-2-3"}' }],
  scene: { ...defaultScene(), background },
  course: null,
};
const small: Project = { ...withPicture, scene: defaultScene() };
const earlier = (project: Project, atMs: number) => ({ name: 'Früher', atMs, project });
const work: Work = {
  project: withPicture,
  open: 'main.py',
  previous: [earlier(withPicture, 3), earlier(small, 2), earlier({ ...withPicture, course: 'x' }, 1)],
};

describe('work with a picture of 1.4 MB as floor, here and in two earlier projects', () => {
  it('is stored in a few kB once its large parts lie apart', () => {
    const first = splitWork(work, () => false);
    expect(first.text).toBe(workToText(work));
    expect(first.loose.map(({ text }) => text.length > 1_000_000)).toEqual([true, true, true]);
    const kept = new Map(first.loose.map(({ name, text }) => [name, text]));
    const second = splitWork(work, (name) => kept.has(name));
    expect(second.loose).toEqual([]);
    expect(second.text.length).toBeLessThan(2_000);
    expect(new Set(piecesIn(second.text))).toEqual(new Set(kept.keys()));
    expect(workFromText(joinWork(second.text, kept))).toEqual(work);
  });

  it('opens without its floor and the large earlier work where the pieces are lost', () => {
    const { text } = splitWork(work, () => true);
    const read = workFromText(joinWork(text, new Map()));
    expect(read?.project.scene).toEqual(defaultScene());
    expect(read?.project.files).toEqual(withPicture.files);
    expect(read?.previous).toEqual([earlier(small, 2)]);
  });

  it('asks for no piece where a program only talks of one', () => {
    expect(piecesIn(workToText({ project: small, open: 'main.py', previous: [] }))).toEqual([]);
  });

  it('holds the five newest earlier works itself; all before them lie apart once there is need, be they ever so small', () => {
    const many = Array.from({ length: 300 }, (_, at) => {
      const files = [{ name: 'main.py', text: `mission = ${String(at)}` }];
      return earlier({ ...small, files }, 300 - at);
    });
    const crowded = { ...work, project: small, previous: many };
    const first = splitWork(crowded, () => false);
    const kept = new Map(first.loose.map(({ name, text }) => [name, text]));
    const second = splitWork(crowded, (name) => kept.has(name));
    expect([first.loose.length, second.loose.length]).toEqual([295, 0]);
    expect(second.text.length).toBeLessThan(40_000);
    expect(workFromText(joinWork(second.text, kept))).toEqual(crowded);
  });
});
