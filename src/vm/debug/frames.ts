import type { Memory } from '../run/values';
import { codeOf, readCode, type Code } from './code';
import type { Inspected, Scope } from './inspected';
import { readInstructions } from './instructions';
import { rangeAt, readLines, type LineRange } from './lines';
import { Names } from './names';

/** py/bc.h: mp_code_state_t. */
export const STATE = { function: 0, at: 4, slots: 20 } as const;

/** The code of a function of the pupil's, with the lines of its bytecodes. */
export interface OwnCode extends Code {
  readonly lines: readonly LineRange[];
  /** The addresses where its generators resume: after a `yield`. */
  readonly resumes: ReadonlySet<number>;
  /** The addresses of its `yield from`, where its generators go on with the same bytecode. */
  readonly delegates: ReadonlySet<number>;
}

/** A function of the pupil's that runs. */
export interface Frame {
  /** Address of its code_state. */
  readonly state: number;
  readonly code: OwnCode;
  readonly line: number;
}

/** The place of a program: in the innermost of its own functions. */
export interface Position {
  readonly file: string;
  readonly line: number;
  /** How many of the pupil's functions have called each other to get here; 0 in the program itself. */
  readonly depth: number;
}

/** The pupil's functions that run now, innermost first, without those of the library and of built-in drivers. */
export function readFrames(vm: Inspected, names = new Names(vm.memory, vm.interned)): readonly Frame[] {
  const { memory } = vm;
  const found: Frame[] = [];
  for (let at = vm.framesEnd() - 4; at >= vm.framesStart; at -= 4) {
    const state = memory.word(at);
    const code = ownCode(vm, names, state);
    if (code) found.push({ state, code, line: rangeAt(code.lines, memory.word(state + STATE.at)).line });
  }
  return found;
}

/** The place of the program, or `null` while none of the pupil's functions runs. */
export function readPosition(vm: Inspected, names?: Names): Position | null {
  const frames = readFrames(vm, names);
  const [innermost] = frames;
  return innermost ? { file: innermost.code.file, line: innermost.line, depth: frames.length - 1 } : null;
}

/** The code of each scope. It is read once, as it does not change: code compiled later has a scope of its own. */
const known = new WeakMap<Scope, OwnCode>();

/** The code that a code_state runs, or `null` if it is not the pupil's. */
export function ownCode(vm: Inspected, names: Names, state: number): OwnCode | null {
  const { memory } = vm;
  const functionAt = memory.word(state + STATE.function);
  const scope = vm.scopeOf(codeOf(memory, functionAt));
  if (scope === undefined) return null;
  const before = known.get(scope);
  const code = before ?? withLines(memory, readCode(memory, names, functionAt));
  if (before === undefined) known.set(scope, code);
  return vm.isOwnFile(code.file) ? code : null;
}

/**
 * True if a call begins at this address or a generator goes on there: then its line begins, too.
 *
 * @param before address of the function's bytecode before it; `at` itself if there was none, or if it is repeated
 */
export const entersLine = ({ place, resumes, delegates }: OwnCode, at: number, before: number): boolean =>
  at === place.first || resumes.has(at) || (at === before && delegates.has(at));

function withLines(memory: Memory, code: Code): OwnCode {
  const instructions = readInstructions(memory, code.place.first);
  const of = (wanted: string) => instructions.filter(({ kind }) => kind === wanted);
  return {
    ...code,
    lines: readLines(memory, code.place),
    resumes: new Set(of('yield').map(({ next }) => next)),
    delegates: new Set(of('yield-from').map(({ at }) => at)),
  };
}
