import { linkOf, projectOfLink } from '#project/link/link';
import { defaultScene } from '#scene/scene';

import type { Print } from './example';

/** project: a program and its course as a link, and back. */
export function main(print: Print): void {
  const files = [{ name: 'main.py', text: 'from mbrobot import *\nforward()\n' }];
  const link = linkOf({ files, scene: defaultScene(), course: null }, { courses: () => null, program: true });
  if (link === null) return;
  const read = projectOfLink(link.fragment, () => null);
  print('project' in read ? read.project.files.map(({ text }) => text.trim()).join('') : read.problem.code);
  const damaged = projectOfLink(`${link.fragment.slice(0, -4)}AAAA`, () => null);
  print('project' in damaged ? 'opened' : damaged.problem.code);
}
