import { linkOf } from '../src/project/link/link';
import { defaultScene } from '../src/scene/scene';

/** A link that a teacher has handed out: drive straight on into a field. @param more of the task, such as an exam */
export function classLink(more: object = {}): string {
  const field = { type: 'target', id: 't', at: [560, 250], size: [200, 200], angle: 0, round: true, number: 0, blocks: 0 } as const; // prettier-ignore
  const scene = { ...defaultScene(), size: [900, 500] as const, objects: [field] };
  const robot = { ...scene.robot, at: [150, 250] as const };
  const task = { version: 1, handedOut: true, checks: [{ type: 'goals', id: 'goals' }], ...more };
  const files = [{ name: 'main.py', text: 'from mbrobot import *\n' }];
  const made = linkOf(
    { files, scene: { ...scene, robot }, course: null, task },
    { courses: () => null, program: true },
  );
  if (made === null) throw new Error('There is no link.');
  return `./#${made.fragment}`;
}
