import type { Memory } from '../run/values';

/** A MicroPython that stands still, as a debugger finds it: read it at once, since the next bytecode may change it. */
export interface Inspected {
  readonly memory: Memory;
  /** The board's MicroPython: 18 for 1.18. */
  readonly minor: number;
  /** The code_states of the functions that run now, outermost first: one word each, from here up to `framesEnd()`. */
  readonly framesStart: number;
  framesEnd(): number;
  /** Address of the pointer to the last pool of interned names. */
  readonly interned: number;
  /** Address of the pointer to the names of the module or class whose body runs. */
  readonly localsAt: number;
  /** The heap begins here; what lies below is the firmware's own. */
  readonly heapStart: number;
  /** The library ends here, and the program's part of the heap begins. */
  readonly programStart: number;
  /** The module, class or function whose code has this address; `undefined`: it was not compiled here. */
  scopeOf(code: number): Scope | undefined;
  /** Size of the object at an address of the heap, in bytes; 0: there is none any more. */
  sizeOf(address: number): number;
  /** All scopes that were compiled here; the code of some may be gone. */
  readonly scopes: CompiledScopes;
  /** The bytecodes before which the interpreter asks. */
  readonly marks: CodeMarks;
  /** True if it is a file on the board: its lines are the pupil's. */
  isOwnFile(name: string): boolean;
}

/** The scopes of the compiled code. */
export interface CompiledScopes {
  /** Addresses of their code. */
  readonly codes: Iterable<number>;
  /** Called with the address of each code that is compiled from now on. */
  heard: ((code: number) => void) | null;
}

/** The bytecodes before which a watch is asked. */
export interface CodeMarks {
  /** Marks all of the program's bytecodes, or none. */
  begin(all: boolean): void;
  /** Marks the addresses from the first up to, not including, the last, or takes their marks away. */
  set(from: number, to: number, isMarked: boolean): void;
}

/** The compiler's knowledge of a module, class or function. */
export interface Scope {
  readonly kind: 'module' | 'class' | 'function';
  readonly slots: readonly Slot[];
}

/** A variable's place among those of its function. */
export interface Slot {
  /** Number of its interned name. */
  readonly name: number;
  readonly place: number;
  /** True if it is shared with inner functions: the slot then contains a cell with the value in it. */
  readonly isCell: boolean;
}
