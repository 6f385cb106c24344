import { codeOf, readCode, lineAt, type Code } from './code';
import type { Inspected } from './inspected';
import { Names } from './names';

/** py/bc.h: mp_code_state_t. */
export const STATE = { function: 0, at: 4, slots: 20 } as const;

/** A function of the pupil's that runs. */
export interface Frame {
  /** Address of its code_state. */
  readonly state: number;
  readonly code: Code;
  readonly line: number;
}

/** Where a program is: in the innermost of its own functions. */
export interface Position {
  readonly file: string;
  readonly line: number;
  /** How many of the pupil's functions have called each other to get here; 0 in the program itself. */
  readonly depth: number;
}

/** The pupil's functions that run now, innermost first. Those of the library and of robot drivers that are no file of theirs are left out. */
export function readFrames(vm: Inspected, names = new Names(vm.memory, vm.interned)): readonly Frame[] {
  const { memory } = vm;
  const found: Frame[] = [];
  for (let at = vm.framesEnd() - 4; at >= vm.framesStart; at -= 4) {
    const state = memory.word(at);
    const code = ownCode(vm, names, state);
    if (code) found.push({ state, code, line: lineAt(memory, code, memory.word(state + STATE.at)).line });
  }
  return found;
}

/** Where the program is, or `null` while none of the pupil's functions runs. */
export function readPosition(vm: Inspected, names?: Names): Position | null {
  const frames = readFrames(vm, names);
  const [innermost] = frames;
  return innermost ? { file: innermost.code.file, line: innermost.line, depth: frames.length - 1 } : null;
}

/** The code that a code_state runs, or `null` if it is not the pupil's. */
export function ownCode(vm: Inspected, names: Names, state: number): Code | null {
  const { memory } = vm;
  const functionAt = memory.word(state + STATE.function);
  if (codeOf(memory, functionAt) < vm.programStart) return null;
  const code = readCode(memory, names, functionAt);
  return vm.isOwnFile(code.file) ? code : null;
}
