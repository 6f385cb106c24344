import type { Memory } from '../run/values';
import type { Scope, Slot } from './inspected';

/** py/scope.h: scope_t and id_info_t. */
const SCOPE = { kind: 0, rawCode: 16, count: 40, names: 44 } as const;
const NAME = { kind: 0, flags: 1, slot: 2, name: 4, bytes: 8 } as const;
const KINDS = ['module', 'class'] as const; // all others are functions of some sort
/** py/emitglue.h: mp_raw_code_t. */
const CODE_OF_RAW_CODE = 4;

const LOCAL = 4; // py/scope.h: ID_INFO_KIND_…
const CELL = 5;
const FREE = 6;
const IS_PARAMETER = 1;

/**
 * The names of local variables. MicroPython's bytecode has only numbers for them; the compiler reports the names of a
 * scope when it has finished it. Nothing is read again, and nothing is stored in Python's memory.
 */
export class Scopes {
  /** Called with the address of the code of each scope that is compiled. */
  heard: ((code: number) => void) | null = null;
  private readonly byCode = new Map<number, Scope>();

  constructor(private readonly memory: Memory) {}

  /** All that was compiled, by the addresses of the code. */
  get all(): ReadonlyMap<number, Scope> {
    return this.byCode;
  }

  /** Takes over the scopes of another VM, of whose memory this one is a copy. */
  know(scopes: ReadonlyMap<number, Scope>): void {
    for (const [code, scope] of scopes) this.byCode.set(code, scope);
  }

  /** The addresses of all code that was compiled. */
  get codes(): Iterable<number> {
    return this.byCode.keys();
  }

  of(code: number): Scope | undefined {
    return this.byCode.get(code);
  }

  /** Reads a scope_t that was compiled. */
  add(scope: number): void {
    const code = this.memory.word(this.memory.word(scope + SCOPE.rawCode) + CODE_OF_RAW_CODE);
    if (code === 0) return; // the compiler has met an error
    this.byCode.set(code, this.read(scope));
    this.heard?.(code);
  }

  private read(scope: number): Scope {
    const { memory } = this;
    const names = memory.word(scope + SCOPE.names);
    const slots: Slot[] = [];
    for (let index = 0; index < memory.half(scope + SCOPE.count); index++) {
      const at = names + index * NAME.bytes;
      const kind = memory.byte(at + NAME.kind);
      const isParameter = (memory.byte(at + NAME.flags) & IS_PARAMETER) !== 0;
      if (kind !== LOCAL && kind !== CELL && kind !== FREE && !isParameter) continue;
      const isCell = kind === CELL || kind === FREE;
      slots.push({ name: memory.word(at + NAME.name), place: memory.half(at + NAME.slot), isCell });
    }
    return { kind: KINDS[memory.word(scope + SCOPE.kind)] ?? 'function', slots };
  }
}
