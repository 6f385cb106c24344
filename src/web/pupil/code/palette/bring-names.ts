import { Reference } from '#reference/meaning';
import { namesOf } from '#python/scopes';
import { readPython, textOf } from '#python/tree';

import { importLine } from '../../console/advice/import-line';
import { robotModules } from '../../console/advice/robot-modules';
import { contextOf, type Written } from '../../../session/work/hardware/written-for';
import type { PaletteCommand } from './commands';

/** A command as a program can take it. */
export interface Brought {
  /** Its template, with the names as the program knows them: `robot.forward()` after `import mbrobot as robot`. */
  readonly code: string;
  /** The imports that the program lacks for it: `from mbrobot import *`. */
  readonly imports: readonly string[];
}

/** Finds out what a program needs before it can take a command, on the chosen board and robot. */
export function bringNames(
  { code, needs }: Pick<PaletteCommand, 'code' | 'needs'>,
  text: string,
  written: Written,
): Brought {
  const program = readPython(text);
  const { root, imports: present } = namesOf(program);
  const reference = new Reference(contextOf(written));
  const imports = new Set<string>();
  let brought = code;
  for (const name of needs) {
    const isStarred = root.stars.some((module) => reference.module(module)?.names().has(name));
    if (isStarred || root.names.some((it) => it.name === name)) continue;
    const found = importLine(name, reference, robotModules(written));
    if (found === null) continue;
    const whole = present.find(({ module, symbol }) => module === found.module && symbol === null)?.nameNode;
    if (!whole) imports.add(found.code);
    else brought = called(brought, name, textOf(program, whole), found.module);
  }
  return { code: brought, imports: [...imports] };
}

/** The code with a name put after the name of its module in the program; for the module itself, that name. */
const called = (code: string, name: string, alias: string, module: string): string =>
  code.replace(new RegExp(`(^|[^\\w.])${name}\\b`, 'g'), `$1${name === module ? alias : `${alias}.${name}`}`);
