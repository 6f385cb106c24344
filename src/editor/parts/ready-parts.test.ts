import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { clipText } from '../clip-text';
import { findProblems } from '#scene/rules';
import { defaultScene } from '#scene/scene';
import { pasted } from '../clipboard';
import { applyEdit } from '#scene/edit';
import { partCourse, sizeOfPart } from './part-course';
import { readyGroups, readyPart } from './ready-parts';

const names = Object.values(readyGroups).flat();

describe('the ready parts', () => {
  it('are the files of their folder, each on the shelf once', () => {
    const files = readdirSync('src/editor/parts/ready').map((file) => file.replace('.json', ''));
    expect([...names].sort()).toEqual(files.sort());
  });

  it.each(names)('%s is a course without problems, in an arena and alone', (name) => {
    const scene = { ...defaultScene(), robot: { ...defaultScene().robot, at: [1100, 800] as const } };
    const made = pasted(scene, readyPart(name), { x: 500, y: 400 });
    expect(findProblems(applyEdit(scene, made!.edit), [])).toEqual([]);
    const alone = partCourse(readyPart(name));
    expect(findProblems(alone, []).filter(({ ids }) => ids.length > 0)).toEqual([]);
  });

  it.each(names)('%s is one group, unless it is one thing', (name) => {
    const { objects } = readyPart(name);
    expect(new Set(objects.map(({ group }) => group)).size).toBe(1);
    expect(objects[0]?.group === undefined).toBe(objects.length === 1);
  });

  it.each(names)('%s is kept as the clipboard writes it', (name) => {
    const kept = JSON.parse(readFileSync(`src/editor/parts/ready/${name}.json`, 'utf8')) as typeof written;
    const written = JSON.parse(clipText(readyPart(name))) as { readonly course: { readonly objects: unknown } };
    expect(written.course.objects).toEqual(kept.course.objects);
  });

  it('have lines that end 75 mm or a multiple of it from where they begin, so that tracks close', () => {
    for (const name of readyGroups.lines) {
      const ends = readyPart(name).objects.flatMap((object) =>
        object.type === 'stroke' ? [object.points[0]!, object.points.at(-1)!] : [],
      );
      const [first] = ends;
      const outer = name === 'gap' ? [ends[0]!, ends[3]!] : ends;
      for (const [x, y] of outer) expect([(x - first![0]) % 75, (y - first![1]) % 75].map(Math.abs)).toEqual([0, 0]);
    }
  });

  it('have lines that fit onto one sheet of A4, which takes 190 × 277 mm, except for the long ones', () => {
    for (const name of [...readyGroups.lines, 'bay', 'start-box', 'sensor-strip'] as const) {
      if (name === 'long' || name === 'lane-change' || name === 'zigzag') continue;
      const [short, long] = [...partCourse(readyPart(name)).size].sort((one, two) => one - two);
      expect([name, short! <= 190, long! <= 277]).toEqual([name, true, true]);
    }
  });
});

describe('a part alone', () => {
  it('lies on a floor that is 5 mm wider than it on each side', () => {
    const { size, objects } = partCourse(readyPart('straight'));
    expect(sizeOfPart(readyPart('straight'))).toEqual([150, 20]);
    expect(sizeOfPart(readyPart('curve'))).toEqual([150, 150]);
    expect(partCourse({ objects: [] }).objects).toEqual([]);
    expect([size, objects]).toMatchObject([[180, 30], [{ points: [[15, 15], [165, 15]] }]]); // prettier-ignore
  });
});
