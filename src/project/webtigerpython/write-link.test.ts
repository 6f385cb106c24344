import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';

import { defaultProjectSettings, newWork, type SourceFile } from '../project';
import { programOfLink } from './program-link';
import { noteText } from './say';
import { linkSamples } from './testing/links';
import { programLinkOf, type Linked, type LinkedHardware } from './write-link';

const files: readonly SourceFile[] = [{ name: 'main.py', text: 'print("ü+/")\n' }, { name: 'drive.py', text: 'x = 1\n' }]; // prettier-ignore
const hardware: LinkedHardware = { device: 'microbit-v2', robot: 'maqueen-lite', meant: 'maqueen-lite' };
const made = (project: Partial<Linked>, other: Partial<LinkedHardware> = {}) =>
  programLinkOf({ files, scene: defaultScene(), ...project }, { ...hardware, ...other });
const said = (project: Partial<Linked>, other: Partial<LinkedHardware> = {}): readonly string[] =>
  (made(project, other)?.notes ?? []).map((one) => noteText(one, 'en'));
const scene = (objects: readonly SceneObject[], more: Partial<Scene> = {}): Partial<Linked> => ({
  scene: { ...defaultScene(), objects, ...more },
});
const box = { id: 'x', at: [300, 300], size: [50, 50], angle: 0 } as const;

describe('a link for WebTigerPython', () => {
  it('holds files, microcomputer and course, as its share button writes them', () => {
    const link = made({})?.link ?? '';
    expect(link).toMatch(/^https:\/\/webtigerpython\.ethz\.ch\/#\?code=[\w-]+&device=micro%3Abit&playground=[\w%]+$/);
    expect(programOfLink(link)).toMatchObject({ files, device: 'microbit-v2', world: { scene: defaultScene() }, notes: [] }); // prettier-ignore
    expect(made({ scene: null })?.link).not.toContain('playground');
    expect(made({}, { device: 'calliope-mini-2' })?.link).toContain('&device=Calliope%20mini%201%2F2&');
  });

  it.each(linkSamples.filter(({ playground }) => playground !== null))('is read like the one it was read from: $name', ({ link }) => {
    const read = programOfLink(link);
    if ('problem' in read || read.world === null) throw new Error('This is a world.');
    const again = made({ files: read.files, scene: read.world.scene });
    expect(again?.notes).toEqual([]);
    expect(programOfLink(again?.link ?? '')).toEqual(read);
  }); // prettier-ignore

  it('is not made when it would be longer than one that is read', () => {
    const rng = createRng(1);
    const text = Array.from({ length: 250_000 }, () => String.fromCharCode(0x4e00 + (rng.u32() % 20_000))).join('');
    expect(made({ files: [{ name: 'main.py', text }] }) === null).toBe(true);
  });
});

describe('what a link for WebTigerPython cannot hold', () => {
  const wall = { type: 'wall', id: 'w', from: [0, 0], to: [100, 0], thickness: 10 } as const;
  it.each<[string, Partial<Linked>, string]>([
    ['lines', scene([{ type: 'stroke', id: 's', points: [[1, 2]], width: 9, color: 'red' }]), 'Lines on the floor are left out (1).'],
    ['fields', scene([{ ...box, type: 'target', round: true, number: 0, blocks: 0 }, { ...box, type: 'forbidden', round: true, number: 0, blocks: 0 }]), 'Zones (targets, checkpoints, forbidden ones) are left out (2).'],
    ['spikes', scene([{ ...box, type: 'spikes' }]), 'Spikes are left out (1).'],
    ['moving blocks', scene([{ ...box, type: 'mover', to: [1, 2], speed: 9, spiked: false }]), 'Moving blocks are left out (1).'],
    ['texts', scene([{ type: 'label', id: 'l', at: [1, 2], text: 'A', height: 9, angle: 0 }]), 'Texts on the floor are left out (1).'],
    ['starts', scene([{ type: 'start', id: 's', at: [1, 2], heading: 0, robot: null, options: {}, name: '', color: null }]), 'Starts of further robots are left out (1).'],
    ['slanting walls', scene([{ ...wall, to: [100, 20] }]), 'Slanting walls are turned to the nearest multiple of 45° (1).'],
    ['thick walls', scene([{ ...wall, thickness: 30 }, wall]), 'Walls lose their thickness: there all have the same, here 10 mm (1).'],
    ['slanting blocks', scene([{ ...box, type: 'block', angle: 20 }]), 'Slanting blocks are turned to the nearest multiple of 45° (1).'],
    ['blocks of another size', scene([{ ...box, type: 'fixed-block', size: [50, 60] }]), 'Blocks lose their size: there all have the same, here 50 × 50 mm (1).'],
    ['round blocks', scene([{ ...box, type: 'block', round: true }]), 'Round blocks and polygons become squares (1).'],
    ['polygons', scene([{ ...box, type: 'block', corners: [[0, 0], [9, 0], [0, 9]] }]), 'Round blocks and polygons become squares (1).'],
    ['heights', scene([{ ...wall, height: 30 }]), 'Heights are left out (1).'],
    ['locks', scene([{ ...wall, lock: true }]), 'Locks and groups of the editor are left out (1).'],
    ['a slanting start', scene([], { robot: { ...defaultScene().robot, heading: 100 } }), 'The robot starts at 90° instead of 100°: there these are multiples of 45°.'],
    ['a large robot', scene([], { robot: { ...defaultScene().robot, scale: 1.5 } }), 'The robot’s size is left out (1.5 times the real one’s).'],
    ['a robot with a name', scene([], { robot: { ...defaultScene().robot, name: 'Eva' } }), 'The robot’s name and colour are left out.'],
    ['options of the robot', scene([], { robot: { ...defaultScene().robot, options: { S1: 'claw' } } }), 'What is plugged into the robot and set on it is left out (1).'],
    ['a task', scene([], { task: { seconds: 9, noTouch: false } }), 'The task is left out: time, rules and card.'],
    ['a task for a class', { task: { version: 1 } }, 'The task is left out: time, rules and card.'],
    ['a picture on the floor', scene([], { background: { at: [0, 0], size: [9, 9], cells: [1, 1], levels: '', picture: '' } }), 'The picture on the floor is left out.'],
    ['a name', scene([], { name: 'Hall' }), 'Name and description of the course are left out.'],
    ['several devices', { devices: { first: 'a', others: [{ name: 'b', sameAs: '', files, device: 'auto', firmware: '', robot: 'auto', robotOptions: {} }] } }, 'Only the first of the 2 devices comes along.'],
    ['settings of the run', { settings: { ...defaultProjectSettings, ...newWork, reality: 1 } }, 'Settings of the run are left out: wear, random seed, firmware, own robot.'],
  ])('%s: told before', (_, project, sentence) => expect(said(project)).toEqual([sentence])); // prettier-ignore

  it('a robot that the imports do not mean, and a strange microcomputer: told before', () => {
    expect(said({}, { robot: 'callibot' })).toEqual(['There the program’s imports decide which robot drives, and they do not mean callibot.']); // prettier-ignore
    expect(said({}, { device: 'xy' })).toEqual(['WebTigerPython has no microcomputer xy: the link names none.']);
    expect(
      said({ settings: { ...defaultProjectSettings, ...newWork, device: 'microbit-v2', robot: 'maqueen-lite' } }),
    ).toEqual([]);
  });

  it('is the nearest that it can: a slanting wall keeps middle and length', () => {
    const read = programOfLink(made(scene([{ ...wall, to: [80, 60] }]))?.link ?? '');
    expect(read).toMatchObject({ world: { scene: { objects: [{ from: [5, -5], to: [75, 65] }] } } });
  });
});
