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
  /** The slots of a function's variables, by the address of its code; `undefined`: not compiled here. */
  scopeOf(code: number): Scope | undefined;
  /** The bytes of the object at an address of the heap; 0: there is none any more. */
  sizeOf(address: number): number;
  /** All that were compiled here; some may be gone. */
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
  /** Hears of the code of each that is compiled from now on; `null`: nobody does. */
  heard: ((code: number) => void) | null;
}

/** The bytecodes before which a watch is asked. */
export interface CodeMarks {
  /** Marks all of the program's, or none. */
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
  /** It is shared with inner functions: the slot holds the cell that holds it. */
  readonly isCell: boolean;
}
