import { readCode } from './code';
import { STATE } from './frames';
import type { Inspected } from './inspected';
import type { Entry, Objects } from './objects';

/** Distinguishes the globals that a program has made itself from imported ones. */
export interface Modules {
  /** Address of the dict of the program's globals. */
  readonly program: number;
  /** Whether a global is a module, or was imported from one, that is no file of the pupil's. */
  isImported(entry: Entry): boolean;
  /** True if a module has been imported since they were read. */
  haveChanged(): boolean;
}

/**
 * Finds the modules. The outermost function that runs is ours and has the program's globals; the one that it has called
 * has imported all modules of the library (../library/internal/_boot.py).
 */
export function readModules(vm: Inspected, objects: Objects): Modules {
  const { memory } = vm;
  const globalsOfFrame = (place: number): number => {
    const functionAt = memory.word(memory.word(vm.framesStart + 4 * place) + STATE.function);
    return readCode(memory, objects.names, functionAt).globals;
  };
  const program = globalsOfFrame(0);
  const imported = new Map<number, Set<number>>();
  const addNamesOf = (module: number): void => {
    for (const [key, value] of objects.members(module, Infinity))
      imported.set(key, (imported.get(key) ?? new Set()).add(value));
  };
  const ours = objects.entries(globalsOfFrame(1), Infinity).map(([, value]) => value);
  const loaded = loadedModules(objects, ours);
  const count = loaded === null ? 0 : objects.count(loaded);
  const others = loaded === null ? [] : objects.entries(loaded, Infinity).map(([, module]) => module);
  for (const module of [...ours, ...others]) {
    if (objects.layoutOf(module) !== 'module' || objects.dictOf(module) === program) continue;
    if (!vm.isOwnFile(`${objects.moduleName(module)}.py`)) addNamesOf(module);
  }
  const isDriver = (value: number): boolean => {
    const layout = objects.layoutOf(value);
    if (layout === 'module') return !vm.isOwnFile(`${objects.moduleName(value)}.py`);
    if (layout !== 'function' || !objects.isOfPython(value)) return false;
    return !vm.isOwnFile(readCode(memory, objects.names, value).file);
  };
  return {
    program,
    haveChanged: () => loaded !== null && objects.count(loaded) !== count,
    isImported: ([key, value]) => imported.get(key)?.has(value) === true || isDriver(value),
  };
}

/** The dict of all modules that are loaded, `sys.modules`, or `null` before there is one. */
function loadedModules(objects: Objects, ours: readonly number[]): number | null {
  const isSys = (value: number): boolean => objects.layoutOf(value) === 'module' && objects.moduleName(value) === 'sys';
  const members = ours.filter(isSys).flatMap((sys) => objects.members(sys, Infinity));
  return members.find(([key]) => objects.nameText(key) === 'modules')?.[1] ?? null;
}
