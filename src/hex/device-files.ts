import { MAIN, type SourceFile } from '#project/project';
import { boardTypes } from '#board/boards/index';
import { importedModules } from '#python/imports';
import { freeLibraries } from '#libraries/index';
import { allLibraries, robotOwnLibraries } from './libraries';
import type { HexFile } from './hex';
import { STAND_IN } from './stand-in';

/** The files that a program consists of on a real board. */
export interface DeviceFiles {
  /** Libraries first, then the pupil's own files, main.py last. */
  readonly files: readonly (HexFile & { readonly isOwn: boolean })[];
  /** Firmware modules that they need: one from each list. */
  readonly modules: readonly (readonly string[])[];
}

/**
 * The Calliope mini's module has had two names: its current firmware knows only the first, our libraries use the
 * second.
 */
const CALLIOPE = ['calliopemini', 'calliope_mini'] as const;

/**
 * The pupil's files and the libraries that they import, directly or indirectly: everything for a board that has only
 * MicroPython.
 *
 * @param robot id of the robot that the program drives, or `null`; a library that can drive several brings along the
 *   library of this one alone, since a board has no room for all
 */
export function filesForDevice(own: readonly SourceFile[], robot: string | null): DeviceFiles {
  const offered = allLibraries(robot);
  const forLibraries = { ...freeLibraries, ...(robot === null ? {} : robotOwnLibraries(robot)) };
  const names = new Set(own.map(({ name }) => name));
  const libraries = new Map<string, string>();
  const modules = new Set<string>();
  const boardModules = new Set(boardTypes.flatMap((type) => type.modules));
  const visit = (source: string, known: Readonly<Record<string, string>>): void => {
    for (const module of importedModules(source)) {
      const name = `${module}.py`;
      const text = known[name];
      if (names.has(name) || libraries.has(name)) continue;
      if (boardModules.has(module)) modules.add(module);
      else if (text !== undefined) {
        libraries.set(name, text);
        visit(text, forLibraries);
      }
    }
  };
  for (const { name, text } of own) if (name.endsWith('.py')) visit(text, offered);
  if (modules.has('calliope_mini')) libraries.set(STAND_IN.name, STAND_IN.text);
  const rank = (name: string): number => (name === MAIN ? 1 : 0);
  return {
    files: [
      ...Array.from(libraries, ([name, text]) => ({ name, text, isOwn: false })),
      ...own.map((file) => ({ ...file, isOwn: true })).sort((a, b) => rank(a.name) - rank(b.name)),
    ],
    modules: neededModules(modules),
  };
}

/** One list for each board whose modules are needed. */
function neededModules(modules: ReadonlySet<string>): readonly (readonly string[])[] {
  const isCalliope = CALLIOPE.some((name) => modules.has(name));
  const others = Array.from(modules).filter((name) => !CALLIOPE.some((known) => known === name));
  return [...(isCalliope ? [CALLIOPE] : []), ...others.map((name) => [name])];
}
