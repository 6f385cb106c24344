import { readFrames, STATE, type Frame } from './frames';
import type { Inspected } from './inspected';
import { readModules, type Modules } from './modules';
import { Names } from './names';
import { Objects, type Entry } from './objects';
import { show, USUAL_BOUNDS, type Bounds, type Shown } from './shown';

/** A variable by its name. */
export interface Variable {
  readonly name: string;
  readonly value: Shown;
}

/** A function of the pupil's that runs, with its variables; for a file, which has only globals, there are none. */
export interface StackEntry {
  /** `<module>` for a file. */
  readonly function: string;
  readonly file: string;
  readonly line: number;
  readonly locals: readonly Variable[];
}

/** All that a debugger shows of a program that stands still. */
export interface Variables {
  /** Innermost first. */
  readonly stack: readonly StackEntry[];
  /** The names of the innermost function's file that the program has made itself; after the end those of the program. */
  readonly globals: readonly Variable[];
}

/** Reads the stack and the variables from memory: nothing runs, nothing is allocated, no time passes. */
export const readVariables = (vm: Inspected, bounds: Bounds = USUAL_BOUNDS): Variables => variablesReader(vm, bounds)();

/**
 * Reads the variables again and again; the modules are read again only after another one has been imported.
 *
 * @param vm the MicroPython to read; after a reset of the board it is another one
 */
export function variablesReader(vm: Inspected, bounds: Bounds = USUAL_BOUNDS): () => Variables {
  const names = new Names(vm.memory, vm.interned);
  const reader = { vm, bounds, objects: new Objects(vm, names) };
  let modules: Modules | null = null;
  return () => {
    const frames = readFrames(vm, names);
    const inBody = frames.find(({ code }) => vm.scopeOf(code.start)?.kind !== 'function');
    const stack = frames.map((frame) => ({
      function: frame.code.name,
      file: frame.code.file,
      line: frame.line,
      locals: localsOf(reader, frame, frame === inBody),
    }));
    if (modules === null || modules.haveChanged()) modules = readModules(vm, reader.objects);
    return { stack, globals: globalsOf(reader, frames[0]?.code.globals ?? modules.program, modules) };
  };
}

interface Reader {
  readonly vm: Inspected;
  readonly bounds: Bounds;
  readonly objects: Objects;
}

/** @param isCurrent it is the innermost body of a class or file: the names that it has made so far are known */
function localsOf(reader: Reader, frame: Frame, isCurrent: boolean): readonly Variable[] {
  const scope = reader.vm.scopeOf(frame.code.start);
  if (scope?.kind === 'class') return isCurrent ? classBody(reader) : [];
  if (scope?.kind !== 'function') return [];
  const { memory } = reader.vm;
  const top = frame.state + STATE.slots + 4 * (frame.code.words - 1);
  const found: Variable[] = [];
  for (const { name, place, isCell } of scope.slots) {
    const slot = memory.word(top - 4 * place);
    const value = isCell && slot !== 0 ? memory.word(slot + CELL_CONTENT) : slot;
    const text = reader.objects.names.of(name);
    // 0: not set yet. The source of a comprehension has a slot without a name.
    if (value !== 0 && text !== '') found.push({ name: text, value: show(reader.objects, value, reader.bounds) });
  }
  return found;
}

const CELL_CONTENT = 4; // py/objcell.c

function classBody({ vm, objects, bounds }: Reader): readonly Variable[] {
  const entries = objects.entries(vm.memory.word(vm.localsAt), bounds.parts);
  return entries.map(([key, value]) => variable(objects, bounds, key, value)).filter(isOwnName);
}

function globalsOf({ objects, bounds }: Reader, dict: number, modules: Modules): readonly Variable[] {
  const own = (entry: Entry): boolean => !modules.isImported(entry);
  const entries = objects.entries(dict, Infinity).filter(own).slice(0, MOST_GLOBALS);
  return entries.map(([key, value]) => variable(objects, bounds, key, value)).filter(isOwnName);
}

/** Most globals shown. Chosen: a program has a dozen; one that makes them in a loop should not fill the page. */
const MOST_GLOBALS = 500;

const variable = (objects: Objects, bounds: Bounds, key: number, value: number): Variable => ({
  name: objects.nameText(key),
  value: show(objects, value, bounds),
});

/** True for a name that the program has written: not `__name__`, `__module__` or `__qualname__`. */
const isOwnName = ({ name }: Variable): boolean => !name.startsWith('__');
