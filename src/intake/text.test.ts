import { readFileSync } from 'node:fs';

import { demoMap, exit, mapFile, straight, tileOf } from '#rescue-line/testing/maps';
import { describe, expect, it } from 'vitest';

import { defaultScene, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import { projectToText } from '#project/file';
import { fullProject } from '#project/testing/projects';

import { documentOfText } from './text';

const read = (text: string) => documentOfText(text, () => null);
const open = (value: unknown) => read(JSON.stringify(value));
const problemIn = (value: unknown): string => {
  const opened = typeof value === 'string' ? read(value) : open(value);
  return opened.kind === 'unreadable' ? opened.message : '';
};
const sceneIn = (value: unknown): Scene => {
  const opened = open(value);
  if (opened.kind !== 'course') throw new Error(problemIn(value));
  return opened.scene;
};

describe('a JSON file', () => {
  it('is told apart: project, course, something else', () => {
    expect(read(projectToText(fullProject()))).toEqual({
      ...{ kind: 'project', isCourseChanged: false },
      project: fullProject(),
    });
    expect(read(`\ufeff${serializeScene(defaultScene())}`)).toEqual({
      ...{ kind: 'course', device: null, isFromWebTigerPython: false, notes: [], mapNotes: [] },
      scene: defaultScene(),
    });
    const old = readFileSync(new URL('../../courses/closed-line/scene.json', import.meta.url), 'utf8');
    expect(read(old).kind).toBe('course');
    for (const value of [null, 7, 'x', {}, [], [1, 2], { version: 1 }, [{ x: 1 }], { files: [] }])
      expect(problemIn(JSON.stringify(value))).toContain('neither a project nor a course');
    const ofClass = readFileSync(new URL('../school-class/kept/v1.json', import.meta.url), 'utf8');
    expect(problemIn(ofClass)).toContain('is the file of a class');
    expect(problemIn('[1, 2')).toContain('not JSON: line 1, column 6');
    expect(problemIn({ format: 'parcours-scene', version: 99 })).toContain('newer');
  });
});

describe('a map of the editor of RoboCup Junior', () => {
  it('is a course, with notes on what it cannot hold', () => {
    expect(documentOfText(JSON.stringify(demoMap()), () => null)).toMatchObject({
      ...{ kind: 'course', scene: { name: 'Demo', size: [900, 900] }, mapNotes: [] },
    });
    const bumpy = mapFile({ '0,0,0': straight(), '1,0,0': straight(0, { items: { speedbumps: 1 } }), '2,0,0': exit(90) });
    expect(documentOfText(JSON.stringify(bumpy), () => null)).toMatchObject({ mapNotes: [{ code: 'bumps' }] });
  });

  it('is told what is wrong with it, also in the form of a list', () => {
    const list = mapFile([{ ...straight(), x: 0, y: 0, rot: 5 }]);
    expect(documentOfText(JSON.stringify(list), () => null)).toMatchObject({
      ...{ kind: 'unreadable', message: 'tiles[0].rot: 5 is unknown. Known: 0, 90, 180, 270.' },
    });
  });

  it('is refused if its course would have too many things', () => {
    const crossing = tileOf('tile-30', 0, { left: 'top', right: 'left', top: 'left', bottom: 'top' }, { type: { intersections: 1 } }); // prettier-ignore
    const places = Array.from({ length: 900 }, (_, index) => `${String(index % 30)},${String(Math.floor(index / 30))},0`);
    const tiles = Object.fromEntries(places.map((place) => [place, crossing]));
    const read = documentOfText(JSON.stringify(mapFile(tiles)), () => null);
    expect(read).toMatchObject({ kind: 'unreadable', problems: [{ code: 'too-many', path: 'objects' }] });
  });
}); // prettier-ignore

describe('a level of an earlier simulator', () => {
  it('has things in its lists: a robot beside empty ones, or alone in one, is no course', () => {
    const robot = { x: 1, y: 1 };
    expect(problemIn({ robot, blocks: [] })).toContain('neither a project nor a course');
    expect(problemIn({ things: [{ ...robot, type: 'robot' }] })).toContain('nothing in this level but a robot');
  });

  it('has circles in a row as a line, with the y axis turned up', () => {
    const dots = Array.from({ length: 40 }, (_, i) => ({ type: 'circle', x: 100 + 5 * i, y: 200, radius: 10 }));
    expect(sceneIn(dots)).toEqual({
      ...defaultScene(),
      objects: [{ type: 'stroke', id: 'stroke-1', points: [[100, 700], [295, 700]], width: 20, color: 'black' }], // prettier-ignore
    });
  });

  it('begins a new line where circles do not touch or change their size', () => {
    const dot = (x: number, radius: number) => ({ position: { x, y: 50 }, radius });
    const widths = sceneIn({ marks: [dot(0, 5), dot(8, 5), dot(19, 5), dot(24, 8)] }).objects.map((it) => it.type === 'stroke' && [it.points.length, it.width]); // prettier-ignore
    expect(widths).toEqual([[2, 10], [1, 10], [1, 16]]); // prettier-ignore
  });

  it('has rectangles as blocks and walls, and the robot at its start', () => {
    const scene = sceneIn({
      canvas: { width: 800, height: 600 },
      objects: [
        { type: 'movable', x: 100, y: 100, size: { width: 50, height: 40 }, angle: 45 },
        { type: 'immovable', x: 200, y: 100, size: [50, 50] },
        { type: 'block', x: 250, y: 100, width: 60, height: 60, isStatic: false },
        { x: 300, y: 100, width: 60, height: 60 },
      ],
      walls: [{ x: 400, y: 300, w: 200, h: 10, rotation: Math.PI / 2 }],
      robots: [{ x: 700, y: 500, angle: 90 }],
    });
    expect(scene.size).toEqual([800, 600]);
    expect(scene.robot).toMatchObject({ at: [700, 100], heading: 270 });
    expect(scene.objects).toEqual([
      { type: 'block', id: 'block-1', at: [100, 500], size: [50, 40], angle: 315 },
      { type: 'fixed-block', id: 'fixed-block-1', at: [200, 500], size: [50, 50], angle: 0 },
      { type: 'block', id: 'block-2', at: [250, 500], size: [60, 60], angle: 0 },
      { type: 'fixed-block', id: 'fixed-block-2', at: [300, 500], size: [60, 60], angle: 0 },
      { type: 'wall', id: 'wall-1', from: [400, 400], to: [400, 200], thickness: 10 },
    ]);
  });

  it('makes the arena as large as needed and moves what lies at negative places into it', () => {
    const scene = sceneIn([{ x: -200, y: 0, radius: 10 }, { x: 1500, y: 0, radius: 10 }]); // prettier-ignore
    expect(scene.size).toEqual([1800, 900]);
    expect(scene.objects.map((it) => it.type === 'stroke' && it.points[0])).toEqual([[60, 840], [1760, 840]]); // prettier-ignore
  });

  it('has the robot at its start also where it stands beside the lists', () => {
    const scene = sceneIn({ robot: { x: 200, y: 100, angle: 90 }, walls: [{ x: 400, y: 300, w: 200, h: 10 }] });
    expect(scene.robot).toMatchObject({ at: [200, 800], heading: 270 });
    expect(scene.objects).toHaveLength(1);
  });

  it('opens nothing when something in it is not clear', () => {
    expect(problemIn([{ x: 1, y: 2, radius: 5 }, { x: 1, y: 2 }])).toBe('[1]: { x, y } is not a thing that we know.'); // prettier-ignore
    expect(problemIn({ walls: [{ x: 1, y: 2, w: 5, h: 5 }], names: ['a'] })).toBe('names[0]: "a" is not a thing that we know.'); // prettier-ignore
    expect(problemIn([{ x: 1, y: 2, radius: 1e9 }])).toContain('[0]: ');
    expect(problemIn([{ x: 1, y: 2, width: 5, height: 5, angle: 'steep' }])).toContain('[0]: ');
  });
});
