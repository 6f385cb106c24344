import type { Memory } from '../run/values';
import type { CodePlace } from './lines';
import type { Names } from './names';

/** py/objfun.h: mp_obj_fun_bc_t; py/bc.h: mp_module_context_t. */
const FUNCTION = { context: 4, code: 12 } as const;
const CONTEXT = { globals: 4, names: 8 } as const;

/** A function's bytecode. */
export interface Code {
  /** Address of its first byte: py/bc.h, "prelude". */
  readonly start: number;
  /** `<module>` for a file, else the name after `def` or `class`, or `<lambda>` and its like. */
  readonly name: string;
  readonly file: string;
  /** Number of words for variables and stack. */
  readonly words: number;
  readonly place: CodePlace;
  /** Address of the dict of its module. */
  readonly globals: number;
}

/** Address of a function's bytecode. */
export const codeOf = (memory: Memory, functionAt: number): number => memory.word(functionAt + FUNCTION.code);

/** Reads the beginning of a function's bytecode: py/bc.h, MP_BC_PRELUDE_…_DECODE. */
export function readCode(memory: Memory, names: Names, functionAt: number): Code {
  const start = codeOf(memory, functionAt);
  const signature = readSignature(memory, start);
  const sizes = readSizes(memory, signature.end);
  const context = memory.word(functionAt + FUNCTION.context);
  const nameTable = memory.word(context + CONTEXT.names);
  const lineEnd = sizes.end + sizes.info;
  let lineStart = sizes.end;
  const name = names.of(memory.half(nameTable + 2 * readNumber(memory, lineStart)));
  for (let skipped = 0; skipped <= signature.arguments; skipped++) lineStart = afterNumber(memory, lineStart);
  return {
    start,
    name,
    file: names.of(memory.half(nameTable)),
    words: signature.words,
    place: { table: { start: lineStart, end: lineEnd }, first: lineEnd + sizes.cells },
    globals: memory.word(context + CONTEXT.globals),
  };
}

function readSignature(memory: Memory, start: number) {
  let at = start;
  let byte = memory.byte(at++);
  let words = (byte >> 3) & 0xf;
  let positional = byte & 3;
  let keywordOnly = 0;
  for (let shift = 0; (byte & 0x80) !== 0; shift++) {
    byte = memory.byte(at++);
    words |= (byte & 0x30) << (2 * shift);
    positional |= (byte & 4) << shift;
    keywordOnly |= ((byte & 8) >> 3) << shift;
  }
  return { words: words + 1, arguments: positional + keywordOnly, end: at };
}

function readSizes(memory: Memory, start: number) {
  let at = start;
  let [info, cells] = [0, 0];
  for (let shift = 0, more = true; more; shift++) {
    const byte = memory.byte(at++);
    cells |= (byte & 1) << shift;
    info |= ((byte & 0x7e) >> 1) << (6 * shift);
    more = (byte & 0x80) !== 0;
  }
  return { info, cells, end: at };
}

/** py/bc.c: mp_decode_uint. */
function readNumber(memory: Memory, start: number): number {
  let number = 0;
  for (let at = start; ; at++) {
    const byte = memory.byte(at);
    number = (number << 7) | (byte & 0x7f);
    if ((byte & 0x80) === 0) return number;
  }
}

function afterNumber(memory: Memory, start: number): number {
  let at = start;
  while ((memory.byte(at) & 0x80) !== 0) at++;
  return at + 1;
}
