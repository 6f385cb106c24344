import type { Memory } from '../run/values';

/** A bytecode: its place, its kind, and the address to which it may jump. */
export interface Instruction {
  readonly at: number;
  /** Address of the one after it. */
  readonly next: number;
  readonly kind:
    | 'jump'
    | 'jump-if-true'
    | 'small-int'
    | 'add-in-place'
    | 'return'
    /** The generator resumes at the next instruction. */
    | 'yield'
    /** The generator goes on with the same bytecode. */
    | 'yield-from'
    /** `target` is where an exception, a `return` or the end of a loop leads to. */
    | 'handler'
    | 'other';
  /** The address to which it may lead instead of `next`; `null`: it has none. */
  readonly target: number | null;
}

/** py/bc0.h: MP_BC_FORMAT, MP_BC_MASK_EXTRA_BYTE, MP_BC_LOAD_CONST_SMALL_INT_MULTI_NUM. */
const FORMATS = 0x3a4;
const EXTRA_BYTE = 0x9e;
const Format = { BYTE: 0, NAME: 1, NUMBER: 2, OFFSET: 3 } as const;
const OP = {
  unwindJump: 0x40,
  jump: 0x42,
  jumpIfTrue: 0x43,
  jumpIfFalse: 0x44,
  setupWith: 0x47,
  setupExcept: 0x48,
  setupFinally: 0x49,
  smallInt: 0x22,
  return: 0x63,
  yieldValue: 0x67,
  yieldFrom: 0x68,
} as const;
const SMALL_INTS = { first: 0x70, end: 0xb0 } as const;
/** py/runtime0.h: MP_BC_BINARY_OP_MULTI + MP_BINARY_OP_INPLACE_ADD. */
const ADD_IN_PLACE = 0xd7 + 14;
/** The bytecodes whose offset is a signed number; all others lead forward. */
const SIGNED: readonly number[] = [OP.unwindJump, OP.jump, OP.jumpIfTrue, OP.jumpIfFalse];

/** The bytecodes of a function up to the return beyond which nothing leads: what follows is never run. */
export function readInstructions(memory: Memory, first: number): readonly Instruction[] {
  const found: Instruction[] = [];
  let furthest = first;
  for (let at = first; ;) {
    const instruction = readInstruction(memory, at);
    found.push(instruction);
    furthest = Math.max(furthest, instruction.target ?? 0);
    at = instruction.next;
    if (instruction.kind === 'return' && furthest < at) return found;
  }
}

function readInstruction(memory: Memory, at: number): Instruction {
  const op = memory.byte(at);
  const format = (FORMATS >> (2 * (op >> 4))) & 3;
  const extra = (op & EXTRA_BYTE) === 0 && format !== Format.BYTE ? 1 : 0;
  let next = at + 1;
  let target: number | null = null;
  if (format === Format.NAME || format === Format.NUMBER) {
    while ((memory.byte(next) & 0x80) !== 0) next++;
    next += 1 + extra;
  } else if (format === Format.OFFSET) {
    const [low, high] = [memory.byte(next), memory.byte(next + 1)];
    const isLong = (low & 0x80) !== 0;
    next += isLong ? 2 : 1;
    const raw = isLong ? (low & 0x7f) | (high << 7) : low;
    const offset = SIGNED.includes(op) ? raw - (isLong ? 0x4000 : 0x40) : raw;
    target = next + offset;
    next += extra;
  }
  return { at, next, kind: kindOf(op), target };
}

const KINDS: ReadonlyMap<number, Instruction['kind']> = new Map<number, Instruction['kind']>([
  [OP.jump, 'jump'],
  [OP.jumpIfTrue, 'jump-if-true'],
  [OP.return, 'return'],
  [OP.yieldValue, 'yield'],
  [OP.yieldFrom, 'yield-from'],
  [OP.unwindJump, 'handler'],
  [OP.setupWith, 'handler'],
  [OP.setupExcept, 'handler'],
  [OP.setupFinally, 'handler'],
]);

function kindOf(op: number): Instruction['kind'] {
  const kind = KINDS.get(op);
  if (kind !== undefined) return kind;
  if (op === OP.smallInt || (op >= SMALL_INTS.first && op < SMALL_INTS.end)) return 'small-int';
  return op === ADD_IN_PLACE ? 'add-in-place' : 'other';
}
