import LZString from 'lz-string';
import { describe, expect, it } from 'vitest';

import { noteText } from '#project/webtigerpython/say';
import { linkSamples } from '#project/webtigerpython/testing/links';
import type { Note } from '#project/webtigerpython/note';
import { defaultScene, type Scene } from '#scene/scene';
import { documentOfAddress } from './address';
import type { CourseDocument, ProgramDocument } from './document';
import { documentOfText } from './text';
import { linkForWebTigerPython } from './link-for-webtigerpython';
import { hardwareOf } from './webtigerpython';

const none = () => null;
const packed = (value: unknown): string => encodeURIComponent(LZString.compressToBase64(JSON.stringify(value)));
const program = (text: string, more = ''): ProgramDocument => {
  const document = documentOfAddress(`?code=${packed([{ name: 'main.py', data: text }])}${more}`, none);
  return document.kind === 'program' ? document : expect.fail(document.kind);
};
const course = (value: object): CourseDocument => {
  const document = documentOfText(JSON.stringify(value), none);
  return document.kind === 'course' ? document : expect.fail(document.kind);
};
const said = (notes: readonly Note[]): readonly string[] => notes.map((note) => noteText(note, 'en'));

describe('a link of WebTigerPython', () => {
  it.each(linkSamples)('brings program and world: $name', ({ link, program: text, playground }) => {
    const document = documentOfAddress(link, none);
    const scene = playground === null ? null : course(playground).scene;
    expect(document).toMatchObject({ kind: text === '' ? 'course' : 'program', device: 'microbit-v2', scene });
    if (document.kind !== 'program') return;
    // Taken back, the lines are those that were packed.
    const lines = document.files[0]?.text.split('\n') ?? [];
    for (const { line, before } of document.rewritten) lines[line - 1] = before;
    expect(lines.join('\n')).toBe(text);
    expect(document.rewritten).toHaveLength(1);
    expect(document.notes.map(({ code }) => code)).toEqual(playground === null ? ['repeat', 'worldDamaged'] : ['repeat']);
  }); // prettier-ignore

  it('has the first public world in the place where the exercise has it: a wall 127 mm to the left of the start', () => {
    const document = documentOfAddress(linkSamples[0]!.link, none);
    expect(document).toMatchObject({
      scene: {
        ...{ name: '', size: [2000, 2000], robot: { type: null, at: [788, 811], heading: 90 } },
        objects: [{ from: [660, 746], to: [660, 1303] }, { from: [641, 1282] }, {}, { from: [414, 680], to: [1934, 680] }],
      },
    }); // prettier-ignore
  });

  it('has TigerJython’s loops in Python, and says which lines', () => {
    const { files, rewritten, notes } = program('x = 1\nrepeat 4:  # so\n    repeat:\n        x = 2\n');
    expect(files).toEqual([{ name: 'main.py', text: 'x = 1\nfor _ in range(4):  # so\n    while True:\n        x = 2\n' }]);
    expect(rewritten).toEqual([
      { file: 'main.py', line: 2, before: 'repeat 4:  # so', after: 'for _ in range(4):  # so' },
      { file: 'main.py', line: 3, before: '    repeat:', after: '    while True:' },
    ]);
    expect(said(notes)).toEqual(['TigerJython’s `repeat` now is a loop of Python, as it runs on the device (lines: 2, 3).']);
    expect(program('x = 1\n')).toMatchObject({ notes: [], rewritten: [], scene: null });
  }); // prettier-ignore

  it('has the start moved in for the robot that the program imports', () => {
    const world = { StartBox: [0, 0, 2], playgroundSize: [2000, 2000] };
    const at = ['from mbrobot import *', 'from callibot2 import *'].map((text) => {
      const { scene, notes } = program(text, `&playground=${packed(world)}`);
      expect(said(notes)[0]).toMatch(/^At \(0, 2000\) the robot lay over the edge: it now starts at \(\d+, \d+\)\.$/);
      return scene?.robot.at.join(' ');
    });
    expect(new Set(at).size).toBe(2);
    expect(program('', `&playground=${packed({ ...world, StartBox: [1000, 1000, 2] })}`).notes).toEqual([]);
  });

  it('says what its address and its world have besides', () => {
    const more = `&playground=${packed({ StartBox: [500, 500, 45], playgroundSize: [2000, 2000], Lines: [] })}&device=Oxocard&breakpoints=3`; // prettier-ignore
    expect(program('', more).notes.map(({ code }) => code)).toEqual(['startAngle', 'keys', 'device', 'parameters']);
  });
});

describe('a course file of WebTigerPython', () => {
  const world = { StartBox: [500, 600, 2], Blockobjects: [[300, 300, true, 0]], playgroundSize: [2000, 1000] };

  it('is a course, whatever it is called: its keys tell', () => {
    expect(course(world)).toMatchObject({ device: null, notes: [], scene: { size: [2000, 1000], robot: { heading: 0 } } }); // prettier-ignore
    for (const value of [{ ...world, format: 'parcours-scene' }, [world], { world }])
      expect(documentOfText(JSON.stringify(value), none).kind).toBe('unreadable');
  });

  it('has its start moved in for the usual robot', () => {
    expect(said(course({ ...world, StartBox: [-9, 500, 0] }).notes)[0]).toMatch(/^At \(-9, 500\)/);
  });
});

describe('a project for WebTigerPython', () => {
  const files = [{ name: 'main.py', text: 'from mbrobot import *\n' }];
  const scene: Scene = { ...defaultScene(), objects: [{ type: 'wall', id: 'wall-1', from: [0, 0], to: [90, 0], thickness: 10 }] }; // prettier-ignore

  it('comes back as it was', () => {
    const made = linkForWebTigerPython({ files, scene });
    expect(made?.notes).toEqual([]);
    expect(documentOfAddress(made?.link ?? '', none)).toMatchObject({ files, scene, device: 'microbit-v2', notes: [] });
  });

  it('tells that there its robot is not simulated', () => {
    const mine = [{ name: 'main.py', text: 'from callimk import *\n' }];
    expect(linkForWebTigerPython({ files: mine, scene })?.notes).toEqual([
      { code: 'robotAbsent', params: { robot: 'motionkit-2' } },
    ]);
  });

  it('tells that its robot is none that the imports mean', () => {
    const robot = { ...scene.robot, type: 'callibot' };
    expect(linkForWebTigerPython({ files, scene: { ...scene, robot } })?.notes.map(({ code }) => code)).toEqual(['robotType']); // prettier-ignore
    expect(hardwareOf({ files, scene })).toMatchObject({ robot: { id: 'maqueen-lite' }, board: { id: 'microbit-v2' } });
  });
});
